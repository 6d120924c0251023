// Integrates the fluidity across the gap.
#include "molding/gap_flow.hpp"

namespace fiberfate {

double flow_through_gap(const GapLayers& layers, std::span<const double> inverse_viscosities,
                        std::span<double> shares) {
  double outer = 0;  // b at the layer's outer bound
  double fluidity = 0;
  for (std::size_t k = layers.count(); k-- > 0;) {
    const double a = layers.bounds()[k], b = layers.bounds()[k + 1];
    const double square = b * b, width = layers.widths()[k];
    const double mean_square = (a * a + a * b + square) / 3;
    shares[k] = width * (outer + 0.5 * inverse_viscosities[k] * (square - mean_square));
    outer += 0.5 * inverse_viscosities[k] * (square - a * a);
    fluidity += shares[k];
  }
  if (fluidity > 0) {
    for (std::size_t k = 0; k < layers.count(); ++k) shares[k] /= fluidity;
  } else {
    for (std::size_t k = 0; k < layers.count(); ++k) shares[k] = k == 0 ? 1 : 0;
  }
  return fluidity;
}

void dissipation_shares(const GapLayers& layers, std::span<const double> inverse_viscosities,
                        std::span<double> shares) {
  double sum = 0;
  for (std::size_t k = 0; k < layers.count(); ++k) {
    const double a = layers.bounds()[k], b = layers.bounds()[k + 1];
    shares[k] = layers.widths()[k] * (a * a + a * b + b * b) / 3 * inverse_viscosities[k];
    sum += shares[k];
  }
  for (std::size_t k = 0; k < layers.count(); ++k) shares[k] = sum > 0 ? shares[k] / sum : (k == 0 ? 1 : 0);
}

}  // namespace fiberfate
