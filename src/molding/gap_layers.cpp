// Grades the layers of the gap.
#include "molding/gap_layers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace fiberfate {

GapLayers::GapLayers(int half_count, double wall_width_ratio, double middle_width_ratio) {
  if (half_count < 2 || half_count > static_cast<int>(most_half_layers))
    throw InputError(fmt::format("{} layers in half the gap cannot be computed", half_count),
                     "take 4 to 128 layers in the full gap, an even number");
  if (!(wall_width_ratio > 0) || wall_width_ratio > 1)
    throw InputError(fmt::format("a wall layer of {:g} times the width of the middle one", wall_width_ratio),
                     "take a ratio above 0 and at most 1");
  if (!(middle_width_ratio > 0) || middle_width_ratio > 1)
    throw InputError(fmt::format("a middle layer of {:g} times its width", middle_width_ratio),
                     "take a ratio above 0 and at most 1");
  const double factor = std::pow(wall_width_ratio, 1.0 / (half_count - 1));
  double width = 1, sum = 0;
  for (int k = 0; k < half_count; ++k, width *= factor) {
    widths_.push_back(k == 0 ? middle_width_ratio : width);
    sum += widths_.back();
  }
  bounds_.push_back(0);
  for (double& w : widths_) {
    w /= sum;
    bounds_.push_back(bounds_.back() + w);
  }
  bounds_.back() = 1;
  for (std::size_t k = 0; k < widths_.size(); ++k) {
    const double a = bounds_[k], b = bounds_[k + 1];
    middles_.push_back((a + b) / 2);
    shear_heights_.push_back(std::sqrt((a * a + a * b + b * b) / 3));
  }
}

}  // namespace fiberfate
