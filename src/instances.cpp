// SPDX-License-Identifier: GPL-3.0-or-later
#include "instances.h"

namespace meridian {

template Cut cut_to_disc<>(const Triangle_surface&, const Cut_options&);
template Generators find_generators<>(const Triangle_surface&, const Generator_options&);
template Homology_basis find_shortest_basis<>(const Triangle_surface&, const Basis_options&);
template std::vector<double> eigenfunction_field<>(const Triangle_surface&, int, Weights);
template std::pair<Index, Index> find_curved_vertices<>(const Triangle_surface&, int, Weights);
template std::vector<double> geodesic_distance<>(const Triangle_surface&, const std::vector<Index>&);

} // namespace meridian
