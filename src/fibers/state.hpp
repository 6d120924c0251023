// The state of a population of fibers; the state is the checkpoint, nothing else carries history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fibers/cell.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"
#include "fibers/fiber_nodes.hpp"

namespace fiberfate {

/// Describes what a fiber is made of.
struct FiberMaterial {
  double radius = 0;          ///< a, m
  double youngs_modulus = 0;  ///< E, Pa
  double density = 0;         ///< kg/m³; only the weight fraction needs it

  [[nodiscard]] double diameter() const { return 2 * radius; }
  /// Bending stiffness E I = E pi a⁴/4, N m².
  [[nodiscard]] double bending_stiffness() const;
};

/// What the laws of contact need to know of a fiber.
[[nodiscard]] inline ContactBody contact_body(const FiberMaterial& material) {
  return {material.radius, material.youngs_modulus};
}

/// All fibers as a struct of arrays; positions are in m. Velocities are kept relative to the fluid, w = v −
/// kappa·x: then re-choosing a fiber's image changes no velocity.
struct FiberState : FiberNodes {
  IndexedVector<NodeIndex, Vec3> relative_velocity;  ///< w = v − kappa·x of the last step, m/s
  IndexedVector<RodIndex, double> rod_length;        ///< l, m; 0 at the number of a fiber's last node

  IndexedVector<FiberIndex, std::uint32_t> birth_id;     ///< number of the original fiber
  IndexedVector<FiberIndex, std::uint32_t> birth_node;   ///< place of the first node along the original fiber
  IndexedVector<FiberIndex, std::uint16_t> material_id;  ///< index into materials
  /// 1 while the fiber's first rod still touches the rod it broke off (the last one of the fiber stored
  /// before it): that pair is exempt from contact until it has separated.
  IndexedVector<FiberIndex, std::uint8_t> touches_previous;

  std::vector<FiberMaterial> materials;
  Cell cell;

  double time = 0;             ///< s
  double step_size = 0;        ///< proposal for the next step, s; 0 before the first
  std::int64_t step = 0;       ///< accepted steps so far
  std::int64_t rod_steps = 0;  ///< sum over accepted steps of the number of rods
  std::int64_t breakage_checks =
      0;                    ///< checks done so far; the next one is due at its multiple of the interval
  std::int64_t breaks = 0;  ///< hinges broken so far

  [[nodiscard]] const FiberMaterial& material(FiberIndex fiber) const {
    return materials[material_id[fiber]];
  }
};

/// Describes one fiber to be added to a state.
struct FiberShape {
  std::span<const Vec3> nodes;    ///< at least two, m
  std::uint16_t material_id = 0;  ///< index into FiberState::materials
};

/// Appends a fiber; its rod lengths are the node distances, its birth id the number of fibers before it.
/// Raises InputError for fewer than two nodes, one that is not finite, a rod without length, or an unknown
/// material.
void append_fiber(FiberState& state, const FiberShape& fiber);

/// Length of a fiber: the sum of its rods' lengths, m.
[[nodiscard]] double fiber_length(const FiberState& state, FiberIndex fiber);

/// Mean of a fiber's node positions weighted by the adjoining rods' lengths, m.
[[nodiscard]] Vec3 fiber_centroid(const FiberState& state, FiberIndex fiber);

/// Radius of the circle through the three nodes at an inner node (hinge), m; infinity where they are on a
/// line. For equal rods R = l / (2 sin(theta/2)) with theta the turning angle.
[[nodiscard]] double hinge_radius(const Vec3& before, const Vec3& at, const Vec3& after);
[[nodiscard]] inline double hinge_radius(const FiberState& state, NodeIndex hinge) {
  return hinge_radius(state.position[hinge - 1], state.position[hinge], state.position[hinge + 1]);
}

/// Splits fibers at the given inner nodes (strictly increasing); the parts are stored where the whole was, in
/// order. Each such node is doubled; lengths, rod count, velocities and material positions are conserved
/// exactly.
void split_fibers(FiberState& state, std::span<const NodeIndex> nodes);

/// Numbers the fibers of a state that has not moved yet by height: by their centroids' places along the
/// second lattice vector, the gradient direction of a shear. Threads step consecutive fibers, and in a shear
/// those then soon have few contacts with what the others step.
void number_by_height(FiberState& state);

/// Moves every fiber to the image whose centroid lies in the cell (walled directions are left alone).
void wrap_fibers(FiberState& state);

/// Volume of all fibers over the volume of the cell.
[[nodiscard]] double volume_fraction(const FiberState& state);

}  // namespace fiberfate
