// Runs the program as a person does.
#ifndef MERIDIAN_TEST_RUN_PROGRAM_H
#define MERIDIAN_TEST_RUN_PROGRAM_H

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace program {

namespace fs = std::filesystem;

struct Result
{
  int status;
  std::string out, error;
};

inline std::string read(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// A folder that goes away. Commands are run inside it; what they print goes to files outside of it.
class Workplace
{
public:
  Workplace()
  {
    std::string name = (fs::temp_directory_path() / "meridian-XXXXXX").string();
    m_base = mkdtemp(name.data());
    fs::create_directory(folder());
  }
  ~Workplace() { fs::remove_all(m_base); }
  fs::path folder() const { return m_base / "work"; }
  void write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(folder() / name, std::ios::binary) << bytes;
  }
  std::size_t number_of_files() const
  {
    std::size_t n = 0;
    for (const auto& entry : fs::directory_iterator(folder())) { n += entry.exists(); }
    return n;
  }
  // The exit status is that of a shell: 128 and the signal if the command was killed.
  Result shell(const std::string& command) const
  {
    const std::string line = "cd '" + folder().string() + "' && { " + command + "; } >'" + (m_base / "out").string()
                             + "' 2>'" + (m_base / "error").string() + "' </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read(m_base / "out"),
            read(m_base / "error")};
  }
  // A page as a browser shows it.
  struct Shown
  {
    std::string dom;
    std::vector<std::string> errors; // of the console
    int number(const std::string& attribute) const
    {
      const std::size_t at = dom.find(attribute + "=\"");
      return at == std::string::npos ? -1 : std::atoi(dom.c_str() + at + attribute.size() + 2);
    }
  };
  Shown show(const std::string& page, const std::string& browser) const
  {
    const Result r = shell("timeout 100 '" + browser
                           + "' --headless --no-sandbox --disable-gpu --use-gl=swiftshader --enable-unsafe-swiftshader"
                             " --ignore-gpu-blocklist --disable-quic --no-first-run --disable-background-networking "
                             "--disable-component-update --disable-sync"
                             " --user-data-dir=browser --window-size=800,600 --enable-logging=stderr "
                             "--virtual-time-budget=5000 --dump-dom 'file://"
                           + (folder() / page).string() + "#count'");
    Shown shown{r.out, {}};
    std::istringstream lines(r.error);
    for (std::string line; std::getline(lines, line);)
      if (line.find("CONSOLE") != std::string::npos
          && (line.find("rror") != std::string::npos || line.find("ERROR") != std::string::npos
              || line.find("Uncaught") != std::string::npos))
        shown.errors.push_back(line);
    return shown;
  }
  Result meridian(const std::string& arguments) const
  {
    return shell(std::string("'") + MERIDIAN_PROGRAM + "' " + arguments);
  }

private:
  fs::path m_base;
};

} // namespace program

#endif // MERIDIAN_TEST_RUN_PROGRAM_H
