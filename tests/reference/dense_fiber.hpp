// Solves the motion of one fiber slowly and literally: nine unknowns a rod, dense, as the thesis writes it.
//
// This is the specification of the reduced solver in src/dynamics; nothing here is shared with it. Equations
// (3.1) to (3.3) with the drag re-derived (docs/theory/particles.md): for each rod the force X_i that the rod
// before exerts on it at its first node, the velocity u_i of that node and the angular velocity omega_i.
#pragma once

#include <Eigen/Dense>
#include <cassert>
#include <cmath>
#include <vector>

#include "base/constants.hpp"
#include "base/vector.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate::reference {

/// The sums over the beads of one rod, with rho_k the distance of bead k from the rod's first node.
struct BeadSums {
  double count = 0;   ///< m
  double first = 0;   ///< sum rho_k, m
  double second = 0;  ///< sum rho_k², m²
};

/// Sums over m = l/(2a) touching beads for any real m, by continuing the formula for integers.
inline BeadSums real_valued_beads(double length, double radius) {
  const double m = length / (2 * radius);
  const double about_centre = radius * radius * m * (m * m - 1) / 3;
  return {m, m * length / 2, m * length * length / 4 + about_centre};
}

/// Sums over `count` beads one by one, centred on the rod and touching one another.
inline BeadSums discrete_beads(int count, double length, double radius) {
  BeadSums sums;
  for (int k = 0; k < count; ++k) {
    const double rho = length / 2 + (2 * k - count + 1) * radius;
    sums.count += 1;
    sums.first += rho;
    sums.second += rho * rho;
  }
  return sums;
}

/// The resistance of a rod that is not a chain of beads: with P = p p and centre c,
///   F = (parallel P + perpendicular (I − P)) · (u(c) − v_c),   T = rotational (Omega + shape p × D·p −
///   omega).
struct CentreResistance {
  double parallel = 0;       ///< N s/m
  double perpendicular = 0;  ///< N s/m
  double rotational = 0;     ///< N m s
  double shape = 0;
};

/// Describes a fiber at one instant.
struct DenseFiber {
  std::vector<Vec3> nodes;       ///< m
  double radius = 0;             ///< a, m
  double bending_stiffness = 0;  ///< E I, N m²
  /// Sums of each rod; empty for real-valued bead numbers.
  std::vector<BeadSums> beads = {};
  /// Resistance of each rod; empty for chains of beads.
  std::vector<CentreResistance> resistance = {};

  [[nodiscard]] int rods() const { return static_cast<int>(nodes.size()) - 1; }
  [[nodiscard]] Vec3 axis(int rod) const { return nodes[std::size_t(rod) + 1] - nodes[std::size_t(rod)]; }
  [[nodiscard]] BeadSums sums(int rod) const {
    return beads.empty() ? real_valued_beads(axis(rod).norm(), radius) : beads[std::size_t(rod)];
  }
};

/// A force that acts on a point of a rod.
struct PointLoad {
  int rod = 0;
  double place = 0;  ///< in [0, 1] from the rod's first node
  Vec3 force = Vec3::Zero();
  Vec3 off_axis = Vec3::Zero();  ///< from the axis at `place` to where the force acts, m
};

/// Everything that acts on a fiber besides drag and bending.
struct DenseLoads {
  std::vector<PointLoad> points;
  Eigen::VectorXd node_force = {};    ///< 3 (n+1) entries or empty, N
  Eigen::MatrixXd node_damping = {};  ///< K of a force −K v on the nodes, 3 (n+1) square or empty, N s/m
};

/// What the dense system yields.
struct DenseMotion {
  std::vector<Vec3> node_velocity;     ///< m/s
  std::vector<Vec3> angular_velocity;  ///< of each rod, rad/s
  std::vector<Vec3> joint_force;       ///< X_i, N
};

inline Mat3 cross_matrix(const Vec3& r) {
  Mat3 matrix;
  matrix << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return matrix;
}

/// Bending moment at inner node k on the rod after it; the rod before it gets the opposite. M = E I theta /
/// l̄, N m.
inline Vec3 bending_moment_after(const DenseFiber& fiber, int k) {
  const Vec3 before = fiber.axis(k - 1);
  const Vec3 after = fiber.axis(k);
  const Vec3 normal = before.cross(after);
  const double sine = normal.norm();
  if (sine == 0) return Vec3::Zero();
  const double angle = std::atan2(sine, before.dot(after));
  const double mean_length = (before.norm() + after.norm()) / 2;
  return -fiber.bending_stiffness * angle / mean_length * normal / sine;
}

/// Assembles and solves the dense system of one fiber.
class DenseSystem {
 public:
  DenseSystem(const DenseFiber& fiber, const Flow& flow)
      : fiber_(fiber), flow_(flow), rods_(fiber.rods()), zeta_(6 * pi * flow.viscosity * fiber.radius) {
    unit_length_ = fiber.axis(0).norm();
    unit_drag_ = zeta_ * fiber.sums(0).count;
    matrix_.setZero(9 * rods_, 9 * rods_);
    right_.setZero(9 * rods_);
    for (int i = 0; i < rods_; ++i) {
      if (fiber.resistance.empty()) {
        add_bead_drag(i);
      } else {
        add_centre_drag(i);
      }
      add_joint(i);
    }
    for (int k = 1; k < rods_; ++k) add_bending(k);
  }

  /// Adds an external force.
  void add(const PointLoad& load) {
    right_.segment<3>(force_row(load.rod)) -= load.force;
    right_.segment<3>(torque_row(load.rod)) -=
        (load.place * fiber_.axis(load.rod) + load.off_axis).cross(load.force);
  }

  /// Adds forces on the nodes that depend linearly on the nodes' velocities: force − damping · v.
  void add(const Eigen::VectorXd& force, const Eigen::MatrixXd& damping) {
    for (int k = 0; k <= rods_; ++k) {
      const int rod = k < rods_ ? k : rods_ - 1;
      const double place = k < rods_ ? 0 : 1;
      if (force.size() > 0) add(PointLoad{rod, place, force.segment<3>(3 * k)});
      if (damping.size() > 0) add_damping_row(rod, place, damping.middleRows<3>(3 * k));
    }
  }

  [[nodiscard]] DenseMotion solve() const {
    const Eigen::VectorXd rows = row_scales();
    const Eigen::VectorXd columns = column_scales();
    const Eigen::MatrixXd scaled = rows.asDiagonal() * matrix_ * columns.asDiagonal();
    const Eigen::VectorXd unknowns =
        columns.cwiseProduct(Eigen::PartialPivLU<Eigen::MatrixXd>(scaled).solve(rows.cwiseProduct(right_)));
    return motion_of(unknowns);
  }

 private:
  int force_row(int i) const { return 9 * i; }
  int torque_row(int i) const { return 9 * i + 3; }
  int joint_row(int i) const { return 9 * i + 6; }
  int joint_force(int i) const { return 9 * i; }
  int velocity(int i) const { return 9 * i + 3; }
  int rotation(int i) const { return 9 * i + 6; }

  /// Drag of rod i in (3.1) and (3.2): forces on beads at x_i + rho_k p with velocity u_i + omega_i × rho_k
  /// p.
  void add_bead_drag(int i) {
    const BeadSums sums = fiber_.sums(i);
    const Vec3 p = fiber_.axis(i).normalized();
    const Vec3 flow_at_node = flow_.gradient * fiber_.nodes[std::size_t(i)];
    const Vec3 flow_along = flow_.gradient * p;
    const Mat3 p_cross = cross_matrix(p);
    const double zeta_r = 8 * pi * flow_.viscosity * std::pow(fiber_.radius, 3);
    const Mat3 identity = Mat3::Identity();

    matrix_.block<3, 3>(force_row(i), velocity(i)) -= zeta_ * sums.count * identity;
    matrix_.block<3, 3>(force_row(i), rotation(i)) += zeta_ * sums.first * p_cross;
    right_.segment<3>(force_row(i)) -= zeta_ * (sums.count * flow_at_node + sums.first * flow_along);

    matrix_.block<3, 3>(torque_row(i), velocity(i)) -= zeta_ * sums.first * p_cross;
    matrix_.block<3, 3>(torque_row(i), rotation(i)) +=
        zeta_ * sums.second * p_cross * p_cross - zeta_r * sums.count * identity;
    right_.segment<3>(torque_row(i)) -= zeta_r * sums.count * flow_.angular_velocity() +
                                        zeta_ * p.cross(sums.first * flow_at_node + sums.second * flow_along);
  }

  /// Drag of rod i about its centre, moved to its first node: T = T_c + (l/2) p × F.
  void add_centre_drag(int i) {
    const CentreResistance& drag = fiber_.resistance[std::size_t(i)];
    const Vec3 half = fiber_.axis(i) / 2;
    const Vec3 p = fiber_.axis(i).normalized();
    const Mat3 along = p * p.transpose();
    const Mat3 translation = drag.parallel * along + drag.perpendicular * (Mat3::Identity() - along);
    const Vec3 flow_at_centre = flow_.gradient * (fiber_.nodes[std::size_t(i)] + half);
    const Vec3 free_spin = flow_.angular_velocity() + drag.shape * p.cross(flow_.rate_of_strain() * p);
    const Mat3 lever = cross_matrix(half);

    matrix_.block<3, 3>(force_row(i), velocity(i)) -= translation;
    matrix_.block<3, 3>(force_row(i), rotation(i)) += translation * lever;
    right_.segment<3>(force_row(i)) -= translation * flow_at_centre;

    matrix_.block<3, 3>(torque_row(i), velocity(i)) -= lever * translation;
    matrix_.block<3, 3>(torque_row(i), rotation(i)) +=
        lever * translation * lever - drag.rotational * Mat3::Identity();
    right_.segment<3>(torque_row(i)) -=
        drag.rotational * free_spin + half.cross(translation * flow_at_centre);
  }

  /// Joint forces in (3.1) and (3.2), and connectivity (3.3) with the rod before; the fiber's end is free.
  void add_joint(int i) {
    const Mat3 identity = Mat3::Identity();
    matrix_.block<3, 3>(force_row(i), joint_force(i)) += identity;
    if (i + 1 < rods_) {
      matrix_.block<3, 3>(force_row(i), joint_force(i + 1)) -= identity;
      matrix_.block<3, 3>(torque_row(i), joint_force(i + 1)) -= cross_matrix(fiber_.axis(i));
    }
    if (i == 0) {
      matrix_.block<3, 3>(joint_row(0), joint_force(0)) = identity;
    } else {
      matrix_.block<3, 3>(joint_row(i), velocity(i - 1)) = identity;
      matrix_.block<3, 3>(joint_row(i), rotation(i - 1)) = -cross_matrix(fiber_.axis(i - 1));
      matrix_.block<3, 3>(joint_row(i), velocity(i)) = -identity;
    }
  }

  void add_bending(int k) {
    const Vec3 moment = bending_moment_after(fiber_, k);
    right_.segment<3>(torque_row(k)) -= moment;
    right_.segment<3>(torque_row(k - 1)) += moment;
  }

  /// Adds the force −row · v on a point of a rod; v_k = u_k, and v_n = u_{n−1} + omega_{n−1} × l p.
  void add_damping_row(int rod, double place, const Eigen::Matrix<double, 3, Eigen::Dynamic>& row) {
    const Mat3 lever = cross_matrix(place * fiber_.axis(rod));
    for (int k = 0; k <= rods_; ++k) {
      const Mat3 block = row.middleCols<3>(3 * k);
      const int of_rod = k < rods_ ? k : rods_ - 1;
      matrix_.block<3, 3>(force_row(rod), velocity(of_rod)) -= block;
      matrix_.block<3, 3>(torque_row(rod), velocity(of_rod)) -= lever * block;
      if (k < rods_) continue;
      const Mat3 by_rotation = -block * cross_matrix(fiber_.axis(of_rod));
      matrix_.block<3, 3>(force_row(rod), rotation(of_rod)) -= by_rotation;
      matrix_.block<3, 3>(torque_row(rod), rotation(of_rod)) -= lever * by_rotation;
    }
  }

  // Units of the first rod's length and of its drag, so that pivoting compares like with like.
  Eigen::VectorXd row_scales() const {
    const double force = 1 / unit_drag_;
    Eigen::VectorXd scales(9 * rods_);
    for (int i = 0; i < rods_; ++i) {
      scales.segment<3>(force_row(i)).setConstant(force);
      scales.segment<3>(torque_row(i)).setConstant(force / unit_length_);
      scales.segment<3>(joint_row(i)).setConstant(i == 0 ? force : 1.0);
    }
    return scales;
  }
  Eigen::VectorXd column_scales() const {
    Eigen::VectorXd scales(9 * rods_);
    for (int i = 0; i < rods_; ++i) {
      scales.segment<3>(joint_force(i)).setConstant(unit_drag_);
      scales.segment<3>(velocity(i)).setOnes();
      scales.segment<3>(rotation(i)).setConstant(1 / unit_length_);
    }
    return scales;
  }

  DenseMotion motion_of(const Eigen::VectorXd& unknowns) const {
    DenseMotion motion;
    for (int i = 0; i < rods_; ++i) {
      const Vec3 u = unknowns.segment<3>(velocity(i));
      const Vec3 omega = unknowns.segment<3>(rotation(i));
      motion.joint_force.emplace_back(unknowns.segment<3>(joint_force(i)));
      motion.node_velocity.push_back(u);
      motion.angular_velocity.push_back(omega);
    }
    motion.node_velocity.push_back(motion.node_velocity.back() +
                                   motion.angular_velocity.back().cross(fiber_.axis(rods_ - 1)));
    return motion;
  }

  const DenseFiber& fiber_;
  const Flow& flow_;
  int rods_;
  double zeta_;
  double unit_length_ = 0;
  double unit_drag_ = 0;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_;
};

/// Finds the motion of one fiber in a flow under loads: no inertia, free ends, drag by beads, elastic hinges.
inline DenseMotion solve_dense(const DenseFiber& fiber, const Flow& flow, const DenseLoads& loads = {}) {
  assert(fiber.rods() >= 1);
  DenseSystem system(fiber, flow);
  for (const PointLoad& load : loads.points) system.add(load);
  system.add(loads.node_force, loads.node_damping);
  return system.solve();
}

}  // namespace fiberfate::reference
