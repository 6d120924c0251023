// Draws the directions with which fibers begin to be packed.
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"
#include "packing/packing.hpp"

namespace fiberfate {

/// One unit direction a fiber and what they stand for.
struct DrawnDirections {
  std::vector<Vec3> directions;
  Mat3 asked;          ///< A2 that the request wants, length-weighted
  Mat6 fourth_moment;  ///< A4 of the directions, length-weighted
};

/// Draws directions as the request asks: from its law, or dealt from its list; but those of the published
/// route (PackingStart::compressed) are planar, a33 = 0.01, whatever is asked (thesis section 3.2.1). What is
/// asked by a list is its second moment, and where these fibers cannot have that, what they have of it.
/// Raises InputError where they cannot have the tensor that is asked for.
[[nodiscard]] DrawnDirections draw_directions(const PackingRequest& request);

}  // namespace fiberfate
