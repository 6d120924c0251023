// Differentiates the layers' velocities over the neighbours of a node.
#include "molding/layer_gradients.hpp"

#include <cmath>

namespace fiberfate {
namespace {

/// Adds the derivatives in the surface to components 11, 12, 21, 22.
void add_surface_derivatives(const ShellMesh& mesh, const MeltMotion& motion, std::size_t node,
                             LayerGradients& gradients) {
  const GapLayers& layers = motion.layers;
  const StepFlow& step = motion.step;
  const FlowField& field = motion.field;
  double xx = 0, xy = 0, yy = 0;
  for (const ShellNeighbour& to : mesh.neighbours(node)) {
    if (step.at_front[to.node] != 0) continue;
    xx += to.direction[0] * to.direction[0];
    xy += to.direction[0] * to.direction[1];
    yy += to.direction[1] * to.direction[1];
  }
  const double det = xx * yy - xy * xy;
  if (!(det > 1e-3 * (xx + yy) * (xx + yy))) return;  // the neighbours stand in a line
  const std::size_t count = layers.count();
  // Mean velocity of a layer: -(H²/4) s share/width grad p.
  const auto mobility = [&](std::size_t i) {
    return mesh.thickness(i) * mesh.thickness(i) / 4 * field.fluidity[i];
  };
  const double here = mobility(node);
  for (const ShellNeighbour& to : mesh.neighbours(node)) {
    if (step.at_front[to.node] != 0) continue;
    const std::size_t other = to.node;
    const double x = (yy * to.direction[0] - xy * to.direction[1]) / (det * to.length);
    const double y = (xx * to.direction[1] - xy * to.direction[0]) / (det * to.length);
    const Vec2 there = mobility(other) * to.turned(field.gradient[other]);
    for (std::size_t k = 0; k < count; ++k) {
      if (field.inverse_viscosity[node * count + k] == 0) continue;
      const double width = layers.widths()[k];
      const double share_there = field.shares[other * count + k] / width;
      const double share_here = here * field.shares[node * count + k] / width;
      const double u = share_here * field.gradient[node][0] - share_there * there[0];
      const double v = share_here * field.gradient[node][1] - share_there * there[1];
      gradients[0][k] += u * x;
      gradients[1][k] += u * y;
      gradients[3][k] += v * x;
      gradients[4][k] += v * y;
    }
  }
}

}  // namespace

void find_layer_gradients(const ShellMesh& mesh, const MeltMotion& motion, std::size_t node,
                          LayerGradients& gradients) {
  const GapLayers& layers = motion.layers;
  const FlowField& field = motion.field;
  const std::size_t count = layers.count();
  for (auto& component : gradients) std::fill_n(component.begin(), count, 0.0);
  if (motion.step.at_front[node] == 0) add_surface_derivatives(mesh, motion, node, gradients);
  const double half = mesh.thickness(node) / 2;
  for (std::size_t k = 0; k < count; ++k) {
    const double shear = half * layers.shear_heights()[k] * field.inverse_viscosity[node * count + k];
    gradients[2][k] = shear * field.gradient[node][0];
    gradients[5][k] = shear * field.gradient[node][1];
    gradients[8][k] = -gradients[0][k] - gradients[4][k];
  }
}

}  // namespace fiberfate
