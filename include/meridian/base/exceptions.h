// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_EXCEPTIONS_H
#define MERIDIAN_BASE_EXCEPTIONS_H

#include <stdexcept>

namespace meridian {

/// \ingroup PkgMeridianErrors
/// the surface, the field or an option handed in cannot be used. The message names the defect,
/// counts it, gives the first elements and says what would help.
struct Invalid_input_error : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

/// \ingroup PkgMeridianErrors
/// a valid input on which a numerical step (factorization, solve) did not succeed.
struct Solver_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgMeridianErrors
/// the observer asked for the run to end; see `Progress_observer::go_further()`.
struct Cancelled : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgMeridianErrors
/// an invariant of the construction broke. It is a fault of this package, never of the caller;
/// no result is returned.
struct Internal_error : std::logic_error
{
  using std::logic_error::logic_error;
};

} // namespace meridian

#endif // MERIDIAN_BASE_EXCEPTIONS_H
