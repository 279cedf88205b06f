// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong around the program: paths that lead to one file, streams that are full or closed, signals.
#include <boost/test/unit_test.hpp>

#include "support/run_program.h"
#include "support/sample_surfaces.h"
#include "support/written_meshes.h"

#include <zlib.h>

#include <cstdint>
#include <random>

using namespace meridian;
using written::contains;
using written::obj;

namespace {

struct Fixture : program::Workplace
{
  Fixture() { write("mesh.obj", obj(sample::torus(12, 8))); }
};

} // namespace

// Whatever a command reads, it does not write over: not under the same name, nor by a link of either kind.
BOOST_FIXTURE_TEST_CASE(no_output_is_an_input, Fixture)
{
  BOOST_REQUIRE(meridian("unwrap mesh.obj -o result.obj").status == 0);
  BOOST_REQUIRE(shell("mkdir sub; for f in mesh.obj result.obj result.map.json; do ln $f hard-$f; ln -s $f soft-$f; "
                      "ln -s ../$f sub/$f; done")
                  .status
                == 0);
  const std::size_t files = number_of_files();
  const std::vector<std::string> inputs{"mesh.obj", "result.obj", "result.map.json"};
  std::vector<std::string> before;
  for (const std::string& input : inputs) { before.push_back(program::read(folder() / input)); }
  for (const std::string& input : inputs)
    for (const char* form : {"", "./", "hard-", "soft-", "sub/", "sub/../"})
      for (const char* command :
           {"verify mesh.obj result.obj --report ", "compare mesh.obj --cut result.obj --cut 0 --report ",
            "info mesh.obj result.obj --report ", "cut mesh.obj -o ", "unwrap mesh.obj -o new.obj --report "})
      {
        const bool is_read = input == "mesh.obj" || std::string(command).find("result") != std::string::npos;
        const bool is_map = input == "result.map.json" && std::string(command).find("info") == 0;
        if (!is_read || is_map) { continue; }
        const auto r = meridian(command + (form + input));
        BOOST_TEST(r.status == 64, command << form << input << ": " << r.error);
        BOOST_TEST(contains(r.error, "give every file a name of its own"));
      }
  for (std::size_t i = 0; i < inputs.size(); ++i) { BOOST_TEST((program::read(folder() / inputs[i]) == before[i])); }
  BOOST_TEST(number_of_files() == files);
}

BOOST_FIXTURE_TEST_CASE(no_two_outputs_are_one_file, Fixture)
{
  BOOST_REQUIRE(shell("echo old >one.json; ln one.json two.json; ln -s nowhere.json dangling.json").status == 0);
  BOOST_TEST(meridian("cut mesh.obj -o out.obj --report one.json --view two.json").status == 64);
  BOOST_TEST(meridian("cut mesh.obj -o out.obj --report nowhere.json --view dangling.json").status == 64);
  BOOST_TEST(program::read(folder() / "one.json") == "old\n");
  BOOST_TEST(number_of_files() == 3u);
  // where a link leads to nothing yet, that is what is written
  BOOST_TEST(meridian("info mesh.obj --report dangling.json").status == 0);
  BOOST_TEST(program::fs::is_symlink(folder() / "dangling.json"));
  BOOST_TEST(contains(program::read(folder() / "nowhere.json"), "\"genus\": 1"));
}

BOOST_FIXTURE_TEST_CASE(paths_that_cannot_be_are_said_to_be_so, Fixture)
{
  BOOST_REQUIRE(shell("ln -s round.json round.json").status == 0);
  for (const std::string& path : {std::string(300, 'x') + ".json", std::string("round.json"), std::string("mesh.obj/r"),
                                  std::string("/dev/null"), std::string("no/such/folder/r.json")})
  {
    const auto r = meridian("info mesh.obj --report " + path);
    BOOST_TEST(r.status == 1, path);
    BOOST_TEST(r.error.find("meridian: " + path + ": ") == 0u, r.error);
    BOOST_TEST(!contains(r.error, "internal error"));
    BOOST_TEST(r.out == "");
  }
}

BOOST_FIXTURE_TEST_CASE(streams_are_no_meshes, Fixture)
{
  const auto in = shell("cat mesh.obj | '" MERIDIAN_PROGRAM "' info /dev/stdin");
  BOOST_TEST(in.status == 1);
  BOOST_TEST(contains(in.error, "the name has no ending, which tells the format"));
  BOOST_TEST(meridian("info mesh.obj --report -").status == 64);
  BOOST_TEST(number_of_files() == 1u);
  BOOST_TEST(meridian("info mesh.obj --report ./-").status == 0);
  BOOST_TEST(contains(program::read(folder() / "-"), "\"genus\": 1"));
}

BOOST_FIXTURE_TEST_CASE(names_that_would_end_a_line_are_refused, Fixture)
{
  const auto r = shell("'" MERIDIAN_PROGRAM "' unwrap mesh.obj -o \"$(printf 'a\\nf 1 2 3.obj')\" --png a.png");
  BOOST_TEST(r.status == 64);
  BOOST_TEST(contains(r.error, "line break"));
  BOOST_TEST(number_of_files() == 1u);
  BOOST_TEST(shell("mkdir 'a b'; '" MERIDIAN_PROGRAM "' unwrap mesh.obj -o 'a b/c.obj' --png 'a b/c.png'").status == 0);
  BOOST_TEST(contains(program::read(folder() / "a b/c.mtl"), "map_Kd c.png\n"));
}

// Meshes that were found at random and once failed; their first line says with which command.
BOOST_FIXTURE_TEST_CASE(what_once_failed_is_verified, Fixture)
{
  int meshes = 0;
  for (const auto& entry : program::fs::directory_iterator(MERIDIAN_FOUND))
  {
    const std::string path = entry.path().string(), text = program::read(path), mark = "# meridian ";
    const std::size_t first = text.find(mark) + mark.size();
    const std::string line = text.substr(first, text.find('\n') - first), command = line.substr(0, line.find(' '));
    const auto r = meridian(command + " '" + path + "' -o out.obj" + line.substr(command.size()));
    BOOST_TEST((r.status == 0 || contains(r.error, "not met: ")), path << ": " << r.error);
    BOOST_TEST(meridian("verify '" + path + "' out.obj").status == 0, path);
    ++meshes;
  }
  BOOST_TEST(meshes >= 4);
}

// Where a stream leads to a file, that is an output like others.
BOOST_FIXTURE_TEST_CASE(no_output_is_a_stream, Fixture)
{
  for (const char* to : {"one.txt", "/dev/stdout"})
  {
    const auto r = shell(std::string("'" MERIDIAN_PROGRAM "' info mesh.obj --report ") + to + " >one.txt");
    BOOST_TEST(r.status == 64, to);
    BOOST_TEST(contains(r.error, "give every file a name of its own"));
  }
}

// Results that nobody got are no success.
BOOST_FIXTURE_TEST_CASE(output_that_is_lost_is_told_of, Fixture)
{
  const std::string program = "'" MERIDIAN_PROGRAM "' ";
  for (const char* arguments : {"info mesh.obj", "--help", "cut mesh.obj -o out.obj", "completion"})
  {
    const auto full = shell(program + arguments + " >/dev/full");
    BOOST_TEST(full.status == 74, arguments);
    BOOST_TEST(contains(full.error, "standard output could not be written"));
    BOOST_TEST(shell(program + arguments + " >&-").status == 74, arguments);
  }
  BOOST_TEST(shell("{ sleep 0.3; " + program + "info mesh.obj; echo $? >status; } | true; sleep 1").status == 0);
  BOOST_TEST(program::read(folder() / "status") == "74\n");
  BOOST_TEST(shell(program + "cut mesh.obj -o out.obj --quiet >/dev/full").status == 0); // it had nothing to say
}

BOOST_FIXTURE_TEST_CASE(a_file_that_may_not_grow_is_an_error, Fixture)
{
  const std::size_t before = number_of_files();
  const auto r = shell("ulimit -f 1; '" MERIDIAN_PROGRAM "' unwrap mesh.obj -o out.obj");
  BOOST_TEST(r.status == 1);
  BOOST_TEST(contains(r.error, "out.obj: cannot be written"));
  BOOST_TEST(number_of_files() == before);
}

// Also while a file is read that never comes.
BOOST_FIXTURE_TEST_CASE(signals_end_a_run_with_one_status, Fixture)
{
  BOOST_REQUIRE(shell("mkfifo pipe.off").status == 0);
  for (const char* signal : {"INT", "TERM"})
    for (const char* command : {"info pipe.off", "verify pipe.off mesh.obj", "cut pipe.off -o out.obj"})
    {
      const auto r =
        shell(std::string("timeout --preserve-status -s ") + signal + " 0.3 '" MERIDIAN_PROGRAM "' " + command);
      BOOST_TEST(r.status == 130, command << " " << signal);
      BOOST_TEST(r.error == "meridian: interrupted; nothing was written\n");
    }
}

// At any moment: all files are there, or none, and the status says which.
BOOST_FIXTURE_TEST_CASE(signals_leave_all_files_or_none, Fixture)
{
  write("large.obj", obj(sample::noisy(sample::plate(3, 16), 0.001, 1)));
  const std::size_t before = number_of_files();
  std::mt19937 random(1);
  int interrupted = 0;
  for (int i = 0; i < 50; ++i)
  {
    const std::string delay = std::to_string(static_cast<double>(random() % 250) / 1000);
    const auto r = shell(std::string("timeout --preserve-status -s ") + (i % 2 == 0 ? "INT " : "TERM ") + delay
                         + " '" MERIDIAN_PROGRAM "' unwrap large.obj -o out.obj --report r.json --view v.html");
    constexpr int terminated = 143; // before the program has begun
    BOOST_TEST((r.status == 0 || r.status == 130 || r.status == terminated), delay << ": " << r.status);
    BOOST_TEST(number_of_files() == before + (r.status == 0 ? 4 : 0));
    interrupted += r.status == 130;
    shell("rm -f out.* r.json v.html");
  }
  BOOST_TEST(interrupted > 10);
}

// Two runs that write the same files: those of one stay, and each is whole.
BOOST_FIXTURE_TEST_CASE(two_writers_leave_whole_files, Fixture)
{
  for (int i = 0; i < 10; ++i)
  {
    const auto r = shell("'" MERIDIAN_PROGRAM "' unwrap mesh.obj -o out.obj & p=$!; '" MERIDIAN_PROGRAM
                         "' unwrap mesh.obj -o out.obj --quiet && wait $p");
    BOOST_TEST(r.status == 0, r.error);
    BOOST_TEST(meridian("verify mesh.obj out.obj").status == 0);
  }
  BOOST_TEST(number_of_files() == 3u);
}

BOOST_FIXTURE_TEST_CASE(folders_that_may_not_be_written_are_told_of, Fixture)
{
  BOOST_REQUIRE(shell("mkdir locked; chmod 555 locked; echo old >locked.obj; chmod 444 locked.obj").status == 0);
  const bool is_root = shell("touch locked/x").status == 0; // who may do anything
  shell("rm -f locked/x");
  const auto r = meridian("unwrap mesh.obj -o locked/out.obj");
  BOOST_TEST(r.status == (is_root ? 0 : 1));
  BOOST_TEST((is_root || contains(r.error, "locked/out.obj: cannot be written")));
  BOOST_TEST(meridian("info no/such/mesh.obj").status == 1);
  shell("chmod 755 locked");
}

#ifndef __SANITIZE_ADDRESS__
namespace {

constexpr int number_of_points = 4 << 20;

// A VTP file whose points are zeros in packed blocks of so many bytes, or plain if that is none.
std::string vtp_of_zeros(std::uint32_t blocks, std::uint32_t block_size, int pieces)
{
  const auto number = [](std::uint32_t x) { return std::string(reinterpret_cast<const char*>(&x), sizeof x); };
  std::string array = block_size == 0 ? number(12 * number_of_points) + std::string(12 * number_of_points, '\0')
                                      : number(blocks) + number(block_size) + number(0);
  if (block_size != 0)
  {
    const std::string zeros(block_size, '\0');
    uLongf size = compressBound(block_size);
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(zeros.data()), block_size,
              9);
    packed.resize(size);
    for (std::uint32_t i = 0; i < blocks; ++i) { array += number(static_cast<std::uint32_t>(size)); }
    for (std::uint32_t i = 0; i < blocks; ++i) { array += packed; }
  }
  std::string text = std::string("<VTKFile type=\"PolyData\"")
                     + (block_size == 0 ? "" : " compressor=\"vtkZLibDataCompressor\"") + "><PolyData>";
  for (int i = 0; i < pieces; ++i)
    text += "<Piece NumberOfPoints=\"" + std::to_string(number_of_points)
            + "\"><Points><DataArray type=\"Float32\" format=\"appended\" offset=\"0\"/></Points></Piece>";
  return text + "</PolyData><AppendedData encoding=\"raw\">_" + array + "</AppendedData></VTKFile>";
}

} // namespace

// Small files that unpack to large ones, or name the same bytes again and again, do not fill the memory.
BOOST_FIXTURE_TEST_CASE(files_that_unpack_to_far_more_are_refused, Fixture)
{
  write("blocks.vtp", vtp_of_zeros(48, 1 << 20, 1));
  write("one.vtp", vtp_of_zeros(1, 1 << 30, 1)); // a claim: nothing is unpacked for it
  write("pieces.vtp", vtp_of_zeros(0, 0, 20));
  write("enough.vtp", vtp_of_zeros(12, 1 << 20, 1));
  BOOST_REQUIRE(shell("head -c 60000000 /dev/zero | tr '\\0' ' ' | gzip >blanks.off.gz; gzip -k blocks.vtp; "
                      "mkfifo pipe.off.gz")
                  .status
                == 0);
  const std::string run = "ulimit -d 400000; '" MERIDIAN_PROGRAM "' info ";
  for (const char* name : {"blocks.vtp", "blocks.vtp.gz", "one.vtp", "blanks.off.gz"})
  {
    const auto r = shell(run + name);
    BOOST_TEST(r.status == 1, name);
    BOOST_TEST(contains(r.error, "more than 100 times"), name << ": " << r.error);
  }
  const auto piped = shell("cat blanks.off.gz >pipe.off.gz & " + run + "pipe.off.gz");
  BOOST_TEST(contains(piped.error, "more than 100 times"));
  BOOST_TEST(contains(shell(run + "pieces.vtp").error, "several arrays lie in the same bytes"));
  BOOST_TEST(contains(shell(run + "enough.vtp").error, "does not match the number of points")); // it was unpacked
}

BOOST_FIXTURE_TEST_CASE(memory_is_limited_as_asked, Fixture)
{
  write("large.obj", obj(sample::torus(300, 200)));
  for (const char* size : {"10M", "10240K", "10485760"})
  {
    const auto r = meridian(std::string("info large.obj --max-memory ") + size);
    BOOST_TEST(r.status == 1, size);
    BOOST_TEST(contains(r.error, "memory"));
  }
  BOOST_TEST(meridian("cut large.obj -o out.obj --max-memory 2G").status == 0);
  for (const char* size : {"0", "-5", "x", "1.5G", "1T", "5GB", "99999999999G", ""})
  {
    BOOST_TEST(meridian(std::string("info mesh.obj --max-memory '") + size + "'").status == 64, size);
  }
}

// With too little memory a run ends, and says so; nothing waits for more.
BOOST_FIXTURE_TEST_CASE(limited_memory_is_an_error, Fixture)
{
  write("mesh.obj", obj(sample::noisy(sample::plate(3, 24), 0.01, 1)));
  BOOST_REQUIRE(meridian("unwrap mesh.obj -o out.obj").status == 0);
  const std::string unlimited = program::read(folder() / "out.obj");
  shell("rm out.*");
  const std::size_t before = number_of_files();
  bool was_enough = false;
  for (int megabytes : {60, 140, 220, 240, 260, 280, 300, 320, 340, 600})
  {
    const auto r = shell("ulimit -v " + std::to_string(1000 * megabytes)
                         + "; timeout -s KILL 20 '" MERIDIAN_PROGRAM "' unwrap mesh.obj -o out.obj");
    BOOST_TEST((r.status == 0 || r.status == 1), megabytes << " MB: " << r.status);
    if (r.status == 1) { BOOST_TEST(contains(r.error, "meridian: there is not enough memory")); }
    BOOST_TEST((r.status == 0 || number_of_files() == before));
    BOOST_TEST((!was_enough || r.status == 0));
    const std::string result = program::read(folder() / "out.obj");
    BOOST_TEST((r.status != 0 || result == unlimited)); // nothing is made worse to go without
    was_enough = r.status == 0;
    shell("rm -f out.*");
  }
  BOOST_TEST(was_enough);
}
#endif
