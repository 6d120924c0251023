// Makes the fourth-order orientation tensor from the second-order one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microstructure/closure_kind.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Describes one closure for case files and documentation.
struct ClosureDescription {
  Closure closure;
  const char* name;     ///< "ibof"
  const char* meaning;  ///< one sentence
  const char* source;   ///< author, year, equation
};

/// All closures.
[[nodiscard]] const std::vector<ClosureDescription>& closures();
/// The name of a closure.
[[nodiscard]] const char* name(Closure closure);
/// Finds a closure by name, in capitals or not; raises InputError with the nearest name.
[[nodiscard]] Closure closure_named(std::string_view name);

/// Closes A4 from A2 as [ij][kl] plain components.
///
/// A2 is symmetric with unit trace and without negative principal value; departures up to
/// forgiven_departure are continued smoothly, others raise InputError.
/// All closures give A_ijkk = A_ij. All but `quadratic` and `hybrid` are symmetric in all four indices. At
/// equal principal values the fitted orthotropic closures are averaged over the axes, which are not
/// determined there.
[[nodiscard]] Mat6 close(const Mat3& second, Closure closure);

/// Contracts A4(A2) : G without forming A4; raises as `close`.
[[nodiscard]] Mat3 closed_double_dot(const Mat3& second, const Mat3& symmetric, Closure closure);

}  // namespace fiberfate
