// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_END_RUN_H
#define MERIDIAN_END_RUN_H

#include "Terminal.h"
#include "files/Output_files.h"

#include <meridian/base/Verification.h>

#include <string>
#include <vector>

namespace meridian {
namespace program {

// What is said when a run ends well.
struct Last_words
{
  std::vector<std::string> repairs; // each becomes a note
  std::vector<std::string> notes;   // lines as they are
  std::string summary;
  // wishes that were not met: the files are written, but nothing is called verified
  std::vector<std::string> missed = {};
};

// Writes the files, all or none, and says what was found. Returns the exit status.
int end_run(const Common_arguments& arguments, const Verification& verification, files::Output_files& out,
            Terminal& terminal, const Last_words& words);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_END_RUN_H
