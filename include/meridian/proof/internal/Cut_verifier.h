// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_CUT_VERIFIER_H
#define MERIDIAN_PROOF_INTERNAL_CUT_VERIFIER_H

#include <meridian/base/Verification.h>
#include <meridian/proof/internal/Mesh_verifier.h>

namespace meridian {
namespace verification {

class Cut_verifier : Mesh_verifier
{
public:
  using Mesh_verifier::Mesh_verifier;

  Verification run();

private:
  // Counts what each component became: one disc, unless there are charts.
  void count_discs();
  // Each chart is one disc.
  void check_charts();
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_CUT_VERIFIER_H
