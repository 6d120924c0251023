// Computes breakage rates and child distributions of the Phelps-Tucker model.
#include "continuum/phelps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"

namespace fiberfate {
namespace {

double to_the_fourth(double x) {
  return (x * x) * (x * x);
}

}  // namespace

double buckling_coefficient(const PhelpsConstants& constants, const LengthFlow& flow) {
  if (constants.unbreakable_length > 0) {
    const bool flowing = flow.rate > 0;
    return flowing ? flow.compression / to_the_fourth(constants.unbreakable_length) : 0.0;
  }
  const double drag = 4 * constants.drag_coefficient * flow.viscosity * flow.rate;
  return flow.compression * drag / (pi * pi * pi * constants.modulus * to_the_fourth(constants.diameter));
}

double unbreakable_length(const PhelpsConstants& constants, const LengthFlow& flow) {
  const double coefficient = buckling_coefficient(constants, {flow.rate, flow.viscosity, 1});
  return coefficient > 0 ? std::pow(coefficient, -0.25) : std::numeric_limits<double>::infinity();
}

double breakage_share(BreakageRate breakage_rate, double buckling_number) {
  if (!(buckling_number > 0)) return 0;
  if (breakage_rate == BreakageRate::phelps) return std::max(0.0, -std::expm1(1 - buckling_number));
  return std::min(1.0, std::expm1(-buckling_number) / std::expm1(-1.0));
}

std::vector<double> child_numbers(std::size_t bins, double spread) {
  if (bins < 2) throw InputError("a length distribution needs at least two bins", "100 is usual");
  if (!(spread >= 0.005))
    throw InputError("the spread S of the Phelps model is below 0.005",
                     "take at least 0.005; 0.05 to 1 is usual");
  std::vector<double> children(bins * bins, 0.0);
  for (std::size_t k = 2; k <= bins; ++k) {
    double* column = children.data() + (k - 1) * bins;
    const double parent = static_cast<double>(k);
    double sum = 0;
    // The Gaussian is even about k/2: computing half of it and mirroring makes the length balance exact.
    for (std::size_t i = 1; 2 * i <= k; ++i) {
      const double deviation = (static_cast<double>(i) - parent / 2) / (spread * parent);
      const double weight = std::exp(-0.5 * deviation * deviation);
      column[i - 1] = column[k - i - 1] = weight;
      sum += 2 * i == k ? weight : 2 * weight;
    }
    for (std::size_t i = 0; i + 1 < k; ++i) column[i] *= 2 / sum;
  }
  return children;
}

}  // namespace fiberfate
