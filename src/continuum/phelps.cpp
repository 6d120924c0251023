// Computes breakage rates and child distributions of the Phelps-Tucker model.
#include "continuum/phelps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"

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
  flow.check();
  const double coefficient = buckling_coefficient(constants, {flow.rate, flow.viscosity, 1});
  return coefficient > 0 ? std::pow(coefficient, -0.25) : std::numeric_limits<double>::infinity();
}

void fill_children(std::size_t parent_bins, double spread, std::span<double> children) {
  require_same_size("children", children.size(), parent_bins - 1);
  const double parent = static_cast<double>(parent_bins);
  double sum = 0;
  // The Gaussian is even about k/2: computing half of it and mirroring makes the length balance exact.
  for (std::size_t i = 1; 2 * i <= parent_bins; ++i) {
    const double deviation = (static_cast<double>(i) - parent / 2) / (spread * parent);
    const double weight = std::exp(-0.5 * deviation * deviation);
    children[i - 1] = children[parent_bins - i - 1] = weight;
    sum += 2 * i == parent_bins ? weight : 2 * weight;
  }
  for (double& child : children) child *= 2 / sum;
}

void require_child_bins(std::size_t bins, double spread) {
  if (bins < 2) throw InputError("a length distribution needs at least two bins", "100 is usual");
  if (bins > most_bins)
    throw InputError(fmt::format("a length distribution of {} bins would take {:.3g} GB of memory", bins,
                                 4e-9 * static_cast<double>(bins) * static_cast<double>(bins)),
                     fmt::format("take at most {}; 100 is usual", most_bins));
  if (!(spread >= 0.005) || !std::isfinite(spread))
    throw InputError("the spread S of the Phelps model is below 0.005",
                     "take at least 0.005; 0.05 to 1 is usual");
}

std::vector<double> child_numbers(std::size_t bins, double spread) {
  require_child_bins(bins, spread);
  std::vector<double> children(bins * bins, 0.0);
  for (std::size_t k = 2; k <= bins; ++k)
    fill_children(k, spread, std::span(children).subspan((k - 1) * bins, k - 1));
  return children;
}

}  // namespace fiberfate
