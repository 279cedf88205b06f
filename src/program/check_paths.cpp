// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_paths.h"

#include "commands.h"
#include "files/Output_files.h"
#include "files/map_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace meridian {
namespace program {

namespace {

std::string identity_of(const struct stat& s) { return std::to_string(s.st_dev) + ":" + std::to_string(s.st_ino); }

// The same for two paths if they lead to one file.
std::string identity_of(const std::string& path)
{
  struct stat s;
  return stat(path.c_str(), &s) == 0 ? identity_of(s) : files::place_of(path);
}

} // namespace

void check_paths(const std::vector<std::string>& read, const std::vector<std::string>& written)
{
  const auto is_control = [](unsigned char c) { return std::iscntrl(c) != 0; };
  for (const std::string& path : written)
    if (std::any_of(path.begin(), path.end(), is_control))
      throw Usage_error(
        "the name of an output has a line break or another control character, which would end a line of "
        "a file that names it");
  if (std::count(written.begin(), written.end(), "-") != 0)
    throw Usage_error("files are not written to standard output; a file of the name - is given as ./-");
  std::set<std::string> known;
  struct stat s;
  for (int stream : {STDOUT_FILENO, STDERR_FILENO}) // a file that they lead to is written, too
  {
    if (fstat(stream, &s) == 0 && S_ISREG(s.st_mode)) { known.insert(identity_of(s)); }
  }
  for (const std::string& path : read)
  {
    if (!path.empty()) { known.insert(identity_of(path)); }
  }
  for (const std::string& path : written)
    if (!path.empty() && !known.insert(identity_of(path)).second)
      throw Usage_error(path
                        + " would be written twice, or over a file that is read; give every file a name of its own");
  files::Output_files none; // what cannot be written is found before anything is computed
  for (const std::string& path : written)
  {
    if (!path.empty()) { none.add(path, ""); }
  }
}

std::vector<std::string> files_of_result(const std::string& path)
{
  return {path, files::map_path(path, files::Map_format::JSON), files::map_path(path, files::Map_format::CBOR)};
}

} // namespace program
} // namespace meridian
