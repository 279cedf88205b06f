// SPDX-License-Identifier: GPL-3.0-or-later
// Alters results of the program at one place each, and asks `meridian verify` and the second recount for their verdict:
// neither may refuse what was not altered, `verify` may believe nothing that was, and where another place in the plane
// is as good as the first, both must say so. `alterations FIRST COUNT` alters COUNT times results of seeds FIRST on.
#include "random/random_mesh.h"

#include "recount/recount.h"
#include "support/run_program.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace random_runs {

namespace {

using Json = nlohmann::json;

// A result in its files, which can be altered: lines of words, and a map.
struct Files
{
  std::vector<std::vector<std::string>> mesh, result;
  Json map;
};

std::vector<std::vector<std::string>> words_of(const std::string& text)
{
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
  {
    lines.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word;) { lines.back().push_back(word); }
  }
  return lines;
}

std::string text_of(const std::vector<std::vector<std::string>>& lines)
{
  std::string text;
  for (const auto& line : lines)
  {
    for (std::size_t i = 0; i < line.size(); ++i) { text += (i > 0 ? " " : "") + line[i]; }
    text += '\n';
  }
  return text;
}

// Alters a file at a random place. Each returns whether there was such a place.
class Alteration
{
public:
  Alteration(Files& files, Random& random) : m_files(files), m_random(random) {}

  static constexpr int kinds = 21;

  static const char* name(int kind)
  {
    static const char* const names[kinds] = {
      "copy_of",          "origin, vertex",      "origin, weight", "face_of",        "component_of",
      "chart_of",         "seam left out",       "seam twice",     "seam of others", "seam more",
      "coordinate",       "coordinate by a bit", "corner",         "face left out",  "face twice",
      "face turned over", "texture coordinate",  "curve",          "curve left out", "input's point",
      "input's corner"};
    return names[kind];
  }

  bool apply(int kind)
  {
    Json& map = m_files.map;
    switch (kind)
    {
    case 0: return other_entry("copy_of", static_cast<int>(map["copy_of"].size()));
    case 1: return other_origin();
    case 2: return other_weight();
    case 3: return other_entry("face_of", static_cast<int>(map["face_of"].size()));
    case 4: return other_entry("component_of", 3);
    case 5: return other_entry("chart_of", 4);
    case 6:
    case 7:
    case 8: return other_seam(kind);
    case 9:
      map["seams"].push_back({m_random.below(sides()), m_random.below(sides())});
      return map["seams"].back()[0] != map["seams"].back()[1];
    case 10: return other_number(m_files.result, "v", 1 + m_random.below(3), 0.01);
    case 11: return other_number(m_files.result, "v", 1 + m_random.below(3), 0);
    case 12: return other_corner();
    case 13:
    case 14: return leave_out_or_repeat("f", kind == 14);
    case 15: return turn_over();
    case 16: return other_number(m_files.result, "vt", 1 + m_random.below(2), m_random.once_in(2) ? 0.1 : 0.001);
    case 17: return other_curve();
    case 18: return leave_out_or_repeat("l", false);
    case 19: return other_input_point();
    default: return other_input_corner();
    }
  }

private:
  int sides() const { return static_cast<int>(3 * m_files.map["face_of"].size()); }

  // A random line that begins with a word, or null.
  std::vector<std::string>* line(std::vector<std::vector<std::string>>& lines, const std::string& key)
  {
    std::vector<std::vector<std::string>*> all;
    for (auto& words : lines)
    {
      if (!words.empty() && words[0] == key) { all.push_back(&words); }
    }
    return all.empty() ? nullptr : m_random.one_of(all);
  }

  bool other_entry(const char* key, int range)
  {
    if (!m_files.map.contains(key) || m_files.map[key].empty()) { return false; }
    Json& entry = entry_of(m_files.map[key]);
    const int value = m_random.below(range + 1) - 1;
    const bool is_other = entry != value;
    entry = value;
    return is_other;
  }

  Json& entry_of(Json& list) { return list[static_cast<std::size_t>(m_random.below(static_cast<int>(list.size())))]; }

  bool other_origin()
  {
    Json& origin = entry_of(m_files.map["origin"]);
    Json& index = origin[origin.size() == 3 ? static_cast<std::size_t>(m_random.below(2)) : 0];
    const int value = m_random.below(static_cast<int>(m_files.map["origin"].size()));
    const bool is_other = index != value;
    index = value;
    return is_other;
  }

  bool other_weight()
  {
    Json& origin = entry_of(m_files.map["origin"]);
    if (origin.size() < 3) { return false; }
    Json& weight = origin[origin.size() == 3 ? 2 : 1 + static_cast<std::size_t>(m_random.below(3))];
    weight = m_random.once_in(2) ? m_random.fraction() : -weight.get<double>();
    return true;
  }

  bool other_seam(int kind)
  {
    Json& seams = m_files.map["seams"];
    if (seams.empty()) { return false; }
    const auto i = static_cast<std::size_t>(m_random.below(static_cast<int>(seams.size())));
    if (kind == 6) { seams.erase(i); }
    if (kind == 7) { seams.push_back(Json(seams[i])); }
    if (kind == 8)
    {
      Json& side = seams[i][static_cast<std::size_t>(m_random.below(2))];
      const int value = m_random.below(sides());
      if (side == value) { return false; }
      side = value;
    }
    return true;
  }

  // Moves a number by so much at most, or by its last bit.
  bool other_number(std::vector<std::vector<std::string>>& lines, const std::string& key, int place, double most)
  {
    auto* words = line(lines, key);
    return words && move((*words)[static_cast<std::size_t>(place)], most);
  }

  bool move(std::string& word, double most)
  {
    const double x = std::strtod(word.c_str(), nullptr);
    const double y = most > 0 ? x + most * (m_random.fraction() - 0.5) : std::nextafter(x, 1e308);
    if (!std::isfinite(x) || y == x) { return false; }
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", y);
    word = digits;
    return true;
  }

  bool other_corner()
  {
    auto* words = line(m_files.result, "f");
    auto* other = line(m_files.result, "f");
    if (!words) { return false; }
    std::string& corner = (*words)[1 + static_cast<std::size_t>(m_random.below(3))];
    const std::string value = (*other)[1 + static_cast<std::size_t>(m_random.below(3))];
    const bool is_other = std::find(words->begin(), words->end(), value) == words->end();
    corner = value;
    return is_other;
  }

  bool leave_out_or_repeat(const std::string& key, bool repeats)
  {
    const auto* words = line(m_files.result, key);
    if (!words) { return false; }
    const auto at = m_files.result.begin() + (words - m_files.result.data());
    if (repeats) { m_files.result.insert(at, std::vector<std::string>(*at)); }
    else { m_files.result.erase(at); }
    return true;
  }

  bool turn_over()
  {
    auto* words = line(m_files.result, "f");
    if (!words) { return false; }
    std::swap((*words)[1], (*words)[2]);
    return true;
  }

  bool other_curve()
  {
    auto* words = line(m_files.result, "l");
    auto* other = line(m_files.result, "f");
    if (!words || !other) { return false; }
    std::string& vertex = (*words)[1 + static_cast<std::size_t>(m_random.below(static_cast<int>(words->size()) - 1))];
    const bool is_other = vertex != (*other)[1];
    vertex = (*other)[1];
    return is_other;
  }

  bool other_input_point()
  {
    const int vertices = std::stoi(m_files.mesh[1][0]);
    auto& point = m_files.mesh[2 + static_cast<std::size_t>(m_random.below(vertices))];
    return move(point[static_cast<std::size_t>(m_random.below(3))], m_random.once_in(2) ? 0.01 : 0);
  }

  bool other_input_corner()
  {
    const int vertices = std::stoi(m_files.mesh[1][0]), faces = std::stoi(m_files.mesh[1][1]);
    auto& face = m_files.mesh[2 + static_cast<std::size_t>(vertices + m_random.below(faces))];
    if (std::set<std::string>(face.begin() + 1, face.end()).size() < 3) { return false; } // it is left out anyway
    const std::string value = std::to_string(m_random.below(vertices));
    const bool is_other = std::find(face.begin() + 1, face.end(), value) == face.end();
    face[1 + static_cast<std::size_t>(m_random.below(3))] = value;
    return is_other;
  }

  Files& m_files;
  Random& m_random;
};

struct Verdict
{
  bool verified, counted;
};

Verdict judge(const program::Workplace& place, const Files& files)
{
  place.write("mesh.off", text_of(files.mesh));
  place.write("out.obj", text_of(files.result));
  place.write("out.map.json", files.map.dump());
  const bool verified =
    place.shell("timeout -s KILL 20 '" MERIDIAN_PROGRAM "' verify mesh.off out.obj --quiet").status == 0;
  return {verified,
          recount::failures_of((place.folder() / "mesh.off").string(), (place.folder() / "out.obj").string()).empty()};
}

// A result of a small mesh, if this seed has one.
bool make_result(const program::Workplace& place, unsigned seed, Files& files)
{
  constexpr std::size_t most = 200;
  Random random(seed);
  const Mesh mesh = random_mesh(random);
  if (mesh.faces.size() > most) { return false; }
  const std::string command = random.one_of(
    std::vector<std::string>{"cut", "unwrap", "generators", "unwrap --charts 3", "generators --basis shortest"});
  place.write("mesh.off", format_off(mesh));
  if (place.shell("timeout -s KILL 20 '" MERIDIAN_PROGRAM "' " + command + " mesh.off -o out.obj --repair").status != 0)
  {
    return false;
  }
  files = {words_of(format_off(mesh)), words_of(program::read(place.folder() / "out.obj")),
           Json::parse(program::read(place.folder() / "out.map.json"))};
  return true;
}

struct Count
{
  unsigned altered = 0, caught = 0, as_good = 0;
  unsigned not_counted = 0; // what the second recount believes: edges of three faces, where it takes the result's word
};

} // namespace

} // namespace random_runs

int main(int argc, char** argv)
{
  using namespace random_runs;
  const auto [first, wanted] = read_arguments(argc, argv);
  std::map<std::string, Count> counts;
  unsigned altered = 0, unaltered = 0, wrong = 0;
  const program::Workplace place;
  for (unsigned seed = first; altered < wanted; ++seed)
  {
    Files original;
    if (!make_result(place, seed, original)) { continue; }
    ++unaltered;
    const Verdict whole = judge(place, original);
    if (!whole.verified || !whole.counted)
    {
      ++wrong;
      std::cout << "seed " << seed << ": refused although it was not altered" << std::endl;
      continue;
    }
    Random random(seed + 1000000);
    for (int kind = 0; kind < Alteration::kinds && altered < wanted; ++kind)
    {
      Files files = original;
      if (!Alteration(files, random).apply(kind)) { continue; }
      Count& count = counts[Alteration::name(kind)];
      ++altered;
      ++count.altered;
      const Verdict v = judge(place, files);
      const std::string name = Alteration::name(kind); // between equal points all weights are as good
      const bool may_be_as_good = name == "texture coordinate" || name == "origin, weight";
      count.caught += !v.verified;
      count.as_good += v.verified && v.counted && may_be_as_good;
      count.not_counted += v.counted && !may_be_as_good;
      if (v.verified ? v.counted && may_be_as_good : !v.counted || !may_be_as_good) { continue; }
      ++wrong;
      std::cout << "seed " << seed << ", " << Alteration::name(kind) << ": verify "
                << (v.verified ? "believes" : "refuses") << ", the second recount "
                << (v.counted ? "believes" : "refuses") << std::endl;
    }
  }
  for (const auto& [name, c] : counts)
  {
    std::cout << name << ": " << c.altered << " altered, " << c.caught << " caught, " << c.as_good
              << " as good as before, " << c.not_counted << " believed by the second recount\n";
  }
  std::cout << unaltered << " results unaltered, " << altered << " altered, " << wrong << " judged wrongly\n";
  return wrong == 0 ? 0 : 1;
}
