// Tensors of fourth order as studies write them into summary.json.
#pragma once

#include <vector>

#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Lists the 36 components, 6×6 by rows in the order 11, 22, 33, 23, 31, 12.
[[nodiscard]] inline std::vector<double> components(const Mat6& fourth) {
  std::vector<double> all;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) all.push_back(fourth(i, j));
  return all;
}

}  // namespace fiberfate
