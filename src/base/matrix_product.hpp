// The product of a matrix and a vector for loops over nodes.
#pragma once

#include "base/vector.hpp"

namespace fiberfate {

/// A·x where a compiler would call Eigen's own product for every node. It rounds like that one, which adds
/// the last row's terms from the end.
[[nodiscard, gnu::always_inline]] inline Vec3 product(const Mat3& a, const Vec3& x) {
  return {a(0, 0) * x[0] + a(0, 1) * x[1] + a(0, 2) * x[2], a(1, 0) * x[0] + a(1, 1) * x[1] + a(1, 2) * x[2],
          a(2, 0) * x[0] + (a(2, 1) * x[1] + a(2, 2) * x[2])};
}

}  // namespace fiberfate
