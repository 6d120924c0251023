// Finds by how much fibers raise the viscosity.
#include "molding/viscosity_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

/// Shorter fibers than this are grains, for which the particle number is not defined.
constexpr double least_aspect_ratio = 1.001;

/// (D:A4:D)/(D:D) for shear across the gap along a direction of the surface.
double share_of_stretching(const FillingState& state, std::size_t point, const Vec2& direction,
                           Closure closure) {
  Vec6 a;
  for (std::size_t m = 0; m < 6; ++m) a[static_cast<Eigen::Index>(m)] = state.orientation[m][point];
  Mat3 strain = Mat3::Zero();
  strain(0, 2) = strain(2, 0) = direction[0];
  strain(1, 2) = strain(2, 1) = direction[1];
  return double_dot(strain, closed_double_dot(to_matrix(a), strain, closure)) / double_dot(strain, strain);
}

}  // namespace

std::vector<double> ViscosityStretch::at(const FillingState& state, const FlowField& field) const {
  const FiberCoupling& coupling = *fibers_.coupling;
  const std::size_t count = cavity_.layers.count(), n = cavity_.mesh.node_count();
  const std::size_t fields = state.lengths.size() / (n * count);
  const std::size_t place = length_field_ < 0 ? 0 : static_cast<std::size_t>(length_field_);
  const Closure closure = fibers_.orientation->closure;
  std::vector<double> stretching(n * count, 1);
  parallel_for(static_cast<std::ptrdiff_t>(n), [&](std::size_t node) {
    if (!(state.filled[node] > 0) || field.gradient.size() != n) return;
    const Vec2 gradient = field.gradient[node];
    if (!(gradient.norm() > 0)) return;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t point = node * count + k;
      const double ratio = length_field_ < 0 ? coupling.aspect_ratio
                                             : state.lengths[point * fields + place] / coupling.diameter;
      const double term = coupling.scale * coupling.volume_fraction *
                          particle_number(std::max(ratio, least_aspect_ratio), coupling.volume_fraction);
      stretching[point] = 1 + term * share_of_stretching(state, point, gradient.normalized(), closure);
    }
  });
  return stretching;
}

}  // namespace fiberfate
