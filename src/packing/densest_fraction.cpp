// How densely fibers of a given orientation can be packed.
#include "packing/densest_fraction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace fiberfate {

double densest_fraction(const Mat3& orientation) {
  const double largest = Eigen::SelfAdjointEigenSolver<Mat3>(orientation).eigenvalues()[2];
  const double alignment = std::clamp(0.5 * (3 * largest - 1), 0.0, 1.0);
  return densest_crossed + alignment * (densest_parallel - densest_crossed);
}

}  // namespace fiberfate
