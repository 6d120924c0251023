// Records a break.
#pragma once

#include <cstdint>

namespace fiberfate {

/// Records one hinge that broke.
struct BreakEvent {
  double time = 0;               ///< s
  std::uint32_t birth_id = 0;    ///< original fiber
  std::uint32_t birth_node = 0;  ///< node along the original fiber
  double radius = 0;             ///< radius of curvature at which it broke, m
  double parent_length = 0;      ///< length of the fiber that broke, m
  double child_length = 0;       ///< length of the first of its two parts, m
};

}  // namespace fiberfate
