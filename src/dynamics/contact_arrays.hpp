// Shows the arrays of a chunk of contacts to kernels, which must not touch the standard library.
#pragma once

#include <cstdint>

#include "base/vector.hpp"

namespace fiberfate {

/// Points to the arrays of ContactChunk.
struct ContactArrays {
  int count;
  const Index* first;
  const Index* second;
  const std::int32_t* image;
  const std::uint16_t* first_material;
  const std::uint16_t* second_material;
  const double* s;
  const double* t;
  const double* normal[3];
  const double* distance;
};

/// Points to where the next contact goes in the arrays of ContactChunk.
struct ContactColumns {
  Index* first;
  Index* second;
  std::int32_t* image;
  double* s;
  double* t;
  double* normal[3];
  double* distance;
};

}  // namespace fiberfate
