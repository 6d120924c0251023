// What the viscosity of a melt depends on.
#pragma once

namespace fiberfate {

struct MeltState {
  double rate = 0;         ///< shear rate sqrt(2 D:D), 1/s, not negative
  double temperature = 0;  ///< K; only Cross-WLF uses it
  double pressure = 0;     ///< Pa; only Cross-WLF uses it
};

}  // namespace fiberfate
