// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_GENERATOR_VERIFIER_H
#define MERIDIAN_PROOF_INTERNAL_GENERATOR_VERIFIER_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/proof/internal/Mesh_verifier.h>
#include <meridian/proof/internal/verify_counts.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace meridian {
namespace verification {

class Generator_verifier : Mesh_verifier
{
public:
  Generator_verifier(const Polygon_soup& input, const Result_mesh& result, const std::vector<Result_curve>& curves)
    : Mesh_verifier(input, result), m_curves(curves)
  {}

  Generator_verification run();

private:
  enum Kind
  {
    MERIDIAN,
    LONGITUDE,
    LOOP,
    BOUNDARY
  };
  // sides, and which way
  struct Curve
  {
    Kind kind;
    Id number;
    int component = -1;
    std::vector<std::pair<Id, int>> walk;
  };
  // A curve at a vertex: the sides, leaving the vertex, by which it comes and goes.
  struct Pass
  {
    Id curve, from, to;
  };

  void complain(const std::string& text) { m_report.failures.push_back(text); }
  const std::string& name(Id curve) const { return m_curves[curve].name; }

  bool read_names();

  // Curves as walks along sides: closed, of edges of the mesh, through no vertex twice.
  bool read_walks();

  // The sides that leave a vertex, counterclockwise; on a boundary, from its one end to the other.
  std::vector<Id> rotation(Id v) const;

  void count_curves();

  void check_boundary(Id c);

  void find_intersections();

  // Two curves at one vertex: do they cross, and which way?
  void meet(Id v, const Pass& a, const Pass& b, const std::map<Id, int>& place);

  void fill_matrix(int component, const std::vector<Id>& curves, bool are_pairs);

  void check_basis(int component, const std::vector<Id>& curves, const std::vector<Id>& faces,
                   const std::vector<Id>& local);

  // Flow lines from a saddle to one place: the field rises once and falls once.
  void check_flow(const Result_curve& c);

  struct Meeting
  {
    int vertices = 0, crossings = 0, number = 0;
    Id vertex = -1;
  };
  const std::vector<Result_curve>& m_curves;
  std::vector<Curve> m_read;
  std::vector<Id> m_begin, m_leaving;              // sides by the vertex that they leave
  std::map<std::pair<Id, Id>, Meeting> m_meetings; // of two curves, the lower first
  std::set<std::pair<Id, Id>> m_touches;           // curves with a common edge
  std::set<Id> m_boundaries;
  std::vector<Curve_count> m_counts;
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_GENERATOR_VERIFIER_H
