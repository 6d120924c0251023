// Inverts Student's distribution, whose integral Eigen provides.
#include "calibration/student.hpp"

#include <Eigen/Core>
#include <cmath>
#include <limits>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wshadow"
#include <unsupported/Eigen/SpecialFunctions>
#pragma GCC diagnostic pop

#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

/// Probability of |T| <= t.
double coverage(double t, double degrees_of_freedom) {
  if (!std::isfinite(degrees_of_freedom)) return std::erf(t / std::sqrt(2.0));
  const double x = degrees_of_freedom / (degrees_of_freedom + t * t);
  return 1 - Eigen::numext::betainc(0.5 * degrees_of_freedom, 0.5, x);
}

}  // namespace

double student_quantile(double level, double degrees_of_freedom) {
  require_number("level", level, {.lower = 0, .upper = 1 - 1e-12, .above_lower = true});
  if (!(degrees_of_freedom > 0)) return std::numeric_limits<double>::quiet_NaN();
  double low = 0, high = 1;
  while (coverage(high, degrees_of_freedom) < level && high < 1e12) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (coverage(middle, degrees_of_freedom) < level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace fiberfate
