// The two averages by which a length distribution is usually known.
#pragma once

namespace fiberfate {

/// The averages of fiber lengths (thesis 2.5, 2.6).
struct MeanLengths {
  double number_average = 0;  ///< L_N = sum n L / sum n, m
  double weight_average = 0;  ///< L_W = sum n L^2 / sum n L, m
};

}  // namespace fiberfate
