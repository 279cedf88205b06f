// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_CUT_VERIFIER_H
#define MERIDIAN_PROOF_INTERNAL_CUT_VERIFIER_H

#include <meridian/proof/internal/Mesh_verifier.h>

namespace meridian {
namespace verification {

class Cut_verifier : Mesh_verifier
{
public:
  using Mesh_verifier::Mesh_verifier;

  Verification run()
  {
    if (verify_mesh()) { check_discs(); }
    return std::move(m_report);
  }

private:
  void check_discs()
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
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_CUT_VERIFIER_H
