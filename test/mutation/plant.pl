# Plants faults in a copy of the project: plant.pl FAULTS FOLDER. Expressions become a choice between two, statements too.
use strict;
use warnings;
my ($faults, $folder) = @ARGV;
open(my $list, '<', $faults) or die "$faults: $!";
while (my $line = <$list>) {
  next if $line =~ /^#/;
  chomp $line;
  my ($number, $file, $old, $new) = split /\t/, $line;
  open(my $in, '<', "$folder/$file") or die "$file: $!";
  my $text = do { local $/; <$in> };
  close $in;
  my $found = () = $text =~ /\Q$old\E/g;
  die "fault $number: '$old' stands $found times in $file\n" if $found != 1;
  my $both = $old =~ /;$/ ? "{ if (planted($number)) { $new } else { $old } }" : "(planted($number) ? ($new) : ($old))";
  $text =~ s/\Q$old\E/$both/;
  open(my $out, '>', "$folder/$file") or die "$file: $!";
  print $out $text;
  close $out;
}
