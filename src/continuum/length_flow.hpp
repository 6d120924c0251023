// What a length law sees of the flow at a point, or at many points at once.
#pragma once

#include <cstddef>
#include <span>

namespace fiberfate {

/// The flow that breaks fibers at one point.
struct LengthFlow {
  double rate = 0;       ///< shear rate sqrt(2 D:D), 1/s, not negative
  double viscosity = 0;  ///< of the matrix at this rate, Pa s, not negative
  double compression =
      1;  ///< -2 D:A/rate in [-1, 1], or 1 for the most compressed direction; only Phelps uses it

  /// Raises InputError, whose key names the member, for a number that no flow has.
  void check() const;
};

/// The same for n points, one array a quantity; `compression` may be empty, which means 1 everywhere.
struct LengthFlows {
  std::span<const double> rate;
  std::span<const double> viscosity;
  std::span<const double> compression = {};

  [[nodiscard]] std::size_t size() const { return rate.size(); }
  [[nodiscard]] LengthFlow operator[](std::size_t point) const {
    return {rate[point], viscosity[point], compression.empty() ? 1.0 : compression[point]};
  }
  /// Raises InputError, whose key names the array and the point, for arrays of unequal size or a number that
  /// no flow has.
  void check() const;
};

}  // namespace fiberfate
