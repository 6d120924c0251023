// What filling needs to know of a melt.
#pragma once

#include <limits>
#include <memory>

#include "continuum/viscosity.hpp"

namespace fiberfate {

/// A melt (with its fibers) of constant density and thermal properties.
struct MoldingMaterial {
  std::shared_ptr<const ViscosityLaw> viscosity;  ///< of the melt, or of the matrix where fibers are coupled
  double density = 1000;                          ///< kg/m³
  double heat_capacity = 2000;                    ///< J/(kg K)
  double conductivity = 0.2;                      ///< W/(m K)
  double no_flow_temperature = 0;                 ///< K; a layer that is colder stands still
};

}  // namespace fiberfate
