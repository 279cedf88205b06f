// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_RUN_OPTIONS_H
#define MERIDIAN_MESH_INTERNAL_RUN_OPTIONS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/adapt_solver.h>
#include <meridian/mesh/parameters.h>

#include <functional>
#include <type_traits>

namespace meridian {

namespace internal {

// The solvers that named parameters ask for, or those that there are.
template <class NamedParameters> Solvers solvers_of(const NamedParameters& np, Solvers solvers = Solvers())
{
  if_given(CGAL::parameters::get_parameter(np, CGAL::internal_np::sparse_linear_solver), [&](const auto& solver) {
    solvers.symmetric = solvers.general = solvers.laplace = adapt_solver<std::decay_t<decltype(solver)>>;
  });
  return solvers;
}

template <class Observer> Progress_observer* address_of(Observer* const& observer) { return observer; }
template <class Observer> Progress_observer* address_of(const std::reference_wrapper<Observer>& observer)
{
  return &observer.get();
}

template <class Other> Progress_observer* address_of(const Other&)
{
  static_assert(std::is_void_v<Other>,
                "a visitor is given as std::ref(observer) or &observer, so that it is not copied");
  return nullptr;
}

// The observer that named parameters ask for, or another.
template <class NamedParameters>
Progress_observer* observer_of(const NamedParameters& np, Progress_observer* observer = nullptr)
{
  if_given(CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor),
           [&](const auto& visitor) { observer = address_of(visitor); });
  return observer;
}

// Options with the solver and the observer of named parameters.
template <class Options, class NamedParameters> Options with_run(Options options, const NamedParameters& np)
{
  options.solvers = solvers_of(np, options.solvers);
  options.observer = observer_of(np, options.observer);
  return options;
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_RUN_OPTIONS_H
