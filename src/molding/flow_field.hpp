// What the solution of the flow at one time tells; all of it can be computed again from the state.
#pragma once

#include <vector>

#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// The flow at one time. A node is wet where its control volume is full. Pressure is zero at the front.
struct FlowField {
  std::vector<char> wet;                  ///< by node
  std::vector<double> inverse_viscosity;  ///< by point, 1/(Pa s); 0 where a layer stands still
  std::vector<double> fluidity;           ///< by node, int zeta²/eta, 1/(Pa s)
  std::vector<double> shares;             ///< by point: the layer's share of its node's flow, sum 1
  std::vector<double> edge_flux;          ///< by edge, from first to second, m³/s
  std::vector<double> source;             ///< by node: what it gives up of its excess, m³/s
  std::vector<double> front_factor;       ///< by node: 1/(1/2 + filled share) of nodes that are not wet
  std::vector<double> pressure;           ///< by node, Pa
  std::vector<Vec2> gradient;             ///< by node, of the pressure, in the node's frame, Pa/m
  double rate = 0;                        ///< through the sprue, m³/s
  double sprue_pressure = 0;              ///< Pa
  bool limited = false;                   ///< pressure holds the rate below what the profile asks for
  double released_share = 1;              ///< of the sources, that `greatest_pressure` can drive
};

}  // namespace fiberfate
