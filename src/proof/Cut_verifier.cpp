// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/Cut_verifier.h>

#include <meridian/proof/internal/verify_counts.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace verification {

Verification Cut_verifier::run()
{
  if (!verify_mesh()) { return std::move(m_report); }
  count_discs();
  if (!m_result.chart_of.empty()) { check_charts(); }
  return std::move(m_report);
}

void Cut_verifier::count_discs()
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
    const bool is_disc = count.discs == 1 && count.disc_euler_characteristic == 1 && count.disc_boundary_loops == 1;
    if (!is_disc && m_result.chart_of.empty()) { not_discs.push_back(i); }
  }
  fail("components of the input did not become one disc", not_discs);
}

void Cut_verifier::check_charts()
{
  const Id faces = static_cast<Id>(m_result.faces.size());
  const auto& chart_of = m_result.chart_of;
  if (chart_of.size() != m_result.faces.size())
  {
    m_report.failures.push_back("the map is not of this mesh: it has " + std::to_string(chart_of.size())
                                + " entries for the charts of faces, the mesh has " + std::to_string(faces) + " faces");
    return;
  }
  std::vector<Id> wrong, not_discs;
  for (Id f = 0; f < faces; ++f)
  {
    if (chart_of[f] < 0 || chart_of[f] >= faces) { wrong.push_back(f); }
  }
  fail("faces have a chart out of range", wrong);
  if (!wrong.empty()) { return; }
  Union_find parts(faces);
  Union_find fans = find_fans(&parts);
  for (Id f = 0; f < faces; ++f)
  {
    if (chart_of[f] != chart_of[parts.find(f)]) { wrong.push_back(f); }
  }
  fail("faces are in another chart than what they are joined to", wrong);
  const int charts = *std::max_element(chart_of.begin(), chart_of.end()) + 1;
  const Counts c = count_glued(
    faces, m_result_twin, charts, [&](Id f) { return chart_of[f]; }, fans);
  std::vector<int> pieces(charts, 0);
  for (Id f = 0; f < faces; ++f) { pieces[chart_of[f]] += parts.find(f) == f; }
  for (Id i = 0; i < charts; ++i)
  {
    if (pieces[i] != 1 || c.vertices[i] - c.edges[i] + c.faces[i] != 1 || c.loops[i] != 1) { not_discs.push_back(i); }
  }
  fail("charts are not one disc each", not_discs);
}

} // namespace verification

} // namespace meridian
