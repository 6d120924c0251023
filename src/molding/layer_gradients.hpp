// The velocity gradient in every layer of a node.
#pragma once

#include <array>
#include <span>

#include "molding/flow_field.hpp"
#include "molding/gap_layers.hpp"
#include "molding/shell_mesh.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// L_ij = d v_i / d x_j (1/s) of the layers of one node in its frame, row by row; [component][layer].
using LayerGradients = std::array<std::array<double, most_half_layers>, 9>;

/// Finds the gradients: dv/dz from the pressure and the viscosity, d/dx and d/dy by least squares over the
/// neighbours of the layers' mean velocities, dv_z/dz from continuity. At the front only dv/dz is known.
/// Layers that stand still have none. Neglected: d v_z/dx.
void find_layer_gradients(const ShellMesh& mesh, const MeltMotion& motion, std::size_t node,
                          LayerGradients& gradients);

}  // namespace fiberfate
