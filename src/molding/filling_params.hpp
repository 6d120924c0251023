// Everything that a user may choose about a filling.
#pragma once

#include <vector>

#include "molding/gate.hpp"
#include "molding/molding_fibers.hpp"
#include "molding/molding_material.hpp"
#include "molding/molding_process.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Chooses whether the temperature is solved for.
enum class HeatModel {
  none,  ///< isothermal: everywhere the inlet temperature
  full   ///< convection, conduction across the gap, viscous heating, fountain flow
};

/// How finely to compute.
struct FillingNumerics {
  int layers = 20;                ///< in the full gap; even (half of them are computed, by symmetry)
  double wall_width_ratio = 0.4;  ///< width of the layer at the wall over that at the mid-plane
  double middle_width_ratio = 1;  ///< share of its width that the layer at the mid-plane gets
  int steps = 300;                ///< steps to aim at; the first and the last are shorter
  HeatModel heat = HeatModel::full;
  double viscosity_tolerance = 1e-3;    ///< largest relative change of a node's fluidity that ends iterating
  int most_iterations = 3;              ///< pressure solutions a step
  double orientation_tolerance = 1e-3;  ///< error of A2 in one internal step of the point law
};

/// The parameters of a filling.
struct FillingParams {
  MoldingMaterial material;
  MoldingProcess process;
  std::vector<Gate> gates;
  std::vector<Sensor> sensors = {};
  MoldingFibers fibers;
  FillingNumerics numerics;
};

/// Checks parameters against each other and the part; raises InputError that lists all faults: a mesh that
/// is too coarse, gates off the part or none that ever opens, a material out of range, a profile without
/// flow, inlets that do not match the classes, laws that cannot be transported.
void check_params(const FillingParams& params, const ShellMesh& mesh);

}  // namespace fiberfate
