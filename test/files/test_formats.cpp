#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include "files/Mesh_format.h"
#include "files/Output_files.h"
#include "files/map_file.h"
#include "files/read_mesh.h"
#include "files/write_mesh.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace meridian;
namespace fs = std::filesystem;

namespace {

// A folder that goes away with the test.
struct Folder
{
  fs::path path;
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "meridian-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path); }
  std::string write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path / name, std::ios::binary) << bytes;
    return (path / name).string();
  }
  Polygon_soup read(const std::string& name, const std::string& bytes) const
  {
    return files::read_mesh(write(name, bytes));
  }
  std::string message(const std::string& name, const std::string& bytes) const
  {
    try
    {
      read(name, bytes);
    }
    catch (const files::File_error& e)
    {
      return e.what();
    }
    return "";
  }
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<Index> polygon(const Polygon_soup& s, std::size_t i)
{
  std::vector<Index> p;
  for (std::size_t k = 0; k < s.size(i); ++k) { p.push_back(s.corner(i, k)); }
  return p;
}

template <class Number> void append(std::string& bytes, Number x, bool swapped = false)
{
  char raw[sizeof x];
  std::memcpy(raw, &x, sizeof x);
  if (swapped) { std::reverse(raw, raw + sizeof x); }
  bytes.append(raw, sizeof x);
}

} // namespace

BOOST_FIXTURE_TEST_CASE(off_is_read_with_comments_colours_and_counts_on_any_line, Folder)
{
  const auto s =
    read("a.off",
         "COFF # a comment\n\n# another\n4 1 0\n0 0 0 255 0 0 1\n1e0 0 0\n1 +1 0\n0 1 -0.5\n4 0 1 2 3 0.5 0.5 0.5\n");
  BOOST_TEST(s.points.size() == 4u);
  BOOST_TEST(s.points[3][2] == -0.5);
  BOOST_TEST(polygon(s, 0) == (std::vector<Index>{0, 1, 2, 3}), boost::test_tools::per_element());
  const auto tiny =
    read("c.off", "OFF\n3 1 0\n1e-400 -1e-400 0\n0." + std::string(400, '0') + "1 1 0\n0 1 0\n3 0 1 2\n");
  BOOST_TEST((tiny.points[0][0] == 0 && tiny.points[1][0] == 0));
  BOOST_TEST(read("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").number_of_polygons() == 1u);
}

BOOST_FIXTURE_TEST_CASE(obj_is_read_with_slashes_negative_indices_and_joined_lines, Folder)
{
  const auto s = read(
    "a.obj", "o x\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\nv 0 1 0\nf -4 -2 \\\n -1\nl 1 2\n");
  BOOST_TEST(polygon(s, 0) == (std::vector<Index>{0, 1, 2}), boost::test_tools::per_element());
  BOOST_TEST(polygon(s, 1) == (std::vector<Index>{0, 2, 3}), boost::test_tools::per_element());
}

BOOST_FIXTURE_TEST_CASE(equal_points_are_welded_in_stl_and_nowhere_else, Folder)
{
  const std::string text =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 0 -0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  const auto s = read("a.stl", text);
  BOOST_TEST(s.points.size() == 4u);
  BOOST_TEST(polygon(s, 1) == (std::vector<Index>{1, 3, 2}), boost::test_tools::per_element());
  BOOST_TEST(!std::signbit(s.points[1][2]));
  std::string binary = "solid that is binary all the same";
  binary.resize(80, ' ');
  append(binary, std::uint32_t(2));
  const float facets[2][12] = {{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 1, 0, -0.f, 1, 1, 0, 0, 1, 0}};
  for (const auto& f : facets)
  {
    for (float x : f) { append(binary, x); }
    append(binary, std::uint16_t(0));
  }
  const auto b = read("b.stl", binary);
  BOOST_TEST((b.points == s.points));
  BOOST_TEST((b.corners == s.corners));
  BOOST_TEST(read("c.off", "OFF\n4 1 0\n0 0 0\n0 0 0\n1 0 0\n0 1 0\n3 0 2 3\n").points.size() == 4u);
}

BOOST_FIXTURE_TEST_CASE(ply_is_read_as_text_and_in_both_byte_orders_with_triangle_strips, Folder)
{
  const auto header = [](const std::string& encoding, const std::string& faces) {
    return "ply\nformat " + encoding
           + " 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\nproperty uchar "
             "red\n"
           + faces + "end_header\n";
  };
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n",
                    strip = "element tristrips 1\nproperty list int int vertex_indices\n";
  const auto text = read("a.ply", header("ascii", face) + "0 0 0 9\n1 0 0 9\n1 1 0 9\n0.5 1 2 9\n3 0 1 2\n");
  BOOST_TEST(text.points[3][2] == 2);
  BOOST_TEST(text.number_of_polygons() == 1u);
  for (bool big : {false, true})
  {
    std::string body;
    const double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1, 2}};
    for (const auto& p : points)
    {
      append(body, static_cast<float>(p[0]), big);
      append(body, p[1], big);
      append(body, static_cast<std::int16_t>(p[2]), big);
      append(body, std::uint8_t(9));
    }
    append(body, std::int32_t(8), big);
    for (std::int32_t i : {0, 1, 2, 3, -1, 3, 2, 0}) { append(body, i, big); }
    const auto s = read("b.ply", header(big ? "binary_big_endian" : "binary_little_endian", strip) + body);
    BOOST_TEST((s.points == text.points));
    BOOST_REQUIRE(s.number_of_polygons() == 3u);
    BOOST_TEST(polygon(s, 0) == (std::vector<Index>{0, 1, 2}), boost::test_tools::per_element());
    BOOST_TEST(polygon(s, 1) == (std::vector<Index>{1, 3, 2}), boost::test_tools::per_element()); // turned
    BOOST_TEST(polygon(s, 2) == (std::vector<Index>{3, 2, 0}), boost::test_tools::per_element());
  }
}

namespace {

template <class Values> std::string raw(const Values& values)
{
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]);
}

std::string base64(const std::string& bytes)
{
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto at = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u; };
    const unsigned block = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    text += letters[block >> 18 & 63];
    text += letters[block >> 12 & 63];
    text += i + 1 < bytes.size() ? letters[block >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? letters[block & 63] : '=';
  }
  return text;
}

// With its size before it.
std::string sized(const std::string& bytes)
{
  std::string s;
  append(s, static_cast<std::uint32_t>(bytes.size()));
  return s + bytes;
}

std::string packed(const std::string& bytes, std::string& head)
{
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  out.resize(size);
  for (std::uint32_t x : {1u, static_cast<unsigned>(bytes.size()), 0u, static_cast<unsigned>(size)})
  {
    append(head, x);
  }
  return out;
}

std::string poly_data(const std::string& root, const std::vector<std::string>& arrays,
                      const std::vector<std::string>& contents, const std::string& appended)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" " + root
         + ">\n<PolyData><Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\"><Points>"
           "<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         + arrays[0] + ">" + contents[0]
         + "</DataArray></Points><Polys>"
           "<DataArray type=\"Int32\" Name=\"connectivity\" "
         + arrays[1] + ">" + contents[1]
         + "</DataArray>"
           "<DataArray type=\"Int32\" Name=\"offsets\" "
         + arrays[2] + ">" + contents[2] + "</DataArray></Polys></Piece></PolyData>" + appended + "</VTKFile>\n";
}

} // namespace

BOOST_FIXTURE_TEST_CASE(vtp_is_read_in_all_its_encodings, Folder)
{
  std::vector<double> xyz{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.25};
  std::vector<std::int32_t> corners{0, 1, 2, 0, 2, 3}, ends{3, 6};
  const auto check = [&](const std::string& bytes) {
    const auto s = read("a.vtp", bytes);
    BOOST_REQUIRE(s.points.size() == 4u);
    BOOST_TEST(s.points[3][2] == 0.25);
    BOOST_TEST((s.corners == corners));
    BOOST_TEST(s.number_of_polygons() == 2u);
  };
  const std::vector<std::string> text(3, "format=\"ascii\""), binary(3, "format=\"binary\"");
  check(poly_data("", text, {"0 0 0 1 0 0 1 1 0\n0 1 .25", "0 1 2 0 2 3", "3 6"}, ""));
  check(poly_data("byte_order=\"LittleEndian\"", binary,
                  {base64(sized(raw(xyz))), "\n " + base64(sized(raw(corners))) + "\n", base64(sized(raw(ends)))}, ""));
  const auto encode = [&](const std::string& bytes) {
    std::string head;
    const std::string body = packed(bytes, head);
    return base64(head) + base64(body);
  };
  check(poly_data("compressor=\"vtkZLibDataCompressor\"", binary,
                  {encode(raw(xyz)), encode(raw(corners)), encode(raw(ends))}, ""));
  const std::string a = sized(raw(xyz)), b = sized(raw(corners)), c = sized(raw(ends));
  const auto offset = [](std::size_t n) { return "format=\"appended\" offset=\"" + std::to_string(n) + "\""; };
  check(poly_data("", {offset(0), offset(a.size()), offset(a.size() + b.size())}, {"", "", ""},
                  "<AppendedData encoding=\"raw\">\n _" + a + b + c + "</AppendedData>"));
  const std::string a64 = base64(a), b64 = base64(b), c64 = base64(c);
  check(poly_data("", {offset(0), offset(a64.size()), offset(a64.size() + b64.size())}, {"", "", ""},
                  "<AppendedData encoding=\"base64\">\n _" + a64 + b64 + c64 + "</AppendedData>"));
}

BOOST_FIXTURE_TEST_CASE(broken_files_are_refused_with_the_place, Folder)
{
  BOOST_TEST(contains(message("a.off", ""), "the file is empty"));
  BOOST_TEST(contains(message("a.off", "OFF\n3 1 0\n0 0 0\n1 0"), "the file ends where a coordinate should be"));
  BOOST_TEST(contains(message("a.off", "OFF\n3 1 0\n0 0 0\n1 0 x\n"), "line 4: expected a coordinate, found 'x'"));
  BOOST_TEST(contains(message("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n"), "line 6"));
  BOOST_TEST(contains(message("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n3 0 1 2\n"),
                      "face 0 is said to have 4 corners"));
  BOOST_TEST(contains(message("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2\n3 0 1 2\n"),
                      "face 0 is said to have 4 corners and has 3"));
  BOOST_TEST(
    contains(message("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"), "face 0 is said to have -3 corners"));
  BOOST_TEST(contains(message("a.off", "OFF\n-1 0 0\n"), "the number of vertices is -1"));
  BOOST_TEST(contains(message("a.off", "OFF\n0 -1 0\n"), "the number of faces is -1"));
  BOOST_TEST(contains(message("a.off", "hello"), "does not begin with 'OFF'"));
  BOOST_TEST(contains(message("a.obj", "v 0 0\n"), "fewer than three coordinates"));
  BOOST_TEST(contains(message("a.obj", "# nothing\n"), "neither vertices nor faces"));
  BOOST_TEST(
    contains(message("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"), "ends within a solid"));
  BOOST_TEST(contains(message("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendsolid x\n"),
                      "ends within a solid"));
  BOOST_TEST(contains(message("a.stl", std::string(100, 'x')), "neither text nor binary STL"));
  BOOST_TEST(contains(message("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                                       "y\nproperty float z\nelement face 1\nproperty list char int vertex_indices\n"
                                       "end_header\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"),
                      "has a list of impossible length"));
  BOOST_TEST(contains(message("a.vtp", poly_data("", std::vector<std::string>(3, "format=\"appended\" offset=\"99\""),
                                                 {"", "", ""}, "<AppendedData encoding=\"raw\">_ab</AppendedData>")),
                      "an array lies past the end of the file"));
  BOOST_TEST(contains(message("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
                      "no x, y and z"));
  BOOST_TEST(contains(message("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                                       "y\nproperty float z\nend_header\n0 0 0\n"),
                      "points and no faces"));
  BOOST_TEST(contains(message("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float "
                                       "x\nproperty float y\nproperty float z\nend_header\nabc"),
                      "ends too early"));
  BOOST_TEST(contains(message("a.vtp", "<VTKFile type=\"PolyData\"><PolyData>"), "VTP"));
  BOOST_TEST(contains(message("a.xyz", "1 2 3"), "unknown format 'xyz'"));
  BOOST_CHECK_THROW(files::read_mesh((path / "missing.off").string()), files::File_error);
}

BOOST_FIXTURE_TEST_CASE(every_writable_format_reads_back_bit_for_bit, Folder)
{
  const auto run = pipeline::run(sample::soup(sample::noisy(sample::torus(9, 7), 0.3, 9)));
  const Result_mesh& mesh = run.assembled.mesh;
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.vtp", "a.off.gz", "a.ply.gz"})
  {
    const std::string to = (path / name).string();
    files::Output_files out;
    out.add(to, files::format_mesh(to, mesh));
    for (const auto format : all<files::Map_format>())
    {
      out.add(files::map_path(to, format), files::format_map(mesh, files::Result_kind::CUT, format));
    }
    BOOST_TEST(!fs::exists(to)); // nothing before the end
    out.commit();
    const auto s = files::read_mesh(to);
    BOOST_TEST((s.points == mesh.points));
    BOOST_TEST(s.number_of_polygons() == mesh.faces.size());
    BOOST_TEST(std::memcmp(s.corners.data(), mesh.faces.data(), s.corners.size() * sizeof(Index)) == 0);
    for (const char* of : {"a.map.json", "a.map.cbor"})
    {
      Result_mesh map;
      std::vector<Result_curve> fields;
      BOOST_TEST((files::read_map((path / of).string(), map, fields) == files::Result_kind::CUT));
      BOOST_TEST((map.origin == mesh.origin));
      BOOST_TEST((map.copy_of == mesh.copy_of && map.face_of == mesh.face_of && map.component_of == mesh.component_of
                  && map.seams == mesh.seams));
      BOOST_TEST(fields.empty());
    }
    BOOST_CHECK_EXCEPTION(files::find_map(to), files::File_error,
                          [](const auto& e) { return contains(e.what(), "both the map of one result"); });
    fs::remove(path / "a.map.json");
    BOOST_TEST(files::find_map(to) == (path / "a.map.cbor").string());
    fs::remove(path / "a.map.cbor");
    BOOST_TEST(files::find_map(to) == (path / "a.map.json").string()); // whose absence is what is then told
  }
  BOOST_CHECK_EXCEPTION(files::check_writable_format("x.stl"), files::File_error,
                        [](const auto& e) { return contains(e.what(), "STL cannot hold a cut"); });
}

// Definition (RFC 8949): CBOR holds what JSON holds, and nlohmann's reader, which is not ours, takes both for the same.
BOOST_AUTO_TEST_CASE(maps_hold_the_same_in_text_and_in_binary)
{
  Result_mesh mesh;
  mesh.copy_of = {-1, 0, 23, 24, 255, 256, 65535, 65536, 2147483647, -24, -25, -2147483647};
  mesh.origin.push_back({Result_origin::VERTEX, {300, -1}, {0, 0, 0}});
  mesh.origin.push_back({Result_origin::EDGE, {1, 70000}, {0.1, 0, 0}});
  mesh.origin.push_back({Result_origin::FACE, {5, -1}, {1e-300, 1. / 3, 2. / 3}});
  mesh.face_of = {0, 1};
  mesh.seams = {{0, 5}};
  std::vector<Result_curve> curves{{"longitude_0", {}, {{3, 0.5}, {4, -1e9}}}, {"meridian_0", {}, {}}};
  for (const auto kind : {files::Result_kind::CUT, files::Result_kind::GENERATORS, files::Result_kind::UNWRAPPING})
  {
    const std::string text = files::format_map(mesh, kind, files::Map_format::JSON, curves),
                      binary = files::format_map(mesh, kind, files::Map_format::CBOR, curves);
    BOOST_TEST((nlohmann::json::parse(text) == nlohmann::json::from_cbor(binary)));
    BOOST_TEST(binary.size() < text.size());
  }
}

// Refusal: what is no map, of either form, is told from one, however deep its lists are.
BOOST_FIXTURE_TEST_CASE(files_that_are_no_maps_are_refused, Folder)
{
  const auto message = [&](const std::string& name, const std::string& bytes) -> std::string {
    Result_mesh mesh;
    std::vector<Result_curve> fields;
    try
    {
      files::read_map(write(name, bytes), mesh, fields);
    }
    catch (const files::File_error& e)
    {
      return e.what();
    }
    return "";
  };
  const std::string rest = R"(,"face_of":[0],"component_of":[0],"seams":[[0,1]]})";
  const auto with = [&](const std::string& begin) { return message("a.map.json", "{" + begin + rest); };
  BOOST_TEST(with(R"("copy_of":[-1],"origin":[[0]])").empty());
  BOOST_TEST(contains(with(R"("copy_of":[18446744073709551615],"origin":[[0]])"), "not a whole number in range"));
  BOOST_TEST(contains(with(R"("copy_of":[2147483648],"origin":[[0]])"), "not a whole number in range"));
  BOOST_TEST(contains(with(R"("copy_of":[0.5],"origin":[[0]])"), "not a whole number in range"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"origin":[[0,1]])"), "an origin has 2 entries"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"origin":[[0,1,2,3,4,5,6]])"), "an origin has 5 entries"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"origin":[[]])"), "an origin has 0 entries"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"origin":[0])"), "a number stands"));
  BOOST_TEST(contains(with(R"("copy_of":[[1]],"origin":[[0]])"), "a list of 1 numbers"));
  BOOST_TEST(contains(with(R"("copy_of":7,"origin":[[0]])"), "a number stands"));
  BOOST_TEST(contains(with(R"("copy_of":{},"origin":[[0]])"), "a dictionary stands"));
  BOOST_TEST(contains(with(R"("copy_of":[null],"origin":[[0]])"), "a null stands"));
  BOOST_TEST(contains(with(R"("copy_of":["x"],"origin":[[0]])"), "a text stands"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"copy_of":[0],"origin":[[0]])"), "stands there twice"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"origin":[[0]],"else":[0])"), "no part of a map"));
  BOOST_TEST(contains(with(R"("copy_of":[-1])"), "it has no \"origin\""));
  BOOST_TEST(contains(with(R"("result":"x","copy_of":[-1],"origin":[[0]])"), "unknown result 'x'"));
  BOOST_TEST(contains(with(R"("copy_of":[-1],"origin":[[0]],"fields":[[1,2]])"), "a number stands"));
  BOOST_TEST(
    contains(with(R"("copy_of":[-1],"origin":[[0]],"fields":[{"curve":"x","values":[1]}])"), "a number stands"));
  BOOST_TEST(contains(message("a.map.json", "{\"copy_of\": [1,"), "not a map file"));
  BOOST_TEST(contains(message("a.map.json", std::string(1000000, '[')), "a list stands"));
  BOOST_TEST(contains(message("a.map.cbor", std::string(1000000, '\x81')), "a list stands"));
  BOOST_TEST(contains(message("a.map.cbor", std::string(1000000, '\xa1')), "not a map file"));
  BOOST_TEST(contains(message("a.map.cbor", ""), "not a map file"));
  const std::string whole = files::format_map(Result_mesh(), files::Result_kind::CUT, files::Map_format::CBOR);
  BOOST_TEST(message("a.map.cbor", whole).empty());
  BOOST_TEST(contains(message("a.map.cbor", whole.substr(0, whole.size() - 1)), "not a map file"));
}

BOOST_FIXTURE_TEST_CASE(files_that_are_not_committed_leave_nothing, Folder)
{
  const std::string old = write("b.txt", "old");
  {
    files::Output_files out;
    out.add((path / "a.txt").string(), "new");
    out.add(old, "new");
  }
  std::size_t entries = 0;
  for (const auto& entry : fs::directory_iterator(path)) { entries += entry.exists(); }
  BOOST_TEST(entries == 1u);
  BOOST_TEST(files::read_bytes(old) == "old");
  files::Output_files out;
  out.add(old, "new");
  BOOST_CHECK_THROW(out.add((path / "no" / "such" / "folder").string(), "x"), files::File_error);
  out.commit();
  BOOST_TEST(files::read_bytes(old) == "new");
}

// Every format is known by its ending, whatever its case, packed or not; those that can hold a result read it back.
BOOST_FIXTURE_TEST_CASE(formats_are_known_by_their_endings, Folder)
{
  Result_mesh triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.faces = {{0, 1, 2}};
  for (const files::Mesh_format f : all<files::Mesh_format>())
  {
    const std::string ending = name_of(f);
    BOOST_TEST((files::format_of("a.b/endings." + ending) == f), ending);
    BOOST_TEST(
      (files::format_of("A." + std::string(1, static_cast<char>(std::toupper(ending[0]))) + ending.substr(1) + ".GZ")
       == f),
      ending);
    const std::string out = (path / ("endings." + ending)).string();
    if (!files::holds_vertices(f))
    {
      BOOST_CHECK_THROW(files::check_writable_format(out), files::File_error);
      continue;
    }
    std::ofstream(out, std::ios::binary) << files::format_mesh(out, triangle);
    BOOST_TEST((files::read_mesh(out).points == triangle.points), ending);
  }
  for (const char* other : {"obj", "a.b/obj", "a.objx", "a.obj.zip", "a.", ""})
  {
    BOOST_TEST(!files::format_of(other).has_value(), other);
  }
}
