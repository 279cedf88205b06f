// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_OWN_METHOD_H
#define MERIDIAN_CUT_BY_OWN_METHOD_H

#include <functional>
#include <meridian/surface/Triangle_surface.h>
#include <string>
#include <utility>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts by a method of one's own: a type that has what the others have, `names`, `cuts_edges`, `moves_onto_edges` and
/// `cut_handles()`, which keeps the contract of `Cut_job`. The cut is recounted like any other.
///
/// \code
/// options.method = By_own_method(My_method{42});
/// \endcode
class By_own_method
{
public:
  /// \tparam Method a model of `CutMethod`
  /// \param method the method, which is copied
  template <class Method>
  explicit By_own_method(Method method)
    : name(Method::names.name), cuts_edges(Method::cuts_edges), moves_onto_edges(Method::moves_onto_edges),
      m_cut([method = std::move(method)](Cut_job& job) { method.cut_handles(job); })
  {}

  std::string name;      ///< that of the method
  bool cuts_edges;       ///< whether it finds a whole cut graph of edges
  bool moves_onto_edges; ///< whether its curves can be moved onto edges one by one
  /// asks the method to cut the handles of `job.root`, of which it is given a copy to refine.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;

private:
  std::function<void(Cut_job&)> m_cut;
};

/// \cond
inline void check(const By_own_method&) {}
inline void check(const Triangle_surface&, const By_own_method&) {}
/// \endcond

} // namespace meridian

#endif // MERIDIAN_CUT_BY_OWN_METHOD_H
