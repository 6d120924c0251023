// Interpolates by a natural cubic spline.
#pragma once

#include <vector>

namespace fiberfate {

/// The spline through points: two times continuously differentiable, without bend at the ends.
class NaturalSpline {
 public:
  /// Takes at least two points, x rising; raises InputError otherwise.
  NaturalSpline(std::vector<double> x, std::vector<double> y);
  /// Evaluates the spline; beyond its ends, the cubic of the first or last interval.
  [[nodiscard]] double at(double x) const;

 private:
  std::vector<double> x_, y_;
  std::vector<double> bend_;  ///< second derivatives at the points
};

}  // namespace fiberfate
