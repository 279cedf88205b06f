// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_file.h"

#include "Mesh_format.h"
#include "read_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace meridian {
namespace files {

namespace {

using Json = nlohmann::json;

// Takes what a map file holds as it comes, so that nothing is kept but the result. Throws File_error.
class Map_reader : public nlohmann::json_sax<Json>
{
public:
  Map_reader(const std::string& path, Result_mesh& mesh, std::vector<Result_curve>& fields)
    : m_path(path), m_mesh(mesh), m_fields(fields)
  {}

  // What the result is, after all was read.
  Result_kind kind() const
  {
    for (const char* key : {"copy_of", "origin", "face_of", "component_of", "seams"})
    {
      if (m_seen.count(key) == 0) { fail("it has no \"" + std::string(key) + '"'); }
    }
    if (m_kind != "cut" && m_kind != "generators" && m_kind != "unwrapping")
    {
      throw File_error(m_path + ": a map of an unknown result '" + m_kind + "'");
    }
    return m_kind == "generators"   ? Result_kind::GENERATORS
           : m_kind == "unwrapping" ? Result_kind::UNWRAPPING
                                    : Result_kind::CUT;
  }

  bool start_object(std::size_t) override
  {
    if (m_depth == 2 && m_key == "fields") { m_fields.emplace_back(); }
    else if (m_depth != 0) { fail("a dictionary stands where a map has none"); }
    ++m_depth;
    return true;
  }
  bool key(std::string& name) override
  {
    static const std::set<std::string> known{"result",       "copy_of",  "origin", "face_of",
                                             "component_of", "chart_of", "seams",  "fields"};
    if (m_depth == 1 && known.count(name) == 0) { fail('"' + name + "\" is no part of a map"); }
    if (m_depth == 1 && !m_seen.insert(name).second) { fail('"' + name + "\" stands there twice"); }
    (m_depth == 1 ? m_key : m_field_key) = name;
    return true;
  }
  bool end_object() override
  {
    --m_depth;
    return true;
  }
  bool start_array(std::size_t) override
  {
    constexpr int deepest = 5;
    if (m_depth == 0 || m_depth >= deepest) { fail("a list stands where a map has none"); }
    ++m_depth;
    m_entry.clear();
    return true;
  }
  bool end_array() override
  {
    --m_depth;
    if (m_depth == 2 || m_depth == 4) { take_entry(); }
    return true;
  }
  bool number_integer(std::int64_t x) override { return take({static_cast<double>(x), x}); }
  bool number_unsigned(std::uint64_t x) override
  {
    constexpr std::uint64_t most = 1u << 31;
    return take({static_cast<double>(x), static_cast<std::int64_t>(std::min(x, most))});
  }
  bool number_float(double x, const std::string&) override { return take({x, std::nullopt}); }
  bool string(std::string& s) override
  {
    if (m_depth == 1 && m_key == "result") { m_kind = s; }
    else if (m_depth == 3 && m_key == "fields" && m_field_key == "curve") { m_fields.back().name = s; }
    else { fail("a text stands where a map has none"); }
    return true;
  }
  bool null() override { fail("a null stands where a map has none"); }
  bool boolean(bool) override { fail("a truth value stands where a map has none"); }
  bool binary(Json::binary_t&) override { fail("bytes stand where a map has none"); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override { fail(e.what()); }

private:
  struct Number
  {
    double value;
    std::optional<std::int64_t> whole;
  };

  [[noreturn]] void fail(const std::string& what) const { throw File_error(m_path + ": not a map file: " + what); }

  std::int32_t index(const Number& x) const
  {
    if (!x.whole || *x.whole > 2147483647 || *x.whole < -2147483647)
    {
      throw File_error(m_path + ": an index is not a whole number in range");
    }
    return static_cast<std::int32_t>(*x.whole);
  }

  // A number of a list of numbers, or of an entry of a list of lists.
  bool take(const Number& x)
  {
    constexpr std::size_t longest = 5; // one more than any entry has
    if (m_depth == 2)
    {
      if (m_key == "copy_of") { m_mesh.copy_of.push_back(index(x)); }
      else if (m_key == "face_of") { m_mesh.face_of.push_back(index(x)); }
      else if (m_key == "component_of") { m_mesh.component_of.push_back(index(x)); }
      else if (m_key == "chart_of") { m_mesh.chart_of.push_back(index(x)); }
      else { fail("a number stands where a map has none"); }
    }
    else if (m_depth != (m_key == "fields" ? 5 : 3)) { fail("a number stands where a map has none"); }
    else if (m_entry.size() < longest) { m_entry.push_back(x); }
    return true;
  }

  void take_entry()
  {
    const std::size_t size = m_entry.size();
    if (m_depth == 2 && m_key == "origin") { m_mesh.origin.push_back(origin()); }
    else if (m_depth == 2 && m_key == "seams" && size == 2)
    {
      m_mesh.seams.push_back({index(m_entry[0]), index(m_entry[1])});
    }
    else if (m_depth == 4 && m_key == "fields" && m_field_key == "values" && size == 2)
    {
      m_fields.back().field.emplace(index(m_entry[0]), m_entry[1].value);
    }
    else { fail("a list of " + std::to_string(size) + " numbers stands where a map has none"); }
    m_entry.clear();
  }

  Result_origin origin() const
  {
    if (m_entry.size() != 1 && m_entry.size() != 3 && m_entry.size() != 4)
    {
      throw File_error(m_path + ": an origin has " + std::to_string(m_entry.size()) + " entries");
    }
    Result_origin o;
    o.index[0] = index(m_entry[0]);
    if (m_entry.size() == 3)
    {
      o.kind = Result_origin::EDGE;
      o.index[1] = index(m_entry[1]);
      o.weight[0] = m_entry[2].value;
    }
    if (m_entry.size() == 4)
    {
      o.kind = Result_origin::FACE;
      for (std::size_t i = 0; i < 3; ++i) { o.weight[i] = m_entry[i + 1].value; }
    }
    return o;
  }

  const std::string& m_path;
  Result_mesh& m_mesh;
  std::vector<Result_curve>& m_fields;
  std::string m_kind = "cut", m_key, m_field_key; // `m_field_key`: in a dictionary of `fields`
  std::set<std::string> m_seen;
  std::vector<Number> m_entry;
  int m_depth = 0;
};

} // namespace

Result_kind read_map(const std::string& path, Result_mesh& mesh, std::vector<Result_curve>& fields)
{
  const std::string bytes = read_bytes(path);
  const bool is_binary = ending_of(path) == name_of(Map_format::CBOR);
  Map_reader reader(path, mesh, fields);
  Json::sax_parse(bytes, &reader, is_binary ? Json::input_format_t::cbor : Json::input_format_t::json);
  return reader.kind();
}

} // namespace files
} // namespace meridian
