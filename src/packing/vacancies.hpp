// The room that there is for the axis of one more fiber.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "packing/chains.hpp"

namespace fiberfate {

/// A straight line.
struct StraightAxis {
  Vec3 centre = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();  ///< unit vector
  double length = 0;
};

/// Divides the cell into small boxes and marks those that fibers fill: whose centres are nearer to an axis
/// than contact with a fiber of the thickest diameter, or, where boxes are larger than small, any part.
class Vacancies {
 public:
  /// Makes empty boxes for these fibers; where they fill next to nothing, larger ones.
  explicit Vacancies(const Chains& chains);
  /// Marks what this fiber fills.
  void fill(const Chains& chains, FiberIndex fiber);
  /// Share of a line that lies in filled boxes or beyond walls; where it is above `enough`, any share above
  /// that.
  [[nodiscard]] double filled_share(const StraightAxis& line, double enough = 1) const;

 private:
  using Box = std::array<std::ptrdiff_t, 3>;
  /// Boxes whose centres are nearer than this to that of the box {0, 0, 0}.
  [[nodiscard]] std::vector<Box> boxes_around(double distance) const;
  /// Number of a box, or of its image in the cell; −1 beyond walls.
  [[nodiscard]] std::ptrdiff_t number(const Box& box) const;
  void mark(const Box& box);
  /// Marks the boxes between two, corner to corner.
  void mark_between(const Box& low, const Box& high);

  Mat3 fraction_of_point_;  ///< gives shares of the cell's edges
  Mat3 boxes_of_point_;     ///< gives fractional numbers of boxes
  std::array<bool, 3> walled_{};
  bool is_coarse_ = false;  ///< boxes are larger than small
  std::array<std::ptrdiff_t, 3> count_{};
  std::vector<std::uint8_t> filled_;
};

}  // namespace fiberfate
