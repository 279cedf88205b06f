// SPDX-License-Identifier: GPL-3.0-or-later
// Every vertex of a result is a point of the input: a weight for each of up to three vertices, in rational numbers that
// add up to 1. All else is read from these places. On each triangle of the input the sides of its parts cancel in
// pairs, but for a chain around its rim; with parts that are all turned one way, it is then covered once. What cancels,
// there or across an edge of the input, is one edge of the result or a seam. A piece is a disc if it can be collapsed
// to a tree. Curves are a basis if they and what bounds generate all cycles, counted modulo primes.
#include "recount/recount.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace recount {

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Json = nlohmann::json;
using Pair = std::pair<int, int>;
using Place = std::vector<std::pair<int, Rational>>; // vertices of the input and their weights, none zero, ascending

struct File
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<int>> faces, texture_faces;
  std::vector<std::array<double, 2>> texture;
  std::vector<std::pair<std::string, std::vector<int>>> lines;
};

struct Failure
{
  std::string text;
};

void require(bool holds, const std::string& text)
{
  if (!holds) { throw Failure{text}; }
}

double number(std::istream& in)
{
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);
}

File read_off(std::istream& in)
{
  std::string head;
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> head >> vertices >> faces >> edges;
  File file;
  for (std::size_t i = 0; i < vertices; ++i)
  {
    const double x = number(in), y = number(in), z = number(in);
    file.points.push_back({x, y, z});
  }
  for (std::size_t i = 0; i < faces; ++i)
  {
    std::size_t size = 0;
    in >> size;
    auto& face = file.faces.emplace_back(size);
    for (int& v : face) { in >> v; }
  }
  return file;
}

File read_obj(std::istream& in)
{
  File file;
  std::string group;
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "v")
    {
      const double x = number(words), y = number(words), z = number(words);
      file.points.push_back({x, y, z});
    }
    if (key == "vt")
    {
      const double x = number(words), y = number(words);
      file.texture.push_back({x, y});
    }
    if (key == "g") { words >> group; }
    if (key == "l") { file.lines.emplace_back(group, std::vector<int>()); }
    if (key == "f")
    {
      file.faces.emplace_back();
      file.texture_faces.emplace_back();
    }
    while ((key == "l" || key == "f") && words >> word)
    {
      (key == "l" ? file.lines.back().second : file.faces.back()).push_back(std::atoi(word.c_str()) - 1);
      const std::size_t slash = word.find('/');
      if (key == "f" && slash != std::string::npos)
        file.texture_faces.back().push_back(std::atoi(word.c_str() + slash + 1) - 1);
    }
  }
  return file;
}

File read(const std::string& path)
{
  std::ifstream in(path);
  require(in.good(), path + " cannot be read");
  return path.substr(path.size() - 4) == ".off" ? read_off(in) : read_obj(in);
}

// Polygons as triangles, all of them from their lowest corner; what stands at their corners is of `ids`.
std::vector<std::array<int, 3>> fans(const File& file, const std::vector<std::vector<int>>& ids,
                                     std::vector<int>& polygon_of)
{
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t p = 0; p < file.faces.size(); ++p)
  {
    const std::vector<int>& face = file.faces[p];
    const std::size_t n = face.size(), lowest = std::min_element(face.begin(), face.end()) - face.begin();
    require(ids[p].size() == n && n > 2, "a face without texture coordinates, or without area");
    for (std::size_t k = 1; k + 1 < n; ++k)
    {
      const std::size_t first = n == 3 ? 0 : lowest;
      triangles.push_back({ids[p][first], ids[p][(first + k) % n], ids[p][(first + k + 1) % n]});
      polygon_of.push_back(static_cast<int>(p));
    }
  }
  return triangles;
}

bool is_same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

Rational determinant(const std::array<std::array<Rational, 3>, 3>& m)
{
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
         + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The side that three points in the plane turn to: 1 for left.
int turn(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c)
{
  const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
  if (std::abs(left - right) > 1e-14 * (std::abs(left) + std::abs(right)) && std::abs(left - right) > 1e-290)
    return left > right ? 1 : -1;
  const Rational x = (Rational(b[0]) - a[0]) * (Rational(c[1]) - a[1]),
                 y = (Rational(b[1]) - a[1]) * (Rational(c[0]) - a[0]);
  return x > y ? 1 : x < y ? -1 : 0;
}

class Recount
{
public:
  Recount(const std::string& input, const std::string& result) : m_input(read(input)), m_result(read(result))
  {
    const std::string map_path = result.substr(0, result.size() - 4) + ".map.json";
    std::ifstream in(map_path);
    require(in.good(), map_path + " cannot be read");
    m_map = Json::parse(in);
    m_kind = m_map.value("result", "cut");
    std::vector<int> ignored;
    m_triangles = fans(m_input, m_input.faces, m_polygon_of);
    m_corners = fans(m_result, m_result.faces, ignored);
    m_faces = fans(m_result, m_kind == "unwrapping" ? m_result.texture_faces : m_result.faces, ignored);
  }

  void run()
  {
    read_vertices();
    assign_faces();
    for (std::size_t t = 0; t < m_triangles.size(); ++t) { cover(static_cast<int>(t)); }
    cross_edges();
    check_edges();
    check_links();
    check_components();
    if (m_kind == "unwrapping") { check_layout(); }
    if (m_kind == "generators") { check_curves(); }
  }

private:
  static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
  int id(int side) const { return m_faces[side / 3][side % 3]; }
  Pair ids(int side) const { return {id(side), id(next(side))}; }
  Pair places(int side) const { return {m_place_of[id(side)], m_place_of[id(next(side))]}; }
  int vertex_in_file(int i) const { return m_kind == "unwrapping" && m_copy_of[i] >= 0 ? m_copy_of[i] : i; }

  Place place(const Json& origin) const
  {
    Place p;
    if (origin.size() == 1) { p = {{origin[0].get<int>(), 1}}; }
    if (origin.size() == 3)
    {
      const Rational t(origin[2].get<double>());
      p = {{origin[0].get<int>(), 1 - t}, {origin[1].get<int>(), t}};
    }
    if (origin.size() == 4)
    {
      Rational sum = 0;
      for (int k = 0; k < 3; ++k)
      {
        p.emplace_back(m_triangles.at(origin[0].get<std::size_t>())[k], Rational(origin[k + 1].get<double>()));
        sum += p.back().second;
      }
      for (auto& [v, weight] : p) { weight /= sum; }
    }
    std::sort(p.begin(), p.end());
    for (const auto& [v, weight] : p) { require(weight > 0, "a weight is not positive"); }
    require(!p.empty() && p.front().first >= 0 && p.back().first < static_cast<int>(m_input.points.size()),
            "no origin");
    return p;
  }

  // The position that an origin stands for, rounded after each operation.
  std::array<double, 3> position(const Json& o) const
  {
    const auto& p = m_input.points;
    std::array<double, 3> at{};
    for (int k = 0; k < 3; ++k)
    {
      if (o.size() == 1) { at[k] = p[o[0]][k]; }
      if (o.size() == 3) { at[k] = p[o[0]][k] + o[2].get<double>() * (p[o[1]][k] - p[o[0]][k]); }
      if (o.size() == 4)
      {
        const auto& t = m_triangles[o[0]];
        at[k] = (o[1].get<double>() * p[t[0]][k] + o[2].get<double>() * p[t[1]][k]) + o[3].get<double>() * p[t[2]][k];
      }
    }
    return at;
  }

  void read_vertices()
  {
    m_copy_of = m_map["copy_of"].get<std::vector<int>>();
    const Json& origins = m_map["origin"];
    const std::size_t n = m_kind == "unwrapping" ? m_result.texture.size() : m_result.points.size();
    require(m_copy_of.size() == n && origins.size() == n, "the map is of other vertices");
    const auto own = static_cast<std::size_t>(std::count(m_copy_of.begin(), m_copy_of.end(), -1));
    require(own >= m_input.points.size(), "vertices of the input are missing");
    require(m_kind != "unwrapping" || own == m_result.points.size(), "vertices of the file are missing");
    for (std::size_t i = 0; i < n; ++i)
    {
      const int copied = m_copy_of[i];
      require((copied == -1) == (i < own) && copied < static_cast<int>(own), "copies do not stand at the end");
      require(copied < 0 || origins[i] == origins[copied], "a copy lies elsewhere");
      const bool is_of_input = i < m_input.points.size();
      require(!is_of_input || (origins[i].size() == 1 && origins[i][0] == i),
              "a vertex of the input is not in its place");
      require(is_of_input || copied >= 0 || origins[i].size() > 1, "a vertex of the input is there twice");
      const auto known = m_places.try_emplace(place(origins[i]), static_cast<int>(m_place.size()));
      if (known.second) { m_place.push_back(known.first->first); }
      m_place_of.push_back(known.first->second);
      const auto at = position(origins[i]);
      const auto& found = m_result.points[vertex_in_file(static_cast<int>(i))];
      for (int k = 0; k < 3; ++k) { require(is_same(at[k], found[k]), "vertex " + std::to_string(i) + " has moved"); }
    }
    for (const auto& f : m_faces)
      for (int v : f) { require(v >= 0 && v < static_cast<int>(n), "a face names no vertex"); }
  }

  // Weights of a place on a triangle; nothing if it lies elsewhere.
  bool weights_on(int t, int place, std::array<Rational, 3>& weights) const
  {
    std::size_t found = 0;
    for (int k = 0; k < 3; ++k)
    {
      weights[k] = 0;
      for (const auto& [v, weight] : m_place[place])
        if (v == m_triangles[t][k])
        {
          weights[k] = weight;
          ++found;
        }
    }
    return found == m_place[place].size();
  }

  bool repeats(int t) const { return std::set<int>(m_triangles[t].begin(), m_triangles[t].end()).size() < 3; }

  // The triangle of each face, and how it is turned on it.
  void assign_faces()
  {
    const auto polygon = m_map["face_of"].get<std::vector<int>>();
    require(polygon.size() == m_faces.size(), "the map is of other faces");
    std::map<int, std::vector<int>> triangles_of;
    for (std::size_t t = 0; t < m_triangles.size(); ++t) triangles_of[m_polygon_of[t]].push_back(static_cast<int>(t));
    m_parts.resize(m_triangles.size());
    m_sign.assign(m_triangles.size(), 0);
    for (std::size_t f = 0; f < m_faces.size(); ++f)
    {
      int found = 0;
      for (int t : triangles_of[polygon[f]])
      {
        std::array<std::array<Rational, 3>, 3> m;
        bool is_on = !repeats(t);
        for (int k = 0; k < 3; ++k) { is_on = is_on && weights_on(t, m_place_of[m_faces[f][k]], m[k]); }
        if (!is_on) { continue; }
        const int sign = determinant(m).sign();
        if (sign == 0) { continue; }
        ++found;
        require(m_sign[t] == 0 || m_sign[t] == sign, "parts of a face fold over");
        m_sign[t] = sign;
        m_parts[t].push_back(static_cast<int>(f));
      }
      require(found == 1, "face " + std::to_string(f) + " is no part of its face");
    }
  }

  void join(int a, int b)
  {
    require(m_mate.emplace(a, b).second && m_mate.emplace(b, a).second, "a side has two neighbours");
  }

  // Cancels the sides of the parts of a triangle, and keeps those of its rim, which must go round it.
  void cover(int t)
  {
    require(m_parts[t].empty() == repeats(t), "triangle " + std::to_string(t) + " is not covered, or must not be");
    std::map<Pair, int> open;
    for (int f : m_parts[t])
      for (int side = 3 * f; side < 3 * f + 3; ++side)
      {
        const auto [a, b] = places(side);
        const auto other = open.find({b, a});
        if (other == open.end())
        {
          require(open.emplace(Pair{a, b}, side).second, "a side is there twice");
          continue;
        }
        join(side, other->second);
        open.erase(other);
      }
    std::array<std::map<Rational, std::pair<Rational, int>>, 3> rim; // of each side of the triangle: from, to, side
    for (const auto& [ends, side] : open)
    {
      std::array<Rational, 3> a, b;
      weights_on(t, ends.first, a);
      weights_on(t, ends.second, b);
      int k = 0;
      while (k < 3 && !(a[k] == 0 && b[k] == 0)) { ++k; }
      require(k < 3, "triangle " + std::to_string(t) + " has a gap");
      const int to = m_sign[t] > 0 ? (k + 2) % 3 : (k + 1) % 3;
      require(rim[k].emplace(a[to], std::make_pair(b[to], side)).second, "the rim of a triangle is there twice");
    }
    for (int k = 0; k < 3 && !m_parts[t].empty(); ++k)
    {
      Rational at = 0;
      for (const auto& [from, step] : rim[k])
      {
        require(from == at && step.first > from, "the rim of triangle " + std::to_string(t) + " has a gap");
        at = step.first;
        const Pair edge = std::minmax(m_triangles[t][(k + 1) % 3], m_triangles[t][(k + 2) % 3]);
        m_on_edge[edge][std::minmax(places(step.second).first, places(step.second).second)].push_back(step.second);
        m_triangles_at[edge].insert(t);
      }
      require(at == 1, "the rim of triangle " + std::to_string(t) + " has a gap");
    }
  }

  // Joins what meets at edges of the input. Where more than two triangles do, the result says which of them still do.
  void cross_edges()
  {
    for (const auto& pair : m_map["seams"])
    {
      const Pair sides = std::minmax(pair[0].get<int>(), pair[1].get<int>());
      require(m_seams.insert(sides).second, "a seam is listed twice");
    }
    for (const auto& [edge, stretches] : m_on_edge)
      for (const auto& [ends, sides] : stretches)
      {
        const std::size_t n = m_triangles_at[edge].size();
        require(sides.size() == n || n > 2, "an edge is divided otherwise on its other side");
        for (std::size_t i = 0; i < sides.size(); ++i)
          for (std::size_t j = i + 1; j < sides.size(); ++j)
            if (n == 2 || are_one(sides[i], sides[j]) || m_seams.count(std::minmax(sides[i], sides[j])))
              join(sides[i], sides[j]);
      }
  }

  bool are_one(int a, int b) const { return ids(a).first == ids(b).second && ids(a).second == ids(b).first; }

  // Neighbours on the input are one edge of the result or a seam, and nothing else is either.
  void check_edges()
  {
    std::size_t seams = 0;
    std::map<Pair, std::vector<int>> known;
    for (int side = 0; side < static_cast<int>(3 * m_faces.size()); ++side)
    {
      known[std::minmax(ids(side).first, ids(side).second)].push_back(side);
      const auto mate = m_mate.find(side);
      if (mate == m_mate.end() || mate->second < side) { continue; }
      require(places(side).first == places(mate->second).second && places(side).second == places(mate->second).first,
              "faces disagree with their neighbours");
      const bool is_seam = m_seams.count({side, mate->second}) != 0;
      require(is_seam != are_one(side, mate->second), "a side neither goes on nor is a seam, or both");
      seams += is_seam;
    }
    require(seams == m_seams.size(), "a seam is none");
    for (const auto& [ends, sides] : known)
    {
      require(sides.size() == 1 || (sides.size() == 2 && m_mate.count(sides[0]) && m_mate[sides[0]] == sides[1]),
              "faces that are no neighbours share an edge");
    }
  }

  bool goes_on(int side) const { return m_mate.count(side) != 0 && are_one(side, m_mate.at(side)); }

  // The faces around each vertex are one fan.
  void check_links()
  {
    std::map<int, std::set<int>> corners; // sides that begin at a vertex
    for (int side = 0; side < static_cast<int>(3 * m_faces.size()); ++side) { corners[id(side)].insert(side); }
    for (auto& [v, left] : corners)
    {
      std::vector<int> open{*left.begin()};
      left.erase(left.begin());
      while (!open.empty())
      {
        const int side = open.back(), before = next(next(side));
        open.pop_back();
        for (int other : {goes_on(side) ? next(m_mate[side]) : -1, goes_on(before) ? m_mate[before] : -1})
          if (left.erase(other)) { open.push_back(other); }
      }
      require(left.empty(), "vertex " + std::to_string(v) + " is pinched");
    }
    for (std::size_t i = m_input.points.size(); i < m_copy_of.size(); ++i)
      require(corners.count(static_cast<int>(i)) != 0, "vertex " + std::to_string(i) + " is of no face");
  }

  // Numbers faces by what they are joined to, in the order of the first face of each.
  template <class Joins> std::vector<int> number_pieces(const Joins& joins) const
  {
    std::vector<int> piece(m_faces.size(), -1);
    int pieces = 0;
    for (std::size_t first = 0; first < m_faces.size(); ++first)
    {
      if (piece[first] >= 0) { continue; }
      std::vector<int> open{static_cast<int>(first)};
      piece[first] = pieces;
      while (!open.empty())
      {
        const int f = open.back();
        open.pop_back();
        for (int side = 3 * f; side < 3 * f + 3; ++side)
        {
          if (!joins(side) || piece[m_mate.at(side) / 3] >= 0) { continue; }
          piece[m_mate.at(side) / 3] = pieces;
          open.push_back(m_mate.at(side) / 3);
        }
      }
      ++pieces;
    }
    return piece;
  }

  void check_components()
  {
    m_component = number_pieces([&](int side) { return m_mate.count(side) != 0; });
    require(m_map["component_of"] == m_component, "components are numbered otherwise");
    if (m_kind == "generators")
    {
      require(m_seams.empty(), "generators have seams");
      return;
    }
    const std::vector<int> piece = number_pieces([&](int side) { return goes_on(side); });
    const std::vector<int> expected = m_map.value("chart_of", m_component);
    std::map<int, int> piece_of, expected_of;
    for (std::size_t f = 0; f < piece.size(); ++f)
    {
      require(piece_of.try_emplace(expected[f], piece[f]).first->second == piece[f], "a piece has fallen apart");
      require(expected_of.try_emplace(piece[f], expected[f]).first->second == expected[f], "pieces hang together");
    }
    std::vector<std::vector<int>> faces(expected_of.size());
    for (std::size_t f = 0; f < piece.size(); ++f) { faces[piece[f]].push_back(static_cast<int>(f)); }
    for (const auto& of_piece : faces) { collapse(of_piece); }
  }

  // Takes faces away from their free sides until none is left; what stays of edges must be a tree.
  void collapse(const std::vector<int>& faces) const
  {
    std::map<Pair, std::set<int>> at; // edges and the faces that are left there
    std::set<int> vertices;
    for (int f : faces)
      for (int side = 3 * f; side < 3 * f + 3; ++side)
      {
        at[std::minmax(ids(side).first, ids(side).second)].insert(f);
        vertices.insert(id(side));
      }
    std::vector<Pair> free;
    for (const auto& [edge, left] : at)
      if (left.size() == 1) { free.push_back(edge); }
    std::size_t faces_left = faces.size();
    while (!free.empty())
    {
      const auto edge = at.find(free.back());
      free.pop_back();
      if (edge == at.end() || edge->second.empty()) { continue; }
      const int f = *edge->second.begin();
      at.erase(edge);
      --faces_left;
      for (int side = 3 * f; side < 3 * f + 3; ++side)
      {
        const Pair other = std::minmax(ids(side).first, ids(side).second);
        const auto found = at.find(other);
        if (found != at.end() && found->second.erase(f) && found->second.size() == 1) { free.push_back(other); }
      }
    }
    require(faces_left == 0, "a piece has no border");
    std::map<int, std::vector<int>> graph;
    for (const auto& [edge, left] : at)
    {
      graph[edge.first].push_back(edge.second);
      graph[edge.second].push_back(edge.first);
    }
    std::set<int> reached{*vertices.begin()};
    std::vector<int> open{*vertices.begin()};
    while (!open.empty())
    {
      const int v = open.back();
      open.pop_back();
      for (int w : graph[v])
        if (reached.insert(w).second) { open.push_back(w); }
    }
    require(reached == vertices && at.size() + 1 == vertices.size(), "a piece is no disc");
  }

  // Every face is turned one way in the plane, in one tile, and lies over no other.
  void check_layout() const
  {
    using Box = std::array<double, 4>;
    std::vector<std::array<std::array<double, 2>, 3>> at;
    std::vector<Box> box;
    for (std::size_t f = 0; f < m_faces.size(); ++f)
    {
      std::array<std::array<double, 2>, 3> p;
      for (int k = 0; k < 3; ++k)
      {
        p[k] = m_result.texture[m_faces[f][k]];
        require(m_corners[f][k] == vertex_in_file(m_faces[f][k]), "a texture coordinate is of another vertex");
      }
      require(turn(p[0], p[1], p[2]) > 0, "face " + std::to_string(f) + " is turned over");
      Box b;
      for (int k : {0, 1})
      {
        b[k] = std::min({p[0][k], p[1][k], p[2][k]});
        b[k + 2] = std::max({p[0][k], p[1][k], p[2][k]});
        require(b[k] >= 0 && b[k + 2] <= std::floor(b[k]) + 1, "face " + std::to_string(f) + " lies in two tiles");
      }
      for (std::size_t g = 0; g < at.size(); ++g)
      {
        if (b[0] >= box[g][2] || b[2] <= box[g][0] || b[1] >= box[g][3] || b[3] <= box[g][1]) { continue; }
        require(is_beside(p, at[g]) || is_beside(at[g], p),
                "faces " + std::to_string(g) + " and " + std::to_string(f) + " overlap");
      }
      at.push_back(p);
      box.push_back(b);
    }
  }

  // Whether a triangle lies on the outer side of one of the sides of another.
  static bool is_beside(const std::array<std::array<double, 2>, 3>& p, const std::array<std::array<double, 2>, 3>& q)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (std::all_of(q.begin(), q.end(), [&](const auto& r) { return turn(p[k], p[(k + 1) % 3], r) <= 0; }))
        return true;
    }
    return false;
  }

  // Curves are closed and simple, two of a pair meet once and others never, and together they are a basis.
  void check_curves() const
  {
    std::map<Pair, int> edges;
    std::vector<std::map<int, int>> bounds, curves; // edges and how often each goes along them
    std::set<int> used;
    const auto add = [&](std::map<int, int>& chain, int v, int w) {
      const int e = edges.try_emplace(std::minmax(v, w), static_cast<int>(edges.size())).first->second;
      chain[e] += v < w ? 1 : -1;
    };
    for (std::size_t f = 0; f < m_faces.size(); ++f)
    {
      bounds.emplace_back();
      for (int side = static_cast<int>(3 * f); side < static_cast<int>(3 * f + 3); ++side)
      {
        add(bounds.back(), id(side), id(next(side)));
        used.insert(id(side));
      }
    }
    const std::size_t number_of_edges = edges.size();
    std::map<int, int> along; // the border, from vertex to vertex
    for (int side = 0; side < static_cast<int>(3 * m_faces.size()); ++side)
      if (!goes_on(side)) { along[id(side)] = id(next(side)); }
    std::set<std::set<int>> loops; // by their edges
    const auto edges_of = [](const std::map<int, int>& chain) {
      std::set<int> all;
      for (const auto& entry : chain) { all.insert(entry.first); }
      return all;
    };
    while (!along.empty())
    {
      bounds.emplace_back();
      for (auto at = along.begin(); at != along.end();)
      {
        const auto [v, w] = *at;
        add(bounds.back(), v, w);
        along.erase(at);
        at = along.find(w);
      }
      loops.insert(edges_of(bounds.back()));
    }
    std::vector<std::string> names;
    std::vector<std::set<int>> vertices;
    for (const auto& [name, line] : m_result.lines)
    {
      require(line.size() > 3 && line.front() == line.back(), name + " is not closed");
      std::map<int, int> chain;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) { add(chain, line[i], line[i + 1]); }
      require(edges.size() == number_of_edges, name + " leaves the edges");
      const std::set<int> on(line.begin(), line.end());
      require(on.size() + 1 == line.size(), name + " is not simple");
      if (name.find("boundary") == 0)
      {
        require(loops.erase(edges_of(chain)) == 1, name + " is no boundary loop");
        continue;
      }
      curves.push_back(chain);
      vertices.push_back(on);
      names.push_back(name);
    }
    require(loops.empty(), "a boundary loop is missing");
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (std::size_t j = i + 1; j < curves.size() && names[i].find("loop") == std::string::npos; ++j)
      {
        std::vector<int> common;
        std::set_intersection(vertices[i].begin(), vertices[i].end(), vertices[j].begin(), vertices[j].end(),
                              std::back_inserter(common));
        const bool is_pair = names[i].substr(names[i].find('_')) == names[j].substr(names[j].find('_'));
        require(common.size() == (is_pair ? 1u : 0u), "curves meet where they must not");
      }
    const int components = m_component.empty() ? 0 : 1 + *std::max_element(m_component.begin(), m_component.end());
    const std::size_t cycles = number_of_edges + static_cast<std::size_t>(components) - used.size();
    for (int prime : {2, 3, 5, 1000003})
    {
      std::vector<std::map<int, int>> all = bounds;
      const std::size_t bounding = rank(all, prime);
      all.insert(all.end(), curves.begin(), curves.end());
      require(rank(all, prime) == cycles && bounding + curves.size() == cycles,
              "the curves are no basis modulo " + std::to_string(prime));
    }
  }

  // The rank of rows modulo a prime: each is reduced by those before that begin where it does.
  static std::size_t rank(const std::vector<std::map<int, int>>& rows, long long prime)
  {
    std::map<int, std::map<int, long long>> reduced; // by their first column
    for (const auto& row : rows)
    {
      std::map<int, long long> left(row.begin(), row.end());
      while (!left.empty())
      {
        const auto [column, value] = *left.begin();
        const auto by = reduced.find(column);
        if (value % prime == 0) { left.erase(left.begin()); }
        else if (by == reduced.end())
        {
          reduced.emplace(column, left);
          break;
        }
        else
        {
          const long long first = by->second.begin()->second;
          for (auto& entry : left) { entry.second = entry.second * first % prime; }
          for (const auto& [other, x] : by->second) { left[other] = (left[other] - value * x) % prime; }
        }
      }
    }
    return reduced.size();
  }

  File m_input, m_result;
  Json m_map;
  std::string m_kind;
  std::vector<std::array<int, 3>> m_triangles, m_corners,
    m_faces; // of the input; of the result, by vertices of the file and of the map
  std::vector<int> m_polygon_of, m_copy_of, m_place_of, m_sign, m_component;
  std::map<Place, int> m_places;
  std::vector<Place> m_place;
  std::vector<std::vector<int>> m_parts;                      // of each triangle
  std::map<int, int> m_mate;                                  // of sides: the neighbour on the input
  std::map<Pair, std::map<Pair, std::vector<int>>> m_on_edge; // of edges of the input: by places, sides
  std::map<Pair, std::set<int>> m_triangles_at;
  std::set<Pair> m_seams;
};

} // namespace

std::vector<std::string> failures_of(const std::string& input, const std::string& result)
{
  try
  {
    Recount(input, result).run();
    return {};
  }
  catch (const Failure& f)
  {
    return {f.text};
  }
  catch (const std::exception& e)
  {
    return {e.what()};
  }
}

} // namespace recount
