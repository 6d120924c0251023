// What the viscosity of a melt depends on.
#pragma once

#include "microstructure/flow.hpp"

namespace fiberfate {

struct MeltState {
  double rate = 0;         ///< shear rate sqrt(2 D:D), 1/s, not negative
  double temperature = 0;  ///< K; only Cross-WLF uses it
  double pressure = 0;     ///< Pa; only Cross-WLF uses it
};

/// Tells what laws of viscosity ask about a flow.
[[nodiscard]] inline MeltState melt_of(const Flow& flow) {
  return {flow.shear_rate(), flow.temperature, flow.pressure};
}

}  // namespace fiberfate
