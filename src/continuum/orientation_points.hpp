// Lays out many points for the compiled orientation kernels.
#pragma once

#include <cstddef>

#include "continuum/orientation_model.hpp"

namespace fiberfate {

/// Points to one array a component; the value of point i stands at [i * stride].
/// With stride 1 the arrays are a struct of arrays; components of a row-major table of n×6 numbers have
/// stride 6.
struct OrientationPoints {
  std::size_t count = 0;
  const double* second[6] = {};  ///< A2 in the order 11, 22, 33, 23, 31, 12
  std::size_t second_stride = 1;
  const double* gradient[9] = {};  ///< L_ij = d v_i / d x_j, row by row, 1/s
  std::size_t gradient_stride = 1;
  double* result[6] = {};  ///< DA/Dt in 1/s, or A2 at the end of a step; may be the arrays of `second`
  std::size_t result_stride = 1;
};

/// How far and how finely to integrate.
struct OrientationStep {
  double duration = 0;      ///< s, constant velocity gradient
  double tolerance = 1e-6;  ///< Frobenius norm of the error of A2 in one internal step
  int most_steps = 100000;  ///< internal steps of a point
};

/// What happened in a step.
struct OrientationAdvance {
  std::size_t put_back = 0;  ///< points that left the admissible states by more than the tolerance, and were
                             ///< put back
};

}  // namespace fiberfate
