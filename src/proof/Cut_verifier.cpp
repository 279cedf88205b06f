// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/Cut_verifier.h>

#include <meridian/proof/internal/verify_counts.h>

#include <utility>
#include <vector>

namespace meridian {

namespace verification {

Verification Cut_verifier::run()
{
  if (verify_mesh()) { check_discs(); }
  return std::move(m_report);
}

void Cut_verifier::check_discs()
{
  const Id faces = static_cast<Id>(m_result.faces.size());
  Union_find parts(faces);
  Union_find fans = find_fans(&parts);
  const int components = static_cast<int>(m_report.components.size());
  const Counts c = count_glued(
    faces, m_result_twin, components, [&](Id f) { return component(f); }, fans);
  std::vector<Id> not_discs;
  for (Id f = 0; f < faces; ++f) { m_report.components[component(f)].discs += parts.find(f) == f; }
  for (int i = 0; i < components; ++i)
  {
    Component_count& count = m_report.components[i];
    count.disc_euler_characteristic = c.vertices[i] - c.edges[i] + c.faces[i];
    count.disc_boundary_loops = c.loops[i];
    if (count.discs != 1 || count.disc_euler_characteristic != 1 || count.disc_boundary_loops != 1)
    {
      not_discs.push_back(i);
    }
  }
  fail("components of the input did not become one disc", not_discs);
}

} // namespace verification

} // namespace meridian
