// The contacts of rods side by side, so that their forces can be evaluated in packs.
#pragma once

#include <cstdint>
#include <vector>

#include "fibers/segment_block.hpp"

namespace fiberfate {

/// One contact of two rods.
struct Contact {
  RodIndex first;
  RodIndex second;
  double s = 0;                 ///< place on the first rod, in [0, 1]
  double t = 0;                 ///< place on the second rod, in [0, 1]
  Vec3 normal = Vec3::UnitX();  ///< from the second rod to the first
  double distance = 0;          ///< of the axes, m
  std::int32_t image = 0;       ///< of the second rod, packed (fibers/rod_pairs.hpp)
  std::uint16_t first_material = 0;
  std::uint16_t second_material = 0;
};

/// Contacts as a struct of arrays; every array has room for seven more than `count`.
struct ContactChunk {
  int count = 0;
  std::vector<RodIndex> first, second;
  std::vector<std::int32_t> image;
  std::vector<std::uint16_t> first_material, second_material;
  std::vector<double> s, t, normal_x, normal_y, normal_z, distance;

  void clear() { count = 0; }
  /// Makes room for so many contacts.
  void reserve(int contacts);
  /// Adds those of `pairs` measured pairs that are near; axes that cross have their normal for separation,
  /// and the block leaves a contact's materials to be filled in. There must be room.
  void add(const SegmentBlock& block, int pairs);
  [[nodiscard]] Contact at(int i) const;
};

/// All contacts in chunks, each of which one thread works on at a time.
using ContactSet = std::vector<ContactChunk>;

}  // namespace fiberfate
