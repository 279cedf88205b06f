// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_mesh.h"

#include "Mesh_format.h"

#include "formats.h"

#include <meridian/base/Polygon_soup.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <memory>

namespace meridian {
namespace files {

namespace {

// How much of a file was read; 0 where the system cannot tell, as of a pipe.
std::size_t size_of_packed(gzFile file)
{
  const z_off_t at = gzoffset(file);
  return at > 0 ? static_cast<std::size_t>(at) : 0;
}

} // namespace

std::string read_bytes(const std::string& path, std::size_t* size_on_disk)
{
  errno = 0;
  // plain files pass through
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) { throw File_error(path + ": cannot be opened: " + (errno ? std::strerror(errno) : "out of memory")); }
  gzbuffer(file.get(), 1 << 18);
  std::string bytes;
  constexpr std::size_t first_step = 1 << 16, last_step = 1 << 22;
  for (;;)
  {
    const std::size_t size = bytes.size(), step = std::clamp(size, first_step, last_step);
    bytes.resize(size + step);
    const int got = gzread(file.get(), bytes.data() + size, static_cast<unsigned>(step));
    bytes.resize(size + static_cast<std::size_t>(std::max(got, 0)));
    int status = Z_OK;
    const char* message = gzerror(file.get(), &status);
    if (got < 0 || (status != Z_OK && status != Z_STREAM_END))
      throw File_error(path + ": cannot be read: " + (status == Z_ERRNO ? std::strerror(errno) : message));
    const std::size_t size_read = gzdirect(file.get()) ? bytes.size() : size_of_packed(file.get());
    if (bytes.size() > most_unpacked(size_read))
      throw File_error(path + ": it unpacks to more than 100 times its size; if it is a mesh, unpack it first");
    if (got == 0)
    {
      if (size_on_disk) { *size_on_disk = size_read; }
      return bytes;
    }
  }
}

bool is_packed(const std::string& path)
{
  const std::size_t n = path.size();
  return n > 3 && path[n - 3] == '.' && std::tolower(static_cast<unsigned char>(path[n - 2])) == 'g'
         && std::tolower(static_cast<unsigned char>(path[n - 1])) == 'z';
}

namespace {

Polygon_soup parse(Mesh_format format, const std::string& bytes, std::size_t size_on_disk, Mesh_attributes* attributes)
{
  switch (format)
  {
  case Mesh_format::OFF: return read_off(bytes);
  case Mesh_format::OBJ: return read_obj(bytes, attributes);
  case Mesh_format::STL: return read_stl(bytes);
  case Mesh_format::PLY: return read_ply(bytes, attributes);
  case Mesh_format::VTP: return read_vtp(bytes, size_on_disk);
  }
  return {};
}

} // namespace

Polygon_soup read_mesh(const std::string& path, Mesh_attributes* attributes)
{
  const auto format = format_of(path);
  if (!format)
  {
    const std::string ending = ending_of(path);
    throw File_error(
      path + ": "
      + (ending.empty() ? "the name has no ending, which tells the format" : "unknown format '" + ending + "'")
      + "; use " + list_formats([](Mesh_format) { return true; }) + ", or gzip of these");
  }
  std::size_t size_on_disk = 0;
  const std::string bytes = read_bytes(path, &size_on_disk);
  if (bytes.empty()) { throw File_error(path + ": the file is empty"); }
  try
  {
    return parse(*format, bytes, size_on_disk, attributes);
  }
  catch (const File_error& e)
  {
    throw File_error(path + ": " + e.what());
  }
}

void add_strip(Polygon_soup& soup, std::vector<std::int32_t>::const_iterator first,
               std::vector<std::int32_t>::const_iterator end)
{
  const std::ptrdiff_t size = end - first;
  for (std::ptrdiff_t j = 2; j < size; ++j)
  {
    const bool odd = j % 2 == 1;
    const std::array<std::int32_t, 3> t{first[j - 2], first[odd ? j : j - 1], first[odd ? j - 1 : j]};
    soup.add_polygon(t.data(), 3);
  }
}

} // namespace files
} // namespace meridian
