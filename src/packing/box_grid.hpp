// Divides a periodic or walled cell into boxes, for finding the rods near a rod.
#pragma once

#include <array>

#include "packing/chains.hpp"

namespace fiberfate {

/// Numbers boxes of the cell, images of the cell, and rods in the order of the boxes that they lie in.
using BoxIndex = IndexOf<struct BoxTag>;
using ImageIndex = IndexOf<struct ImageTag>;
using SlotIndex = IndexOf<struct SlotTag>;

/// How far to look: pairs are listed whose axes are nearer than swelling · (sum of radii) + reach +
/// skin.
struct NeighbourRange {
  double swelling = 1;
  double reach = 0;
  double skin = 0;
};

/// An inclusive range of boxes in one direction; beyond the cell it counts on into the images.
struct BoxRange {
  int low, high;
};

/// Divides the cell in fractional coordinates. Images of the cell are numbered, as far away as neighbours can
/// lie.
class BoxGrid {
 public:
  BoxGrid(const Chains& chains, const NeighbourRange& range);

  /// The box of a point of the cell; points beyond walls belong to the outermost box.
  [[nodiscard]] IntVec3 box(const Vec3& point) const;
  /// The number of a box inside the cell; boxes that differ in the first index only are numbered in a row.
  [[nodiscard]] BoxIndex number(const IntVec3& box) const;
  /// The image of the cell in which a box lies.
  [[nodiscard]] IntVec3 image(const IntVec3& box) const;
  [[nodiscard]] ImageIndex number_of_image(const IntVec3& image) const;
  /// The boxes in direction i that neighbours of a rod in this box may lie in.
  [[nodiscard]] BoxRange around(const IntVec3& box, int i) const;
  [[nodiscard]] const IntVec3& count() const { return count_; }
  /// Images reach from −farthest to farthest in each direction.
  [[nodiscard]] int farthest_image() const { return farthest_image_; }

  IndexedVector<BoxIndex, SlotIndex> first_slot;  ///< where the rods of a box begin; one more than boxes

 private:
  Mat3 to_fraction_;
  IntVec3 count_, span_;
  std::array<bool, 3> periodic_{};
  int farthest_image_ = 0;
};

}  // namespace fiberfate
