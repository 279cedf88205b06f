// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_file.h"

#include "Map_writers.h"
#include "Mesh_format.h"
#include "read_mesh.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace meridian {
namespace files {

namespace {

template <class Writer> void write_origin(const Result_origin& o, Writer& out)
{
  out.begin_list(o.kind == Result_origin::VERTEX ? 1 : o.kind == Result_origin::EDGE ? 3 : 4);
  out.write(o.index[0]);
  if (o.kind == Result_origin::EDGE)
  {
    out.write(o.index[1]);
    out.write(o.weight[0]);
  }
  if (o.kind == Result_origin::FACE)
  {
    for (double w : o.weight) { out.write(w); }
  }
  out.end_list();
}

template <class Writer, class Range, class Write>
void write_list(const char* key, const Range& range, Writer& out, const Write& write)
{
  out.key(key);
  out.begin_list(range.size());
  for (const auto& x : range) { write(x); }
  out.end_list();
}

template <class Writer> void write_field(const Result_curve& c, Writer& out)
{
  out.begin_dictionary(2);
  out.key("curve");
  out.write(c.name);
  write_list("values", c.field, out, [&](const auto& entry) {
    out.begin_list(2);
    out.write(entry.first);
    out.write(entry.second);
    out.end_list();
  });
  out.end_dictionary();
}

template <class Writer>
std::string format(const Result_mesh& m, Result_kind kind, const std::vector<Result_curve>& curves)
{
  Writer out;
  out.reserve(3 * m.origin.size() + 2 * m.face_of.size());
  const auto index = [&](std::int32_t i) { out.write(i); };
  const bool is_cut = kind == Result_kind::CUT, has_fields = kind == Result_kind::GENERATORS;
  out.begin_dictionary(5 + !is_cut + has_fields + !m.chart_of.empty());
  if (!is_cut)
  {
    out.key("result");
    out.write(std::string(has_fields ? "generators" : "unwrapping"));
  }
  write_list("copy_of", m.copy_of, out, index);
  write_list("origin", m.origin, out, [&](const Result_origin& o) { write_origin(o, out); });
  write_list("face_of", m.face_of, out, index);
  write_list("component_of", m.component_of, out, index);
  if (!m.chart_of.empty()) { write_list("chart_of", m.chart_of, out, index); }
  write_list("seams", m.seams, out, [&](const std::array<std::int32_t, 2>& s) {
    out.begin_list(2);
    out.write(s[0]);
    out.write(s[1]);
    out.end_list();
  });
  if (has_fields)
  {
    std::vector<Result_curve> flow;
    std::copy_if(curves.begin(), curves.end(), std::back_inserter(flow),
                 [](const Result_curve& c) { return !c.field.empty(); });
    write_list("fields", flow, out, [&](const Result_curve& c) { write_field(c, out); });
  }
  out.end_dictionary();
  return out.take();
}

} // namespace

std::string format_map(const Result_mesh& mesh, Result_kind kind, Map_format map_format,
                       const std::vector<Result_curve>& curves)
{
  return map_format == Map_format::CBOR ? format<Cbor_writer>(mesh, kind, curves)
                                        : format<Json_writer>(mesh, kind, curves);
}

std::string stem_of(const std::string& path)
{
  std::string stem = path;
  if (is_packed(stem)) { stem.resize(stem.size() - 3); }
  const std::size_t dot = stem.find_last_of('.'), slash = stem.find_last_of('/');
  if (dot != std::string::npos && (slash == std::string::npos || dot > slash)) { stem.resize(dot); }
  return stem;
}

std::string map_path(const std::string& path, Map_format format) { return stem_of(path) + ".map." + name_of(format); }

std::string find_map(const std::string& path)
{
  const std::string text = map_path(path), binary = map_path(path, Map_format::CBOR);
  if (!std::filesystem::exists(binary)) { return text; }
  if (std::filesystem::exists(text))
  {
    throw File_error(text + " and " + binary + " are both the map of one result; remove the one that is older");
  }
  return binary;
}

} // namespace files
} // namespace meridian
