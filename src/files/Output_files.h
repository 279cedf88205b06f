// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_OUTPUT_FILES_H
#define MERIDIAN_FILES_OUTPUT_FILES_H

#include "read_mesh.h"

#include <string>
#include <vector>

namespace meridian {
namespace files {

// Where a file lies, or would: links are followed, also such as lead to nothing yet. Throws File_error.
std::string place_of(const std::string& path);

// The files that one run writes. All are written beside their places first and moved there together at the end; a run
// that ends before leaves nothing, not even under another name where the file system knows files without names.
class Output_files
{
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  ~Output_files();

  // Writes `bytes` for `path`, packed if that ends with ".gz". Links are followed; what is there must be a plain file.
  // Throws File_error.
  void add(const std::string& path, const std::string& bytes);
  // Moves all files to their places. Throws File_error.
  void commit();

private:
  struct File
  {
    std::string path, hidden;
    int descriptor = -1;
  };
  std::vector<File> m_files;
};

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_OUTPUT_FILES_H
