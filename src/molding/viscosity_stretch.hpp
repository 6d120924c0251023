// By how much fibers raise the viscosity.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// The factor 1 + R (D:A4:D)/(D:D) of the viscosity by point, with D the shear across the gap and
/// R = scale phi N_p(L/d) of FiberCoupling; 1 where there is no melt or nothing flows.
class ViscosityStretch {
 public:
  /// Takes the place of the length that gives the aspect ratio among the fields of a point, below 0 for none.
  ViscosityStretch(Cavity cavity, const MoldingFibers& fibers, std::ptrdiff_t length_field)
      : cavity_(cavity), fibers_(fibers), length_field_(length_field) {}

  [[nodiscard]] std::vector<double> at(const FillingState& state, const FlowField& field) const;

 private:
  Cavity cavity_;
  const MoldingFibers& fibers_;
  std::ptrdiff_t length_field_;
};

}  // namespace fiberfate
