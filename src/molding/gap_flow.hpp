// Flow through the gap of melt with a given viscosity in each layer.
#pragma once

#include <span>

#include "molding/gap_layers.hpp"

namespace fiberfate {

/// The fluidity s = int_0^1 zeta²/eta dzeta of half a gap, 1/(Pa s); writes each layer's share of
/// the flow (sum 1): M_k/s with M_k = int over the layer of b, b(zeta) = int_zeta^1 zeta'/eta dzeta'. Exact
/// for viscosities that are constant in each layer. `inverse_viscosities` (1/(Pa s)) are 0 in layers that
/// stand still. Flow through the full thickness H: q = -(H³/4) s grad p, m²/s. A gap that is frozen shut has
/// fluidity 0 and its whole flow in the layer at the mid-plane.
[[nodiscard]] double flow_through_gap(const GapLayers& layers, std::span<const double> inverse_viscosities,
                                      std::span<double> shares);

/// Writes each layer's share (sum 1) of the heat that viscous flow makes: int over the layer of zeta²/eta,
/// over s.
void dissipation_shares(const GapLayers& layers, std::span<const double> inverse_viscosities,
                        std::span<double> shares);

}  // namespace fiberfate
