// Turns contacts of rods, and of rods with walls, into loads that are implicit in the rods' velocities.
#pragma once

#include <span>
#include <vector>

#include "dynamics/contact_set.hpp"
#include "dynamics/friction_laws/friction_registry.hpp"
#include "dynamics/pair_forces.hpp"
#include "dynamics/rod_loads.hpp"
#include "dynamics/wall_search.hpp"
#include "fibers/contact_laws/contact_registry.hpp"
#include "fibers/state.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate {

/// What the loads of a step are linearised about.
struct LoadContext {
  IndexedSpan<NodeIndex, const Vec3> position;           ///< m
  IndexedSpan<NodeIndex, const Vec3> relative_velocity;  ///< w of the last solve, m/s
  Flow flow;
  double step = 0;  ///< s
};

/// Linearises contact forces about the last known velocities, each side by itself.
///
/// With v_r the relative velocity of the contact points, the gap is predicted, d* = d + step n·v_r, and side
/// i gets
///   f_i(w) = F(d*) n − z v_t − R (w − w_old),   R = 2 k step n nᵀ + 2 z (I − n nᵀ)
/// with k the stiffness of the normal force and z the resistance of friction; side j gets the opposite force
/// with its own w. At w = w_old action equals reaction exactly. The factor 2 makes the two one-sided terms
/// bound the coupled one, (v_i − v_j)² <= 2 v_i² + 2 v_j²: velocities converge monotonically, without
/// ringing, at any step. Slip is that of the skins, midway between the axes (the rods' spin is the fluid's),
/// and friction acts there: it turns the rods, too (PairForce).
class ContactLoads {
 public:
  ContactLoads(const ContactParameters& parameters, const FiberState& state);

  /// Makes room for the forces of these contacts and finds the walls' contacts.
  void arrange(const ContactSet& contacts, const FiberState& state);
  /// Evaluates the loads of the contacts that were arranged.
  void evaluate(const ContactSet& contacts, const LoadContext& context);

  /// Forces between rods.
  [[nodiscard]] const PairForces& pairs() const { return pairs_; }
  /// Loads of the walls.
  [[nodiscard]] const RodLoads& walls() const { return wall_loads_; }
  [[nodiscard]] const std::vector<WallContact>& wall_contacts() const { return walls_; }
  /// The load of a wall's contact, by its number.
  [[nodiscard]] const RodLoad& load_of_wall(std::size_t contact) const {
    return wall_loads_.at(slots_[contact]);
  }
  /// Largest normal force of a contact of rods, N.
  [[nodiscard]] double largest_normal_force() const;
  /// Predicted distance of axes below which two rods act on each other (those about to close included), m;
  /// 0 where they never do.
  [[nodiscard]] double range() const;

 private:
  void arrange_walls(const FiberState& state);
  [[nodiscard]] RodLoad wall_load(const WallContact& wall, const LoadContext& context) const;

  Friction friction_;
  Friction wall_friction_;
  std::size_t materials_ = 0;
  std::vector<NormalForce> laws_;  // by pair of materials
  std::vector<LawNumbers> constants_;
  PairForces pairs_;
  std::vector<WallContact> walls_;
  std::vector<RodLoads::Claim> claims_;  // one a wall contact
  std::vector<RodLoads::Slot> slots_;    // of the claims
  RodLoads wall_loads_;
};

}  // namespace fiberfate
