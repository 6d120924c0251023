// The two sides of a contact in a solved step: what each rod gets, and how the skins move.
#pragma once

#include "dynamics/particle_stress.hpp"

namespace fiberfate {

/// One rod of a contact.
class RodSide {
 public:
  /// `sign` is 1 for the first rod of the pair, −1 for the second; `place` is where along the rod.
  RodSide(const SolvedStep& step, const PairForce& pair, RodIndex rod, double sign);

  [[nodiscard]] double sign() const { return sign_; }
  /// The force that moved the rod: the linearised one at the solved velocities, N.
  [[nodiscard]] const Vec3& force() const { return force_; }
  /// What the nodes have, positions or velocities, at the place of the contact on the rod's axis.
  [[nodiscard]] Vec3 on_axis(IndexedSpan<NodeIndex, const Vec3> nodes) const;
  /// First moment of the node forces that stand for the couple, symmetric, N m.
  [[nodiscard]] Mat3 couple_moment(IndexedSpan<NodeIndex, const Vec3> nodes) const;
  /// The couple about the rod's own axis, which nothing takes up, N m.
  [[nodiscard]] Vec3 lost_torque() const;
  /// What the rod's turning adds to the velocity of its skin, each unit of distance in the direction
  /// `normal`.
  [[nodiscard]] Vec3 turning(IndexedSpan<NodeIndex, const Vec3> w, const Mat3& strain_rate) const;

 private:
  [[nodiscard]] Vec3 skin_velocity(IndexedSpan<NodeIndex, const Vec3> w) const;

  RodIndex rod_;
  double sign_, place_, distance_, length_;
  Vec3 normal_, direction_, force_;
};

/// Both sides, seen from a rod.
class ContactSides {
 public:
  ContactSides(const SolvedStep& step, RodIndex rod, const PairForces::Share& share);

  [[nodiscard]] const RodSide& own() const { return own_; }
  [[nodiscard]] const RodSide& other() const { return other_; }
  [[nodiscard]] const Vec3& normal() const { return normal_; }
  /// Force on the first rod, the mean of what both sides feel, N.
  [[nodiscard]] Vec3 mean_force() const;
  /// From the axis of the second rod, in the image that touches, to that of the first, in the middle of the
  /// step, m.
  [[nodiscard]] const Vec3& gap() const { return gap_; }
  /// Velocity of the first skin relative to the second, m/s.
  [[nodiscard]] const Vec3& slip() const { return slip_; }

 private:
  RodSide own_, other_;
  Vec3 normal_, gap_, slip_;
};

}  // namespace fiberfate
