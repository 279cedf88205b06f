// SPDX-License-Identifier: GPL-3.0-or-later
// What reads files, fed with bytes by libFuzzer. Each program is this with a name for MERIDIAN_FUZZED.
#include "files/Mesh_attributes.h"
#include "files/formats.h"
#include "files/map_file.h"
#include "files/png.h"
#include "files/read_mesh.h"
#include "files/read_paths.h"
#include "files/read_pins.h"
#include "files/read_result.h"
#include "files/read_values.h"

#include <meridian/base/exceptions.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/proof/verify_unwrapping.h>
#include <meridian/surface/examine_surface.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace meridian;

namespace {

// A folder for the files that are read by their names.
class Folder
{
public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "meridian-fuzz-XXXXXX").string();
    m_path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(m_path); }
  std::string write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(m_path / name, std::ios::binary) << bytes;
    return (m_path / name).string();
  }

private:
  std::filesystem::path m_path;
};

const Folder& folder()
{
  static const Folder f;
  return f;
}

// What is read is examined, as every command does first.
void examine(const Polygon_soup& soup)
{
  try
  {
    examine_surface(soup);
  }
  catch (const Invalid_input_error&)
  {}
}

[[maybe_unused]] void read_off(const std::string& bytes) { examine(files::read_off(bytes)); }
[[maybe_unused]] void read_stl(const std::string& bytes) { examine(files::read_stl(bytes)); }
[[maybe_unused]] void read_vtp(const std::string& bytes) { examine(files::read_vtp(bytes, bytes.size())); }
[[maybe_unused]] void read_obj(const std::string& bytes)
{
  files::Mesh_attributes attributes;
  examine(files::read_obj(bytes, &attributes));
}
[[maybe_unused]] void read_ply(const std::string& bytes)
{
  files::Mesh_attributes attributes;
  examine(files::read_ply(bytes, &attributes));
}

[[maybe_unused]] void read_gzip(const std::string& bytes)
{
  examine(files::read_mesh(folder().write("mesh.off.gz", bytes)));
}

[[maybe_unused]] void read_png(const std::string& bytes) { files::read_png(folder().write("image.png", bytes)); }

[[maybe_unused]] void read_json(const std::string& bytes)
{
  Result_mesh mesh;
  std::vector<Result_curve> fields;
  files::read_map(folder().write("a.map.json", bytes), mesh, fields);
}
[[maybe_unused]] void read_cbor(const std::string& bytes)
{
  Result_mesh mesh;
  std::vector<Result_curve> fields;
  files::read_map(folder().write("a.map.cbor", bytes), mesh, fields);
}

// The first byte says what kind of list it is.
[[maybe_unused]] void read_lists(const std::string& bytes)
{
  constexpr std::size_t vertices = 100;
  if (bytes.empty()) { return; }
  const std::string path = folder().write("list.txt", bytes.substr(1));
  switch (bytes[0])
  {
  case 'p': files::read_paths(path, vertices); break;
  case 'n': files::read_pins(path, vertices); break;
  default: files::read_values(path, vertices);
  }
}

// Three files one after another, divided by lines of "%%": the input, the result and its map.
[[maybe_unused]] void read_result(const std::string& bytes)
{
  const std::string line = "%%\n";
  const std::size_t first = bytes.find(line);
  const std::size_t second = first == std::string::npos ? first : bytes.find(line, first + line.size());
  if (second == std::string::npos) { return; }
  const Polygon_soup input = files::read_off(bytes.substr(0, first));
  folder().write("a.map.json", bytes.substr(second + line.size()));
  const files::Result_files result =
    files::read_result(folder().write("a.obj", bytes.substr(first + line.size(), second - first - line.size())));
  switch (result.kind)
  {
  case files::Result_kind::CUT: verify_cut(input, result.mesh); break;
  case files::Result_kind::GENERATORS: verify_generators(input, result.mesh, result.curves); break;
  case files::Result_kind::UNWRAPPING: verify_unwrapping(input, result.mesh, result.texture, 0, 1); break;
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try
  {
    MERIDIAN_FUZZED(std::string(reinterpret_cast<const char*>(data), size));
  }
  catch (const files::File_error&)
  {}
  return 0;
}
