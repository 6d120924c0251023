// Chooses the lattice on which a cell follows a flow for ever.
#pragma once

#include "fibers/cell.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {

/// Makes the periodic cell of the volume of `size` that can follow every flow of a history without end:
/// - simple shear u_x(y), any rates: a box whose layers slide;
/// - gradients with the same real axes (elongations, mixed flows): a lattice stretched along them;
/// - planar flows in x and y that turn more than they stretch, multiples of each other: a lattice that turns.
/// `size` is taken along the flow's axes where these are at right angles. Raises InputError, with the reason
/// and the strain that a box would stand, for flows that no lattice follows.
[[nodiscard]] Cell cell_for(const FlowHistory& flow, const Vec3& size);

/// Raises InputError unless a cell, made for another flow perhaps, follows every flow of a history for ever.
void require_follows(const Cell& cell, const FlowHistory& flow);

/// The least distance that a point ever has from its nearest image, whatever flows the lattice follows, m; of
/// a carried one, its present one.
[[nodiscard]] double nearest_image_ever(const Cell& cell);

}  // namespace fiberfate
