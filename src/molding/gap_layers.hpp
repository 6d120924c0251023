// Divides the gap between the walls into layers, from the mid-plane to the wall.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fiberfate {

/// Layers that half a gap may have at most.
inline constexpr std::size_t most_half_layers = 64;

/// Divides half a gap; the other half is its mirror image (both walls are alike). Heights are relative to
/// the half thickness: 0 is the mid-plane, 1 the wall. Layer 0 lies at the mid-plane. Widths fall towards
/// the wall in geometric progression, since rates, temperatures and orientations change fastest there. Values
/// in a layer are those at its height; layer 0 may be made thinner to show the mid-plane itself.
class GapLayers {
 public:
  /// Takes the number of layers in half the gap, the width at the wall over that at the mid-plane, and the
  /// share of its width in that progression that layer 0 gets. Raises InputError unless 2 <= half_count <=
  /// most_half_layers and both ratios are above 0 and at most 1.
  explicit GapLayers(int half_count, double wall_width_ratio = 0.4, double middle_width_ratio = 1);

  [[nodiscard]] std::size_t count() const { return widths_.size(); }
  [[nodiscard]] std::span<const double> bounds() const { return bounds_; }    ///< count() + 1, from 0 to 1
  [[nodiscard]] std::span<const double> widths() const { return widths_; }    ///< sum 1
  [[nodiscard]] std::span<const double> middles() const { return middles_; }  ///< where temperatures stand
  /// Where a layer's shear rate and viscosity stand: sqrt((a² + a b + b²)/3) of its bounds a, b, for which
  /// the fluidity of a layer of one viscosity is exact.
  [[nodiscard]] std::span<const double> shear_heights() const { return shear_heights_; }

 private:
  std::vector<double> bounds_, widths_, middles_, shear_heights_;
};

}  // namespace fiberfate
