// SPDX-License-Identifier: GPL-3.0-or-later
#include "end_run.h"

#include <iostream>

namespace meridian {
namespace program {

int end_run(const Common_arguments& arguments, const Verification& verification, files::Output_files& out,
            Terminal& terminal, const Last_words& words)
{
  commit(out);
  terminal.clear();
  for (const std::string& failure : verification.failures)
  {
    std::cerr << "meridian: not verified: " << failure << '\n';
  }
  for (const std::string& missed : words.missed) { std::cerr << "meridian: not met: " << missed << '\n'; }
  if (!arguments.quiet)
  {
    for (const std::string& repair : words.repairs) { std::cout << "note: " << repair << '\n'; }
    for (const std::string& note : words.notes) { std::cout << note << '\n'; }
    std::cout << (!verification          ? "NOT verified, nothing but the report was written: "
                  : words.missed.empty() ? "verified: "
                                         : "NOT as wished: ")
              << words.summary << '\n';
  }
  return verification && words.missed.empty() ? VERIFIED : NOT_VERIFIED;
}

} // namespace program
} // namespace meridian
