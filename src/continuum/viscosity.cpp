// Evaluates the viscosity laws.
#include "continuum/viscosity.hpp"

#include <algorithm>
#include <cmath>

namespace fiberfate {

double PowerLaw::operator()(const MeltState& melt) const {
  return consistency * std::pow(std::max(melt.rate, lowest_rate), index - 1);
}

double Carreau::operator()(const MeltState& melt) const {
  const double thinning = std::pow(1 + std::pow(time * melt.rate, transition), (index - 1) / transition);
  return infinite_rate_viscosity + (zero_rate_viscosity - infinite_rate_viscosity) * thinning;
}

double Cross::operator()(const MeltState& melt) const {
  return zero_rate_viscosity / (1 + std::pow(zero_rate_viscosity * melt.rate / critical_stress, 1 - index));
}

double CrossWlf::operator()(const MeltState& melt) const {
  const double above = std::max(0.0, melt.temperature - (d_2 + d_3 * melt.pressure));
  const double shift = -a_1 * above / (a_2 + d_3 * melt.pressure + above);
  return Cross{d_1 * std::exp(shift), critical_stress, index}(melt);
}

}  // namespace fiberfate
