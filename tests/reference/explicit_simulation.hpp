// Moves a few fibers slowly and literally: all pairs of rods, dense solves, small explicit steps.
//
// This is the specification of the fast Simulation for small systems. Shared with it are only the data
// (FiberState, ContactParameters) and the closest points of two segments; there is no list, no implicit term,
// no extrapolation.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics/parameters.hpp"
#include "fibers/closest_points.hpp"
#include "fibers/state.hpp"
#include "reference/dense_fiber.hpp"

namespace fiberfate::reference {

/// Holds one contact: forces +F on the first rod and −F on the second at their closest points.
struct PairContact {
  Index first = 0;   ///< node at which the first rod begins
  Index second = 0;  ///< node at which the second rod begins
  double s = 0;
  double t = 0;
  Vec3 normal = Vec3::UnitX();  ///< from the second to the first
  double distance = 0;          ///< m
};

/// Holds a small population that is stepped explicitly.
class ExplicitSimulation {
 public:
  ExplicitSimulation(FiberState state, const Flow& flow, const ContactParameters& contact)
      : state_(std::move(state)), flow_(flow), contact_(contact) {}

  [[nodiscard]] const FiberState& state() const { return state_; }

  /// Makes one explicit Euler step.
  void step(double size) {
    solve_velocities();
    for (std::size_t k = 0; k < state_.position.size(); ++k) {
      const Vec3 velocity = state_.relative_velocity[k] + flow_.gradient * state_.position[k];
      state_.position[k] += size * velocity;
    }
    for (Index f = 0; f < state_.fiber_count(); ++f) restore_lengths(f);
    deform(state_.cell, flow_.gradient, size);
    state_.time += size;
  }

  /// All contacts of rods and of their images that are closer than the reach of the force.
  [[nodiscard]] std::vector<PairContact> contacts() const {
    std::vector<PairContact> found;
    for (Index f = 0; f < state_.fiber_count(); ++f) {
      for (Index g = f; g < state_.fiber_count(); ++g) add_contacts(f, g, found);
    }
    return found;
  }

  /// F_N = min(F_0 (1/2 − (d − d_cut)/ramp), A D exp(−B (d/a − 2))), not below zero; F_0 its value at d_cut.
  [[nodiscard]] double normal_force(double distance) const {
    const double a = state_.materials[0].radius;
    const auto exponential = [&](double d) {
      return contact_.force_constant * 2 * a * std::exp(-contact_.decay * (d / a - 2));
    };
    const double cut = contact_.cutoff * a;
    const double rise = exponential(cut) * (0.5 - (distance - cut) / contact_.ramp);
    return std::max(0.0, std::min(rise, exponential(distance)));
  }

 private:
  void solve_velocities() {
    std::vector<DenseLoads> loads(std::size_t(state_.fiber_count()));
    for (const PairContact& contact : contacts()) {
      const Vec3 force = force_on_first(contact);
      const Vec3 half_way = 0.5 * contact.distance * contact.normal;
      add_load(contact.first, {0, contact.s, force, -half_way}, loads);
      add_load(contact.second, {0, contact.t, -force, half_way}, loads);
    }
    for (Index f = 0; f < state_.fiber_count(); ++f) {
      const auto first = state_.position.begin();
      const DenseFiber fiber{{first + state_.begin_node(f), first + state_.end_node(f)},
                             state_.material(f).radius,
                             state_.material(f).bending_stiffness()};
      const DenseMotion motion = solve_dense(fiber, flow_, loads[std::size_t(f)]);
      for (std::size_t k = 0; k < fiber.nodes.size(); ++k) {
        state_.relative_velocity[std::size_t(state_.begin_node(f)) + k] =
            motion.node_velocity[k] - flow_.gradient * fiber.nodes[k];
      }
    }
  }

  /// Velocity of a rod's skin at `off_axis` from its axis: the rod turns with its nodes, and spins about its
  /// axis with the fluid.
  [[nodiscard]] Vec3 skin_velocity(Index rod, double place, const Vec3& off_axis) const {
    const auto k = std::size_t(rod);
    const Vec3 axis = state_.position[k + 1] - state_.position[k];
    const Vec3 p = axis.normalized();
    const Vec3 v =
        state_.relative_velocity[k] + place * (state_.relative_velocity[k + 1] - state_.relative_velocity[k]);
    const Vec3 change = state_.relative_velocity[k + 1] - state_.relative_velocity[k] + flow_.gradient * axis;
    const Vec3 rotation = p.cross(change) / axis.norm() + p.dot(flow_.angular_velocity()) * p;
    return v + rotation.cross(off_axis);
  }

  /// Normal force and Coulomb friction at the skins, midway between the axes, with the slip of the last step.
  [[nodiscard]] Vec3 force_on_first(const PairContact& contact) const {
    const Vec3& n = contact.normal;
    const Vec3 half_way = 0.5 * contact.distance * n;
    const Vec3 relative = skin_velocity(contact.first, contact.s, -half_way) -
                          skin_velocity(contact.second, contact.t, half_way) +
                          contact.distance * (flow_.gradient * n);
    const Vec3 slip = relative - n.dot(relative) * n;
    const double normal = normal_force(contact.distance);
    const double speed = std::sqrt(slip.squaredNorm() + contact_.slip_velocity * contact_.slip_velocity);
    return normal * n - contact_.friction * normal / speed * slip;
  }

  void add_load(Index rod, PointLoad load, std::vector<DenseLoads>& loads) const {
    const auto after = std::upper_bound(state_.first_node.begin(), state_.first_node.end(), rod);
    const auto fiber = std::size_t(after - state_.first_node.begin() - 1);
    load.rod = int(rod - state_.first_node[fiber]);
    loads[fiber].points.push_back(load);
  }

  void add_contacts(Index f, Index g, std::vector<PairContact>& found) const {
    for (Index i = state_.begin_node(f); i + 1 < state_.end_node(f); ++i) {
      for (Index j = f == g ? i : state_.begin_node(g); j + 1 < state_.end_node(g); ++j) {
        const Vec3 apart = state_.position[std::size_t(j)] - state_.position[std::size_t(i)];
        const Vec3 nearest = (state_.cell.lattice.inverse() * apart).array().round();
        for (int image = 0; image < 27; ++image) {
          const Vec3 offset(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
          add_contact(i, j, (offset - nearest).cast<int>(), found);
        }
      }
    }
  }

  /// Keeps the contact of rod i with the given image of rod j when they touch there.
  void add_contact(Index i, Index j, const IntVec3& image, std::vector<PairContact>& found) const {
    const bool same_chain = fiber_of(i) == fiber_of(j);
    if (same_chain && image.isZero() && j - i <= 1) return;
    if (i == j && !is_positive(image)) return;  // a rod and its image are the same pair seen twice
    const Vec3 shift = state_.cell.shift(image);
    const double reach = 0.5 * (state_.rod_length[std::size_t(i)] + state_.rod_length[std::size_t(j)]) +
                         (contact_.cutoff + 1) * state_.materials[0].radius;
    if ((middle(i) - middle(j) - shift).norm() > reach) return;
    const auto closest = closest_points(
        {state_.position[std::size_t(i)], state_.position[std::size_t(i) + 1]},
        {state_.position[std::size_t(j)] + shift, state_.position[std::size_t(j) + 1] + shift});
    if (normal_force(closest.distance) <= 0) return;
    if (!is_nearest_along_fiber(i, closest.s, -closest.separation)) return;
    if (!is_nearest_along_fiber(j, closest.t, closest.separation)) return;
    found.push_back({i, j, closest.s, closest.t, closest.separation / closest.distance, closest.distance});
  }

  /// Both rods of a hinge may see the same contact there: it counts where the fiber is locally nearest, once.
  [[nodiscard]] bool is_nearest_along_fiber(Index rod, double place, const Vec3& towards_other) const {
    const Index fiber = fiber_of(rod);
    if (place <= 0) return rod == state_.begin_node(fiber);
    if (place < 1 || rod + 2 == state_.end_node(fiber)) return true;
    const Vec3 next = state_.position[std::size_t(rod) + 2] - state_.position[std::size_t(rod) + 1];
    return next.dot(towards_other) <= 0;
  }

  [[nodiscard]] Vec3 middle(Index rod) const {
    return 0.5 * (state_.position[std::size_t(rod)] + state_.position[std::size_t(rod) + 1]);
  }

  static bool is_positive(const IntVec3& image) {
    for (int d = 0; d < 3; ++d) {
      if (image[d] != 0) return image[d] > 0;
    }
    return false;
  }

  [[nodiscard]] Index fiber_of(Index rod) const {
    const auto after = std::upper_bound(state_.first_node.begin(), state_.first_node.end(), rod);
    return Index(after - state_.first_node.begin()) - 1;
  }

  /// Rods keep their lengths but for the step's error; the fiber's centroid stays.
  void restore_lengths(Index f) {
    const Vec3 centroid = fiber_centroid(state_, f);
    std::vector<Vec3> axes;
    for (Index k = state_.begin_node(f); k + 1 < state_.end_node(f); ++k) {
      const auto n = std::size_t(k);
      axes.emplace_back((state_.position[n + 1] - state_.position[n]).normalized() * state_.rod_length[n]);
    }
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto n = std::size_t(state_.begin_node(f)) + i;
      state_.position[n + 1] = state_.position[n] + axes[i];
    }
    const Vec3 shift = centroid - fiber_centroid(state_, f);
    for (Index k = state_.begin_node(f); k < state_.end_node(f); ++k)
      state_.position[std::size_t(k)] += shift;
  }

  FiberState state_;
  Flow flow_;
  ContactParameters contact_;
};

}  // namespace fiberfate::reference
