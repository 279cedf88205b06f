// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_TERMINAL_H
#define MERIDIAN_TERMINAL_H

#include <meridian/base/Progress_observer.h>

#include <unistd.h>

#include <iostream>

namespace meridian {
namespace program {

// Shows the stage on a terminal.
class Terminal : public Progress_observer
{
public:
  explicit Terminal(bool quiet) : m_is_shown(!quiet && isatty(STDERR_FILENO)) {}
  ~Terminal() override { clear(); }
  void begin_component(std::size_t i, std::size_t n)
  {
    m_place = n > 1 ? "component " + std::to_string(i + 1) + " of " + std::to_string(n) + ", " : "";
  }
  void stage_progressed(Stage stage, double done) override
  {
    if (m_is_shown)
    {
      std::cerr << "\r\033[K" << m_place << name_of(stage) << ' ' << static_cast<int>(100 * done) << " %" << std::flush;
    }
  }
  void stage_started(Stage stage) override
  {
    if (m_is_shown) { std::cerr << "\r\033[K" << m_place << name_of(stage) << " ..." << std::flush; }
  }
  void clear()
  {
    if (m_is_shown) { std::cerr << "\r\033[K" << std::flush; }
  }

private:
  bool m_is_shown;
  std::string m_place;
};

} // namespace program
} // namespace meridian

#endif // MERIDIAN_TERMINAL_H
