// The stress of the melt with its fibers.
#include "studies/orientation/stress.hpp"

#include "continuum/anisotropic_stress.hpp"

namespace fiberfate {

StressEvaluator::StressEvaluator(const OrientationCase& values)
    : melt_(make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt))),
      temperature_(values.flow.temperature),
      pressure_(values.flow.pressure),
      fiber_term_(fiberfate::fiber_term(values.fibers)),
      trouton_term_(values.fibers.trouton_term.value_or(fiber_term_)) {}

MeltStress StressEvaluator::at(const Flow& flow, const Mat6& fourth) const {
  const Mat3 strain_rate = flow.rate_of_strain();
  const double viscosity = melt_->at({flow.shear_rate(), temperature_, pressure_});
  return {viscosity, informed_isotropic_viscosity(viscosity, trouton_term_, strain_rate, fourth),
          anisotropic_stress(viscosity, fiber_term_, strain_rate, fourth)};
}

}  // namespace fiberfate
