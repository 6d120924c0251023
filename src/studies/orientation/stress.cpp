// Evaluates the stress of the melt with its fibers.
#include "studies/orientation/stress.hpp"

#include <cmath>

#include "continuum/anisotropic_stress.hpp"

namespace fiberfate {

OrientationStress::OrientationStress(const OrientationCase& values)
    : melt_(make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt))),
      temperature_(values.flow.temperature),
      pressure_(values.flow.pressure),
      fiber_term_(fiber_term(values.fibers)),
      trouton_term_(values.fibers.trouton_term.value_or(fiber_term_)) {}

std::vector<std::string> OrientationStress::columns() {
  return {"viscosity_Pa_s", "effective_viscosity_Pa_s",
          "stress_11_Pa",   "stress_22_Pa",
          "stress_33_Pa",   "stress_12_Pa",
          "stress_13_Pa",   "stress_23_Pa"};
}

void OrientationStress::append(const Mat3& gradient, const Mat6& fourth, std::vector<double>& row) {
  const Mat3 strain_rate = 0.5 * (gradient + gradient.transpose());
  const double rate = std::sqrt(2 * double_dot(strain_rate, strain_rate));
  viscosity_ = melt_->at({rate, temperature_, pressure_});
  effective_viscosity_ = informed_isotropic_viscosity(viscosity_, trouton_term_, strain_rate, fourth);
  stress_ = anisotropic_stress(viscosity_, fiber_term_, strain_rate, fourth);
  row.insert(row.end(), {viscosity_, effective_viscosity_, stress_(0, 0), stress_(1, 1), stress_(2, 2),
                         stress_(0, 1), stress_(0, 2), stress_(1, 2)});
}

void OrientationStress::append(RunSummary& summary) const {
  summary.own.emplace_back("fiber_term", fiber_term_);
  summary.own.emplace_back("viscosity_Pa_s", viscosity_);
  summary.own.emplace_back("effective_viscosity_Pa_s", effective_viscosity_);
  summary.own.emplace_back("stress_Pa", stress_);
}

}  // namespace fiberfate
