// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace meridian {
namespace files {

namespace {

[[noreturn]] void fail(const std::string& path, const char* what)
{
  throw File_error(path + ": " + what + ": " + std::strerror(errno));
}

std::string folder_of(const std::string& path)
{
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

std::string hidden_name(const std::string& path) { return path + ".part-" + std::to_string(getpid()); }

std::string pack(const std::string& path, const std::string& bytes)
{
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw File_error(path + ": cannot be packed");
  std::string packed;
  std::size_t at = 0;
  constexpr std::size_t step = 1 << 22;
  int status = Z_OK;
  while (status != Z_STREAM_END)
  {
    const std::size_t take = std::min(step, bytes.size() - at), size = packed.size();
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
    stream.avail_in = static_cast<uInt>(take);
    packed.resize(size + step);
    stream.next_out = reinterpret_cast<Bytef*>(&packed[size]);
    stream.avail_out = static_cast<uInt>(step);
    status = deflate(&stream, at + take == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    at += take - stream.avail_in;
    packed.resize(size + step - stream.avail_out);
    if (status == Z_STREAM_ERROR)
    {
      deflateEnd(&stream);
      throw File_error(path + ": cannot be packed");
    }
  }
  deflateEnd(&stream);
  return packed;
}

} // namespace

std::string place_of(const std::string& path)
{
  namespace fs = std::filesystem;
  constexpr int most_links = 40; // as many as the system follows
  try
  {
    fs::path place = fs::absolute(path);
    for (int i = 0; i < most_links && fs::is_symlink(place); ++i)
    {
      place = place.parent_path() / fs::read_symlink(place);
    }
    return fs::weakly_canonical(place).string();
  }
  catch (const fs::filesystem_error& e)
  {
    throw File_error(path + ": " + e.code().message());
  }
}

Output_files::~Output_files()
{
  for (const File& file : m_files)
  {
    if (file.descriptor >= 0) { close(file.descriptor); }
    if (!file.hidden.empty()) { unlink(file.hidden.c_str()); }
  }
}

void Output_files::add(const std::string& path, const std::string& bytes)
{
  struct stat existing;
  if (stat(path.c_str(), &existing) == 0 && !S_ISREG(existing.st_mode))
  {
    throw File_error(path + ": cannot be written: it is not a plain file");
  }
  const std::string packed = is_packed(path) ? pack(path, bytes) : std::string();
  const std::string& content = is_packed(path) ? packed : bytes;

  File file;
  file.path = place_of(path);
#ifdef O_TMPFILE
  file.descriptor = open(folder_of(file.path).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
#endif
  if (file.descriptor < 0)
  {
    const std::string hidden = hidden_name(file.path);
    file.descriptor = open(hidden.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
    if (file.descriptor < 0) { fail(path, "cannot be written"); }
    file.hidden = hidden;
  }
  m_files.push_back(file); // from here on the destructor cleans up
  for (std::size_t at = 0; at < content.size();)
  {
    const ssize_t n = write(file.descriptor, content.data() + at, content.size() - at);
    if (n < 0 && errno == EINTR) { continue; }
    if (n <= 0) { fail(path, "cannot be written"); }
    at += static_cast<std::size_t>(n);
  }
}

void Output_files::commit()
{
  for (File& file : m_files)
    if (file.hidden.empty())
    {
      const std::string hidden = hidden_name(file.path);
      unlink(hidden.c_str());
      const std::string link = "/proc/self/fd/" + std::to_string(file.descriptor);
      if (linkat(AT_FDCWD, link.c_str(), AT_FDCWD, hidden.c_str(), AT_SYMLINK_FOLLOW) != 0)
      {
        fail(file.path, "cannot be written");
      }
      file.hidden = hidden;
    }
  for (File& file : m_files)
  {
    const int descriptor = file.descriptor;
    file.descriptor = -1;
    if (close(descriptor) != 0) { fail(file.path, "cannot be written"); }
  }
  for (File& file : m_files)
  {
    if (std::rename(file.hidden.c_str(), file.path.c_str()) != 0) { fail(file.path, "cannot be written"); }
    file.hidden.clear();
  }
}

} // namespace files
} // namespace meridian
