// Moves a few fibers slowly and literally: all pairs of rods, dense solves, small explicit steps.
//
// This is the specification of the fast Simulation for small systems. Shared with it are only the data
// (FiberState, ContactParameters) and the closest points of two segments; there is no list, no implicit term,
// no extrapolation.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dynamics/parameters.hpp"
#include "fibers/closest_points.hpp"
#include "fibers/state.hpp"
#include "reference/dense_fiber.hpp"

namespace fiberfate::reference {

/// One contact: forces +F on the first rod and −F on the second at their closest points.
struct PairContact {
  RodIndex first;
  RodIndex second;
  double s = 0;
  double t = 0;
  Vec3 normal = Vec3::UnitX();  ///< from the second to the first
  double distance = 0;          ///< m
};

/// A small population that is stepped explicitly.
class ExplicitSimulation {
 public:
  ExplicitSimulation(FiberState state, const Flow& flow, const ContactParameters& contact)
      : state_(std::move(state)), flow_(flow), contact_(contact) {}

  [[nodiscard]] const FiberState& state() const { return state_; }

  /// Makes one explicit Euler step.
  void step(double size) {
    solve_velocities();
    for (const NodeIndex k : state_.nodes()) {
      const Vec3 velocity = state_.relative_velocity[k] + flow_.gradient * state_.position[k];
      state_.position[k] += size * velocity;
    }
    for (const FiberIndex f : state_.fibers()) restore_lengths(f);
    deform(state_.cell, flow_.gradient, size);
    state_.time += size;
  }

  /// All contacts of rods and of their images that are closer than the reach of the force.
  [[nodiscard]] std::vector<PairContact> contacts() const {
    std::vector<PairContact> found;
    for (const FiberIndex f : state_.fibers()) {
      for (FiberIndex g = f; g < FiberIndex(state_.fiber_count()); ++g) add_contacts(f, g, found);
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
  using Loads = IndexedVector<FiberIndex, DenseLoads>;

  void solve_velocities() {
    Loads loads(state_.fiber_count());
    for (const PairContact& contact : contacts()) {
      const Vec3 force = force_on_first(contact);
      const Vec3 half_way = 0.5 * contact.distance * contact.normal;
      add_load(contact.first, {0, contact.s, force, -half_way}, loads);
      add_load(contact.second, {0, contact.t, -force, half_way}, loads);
    }
    for (const FiberIndex f : state_.fibers()) {
      const auto nodes = state_.positions(f);
      const DenseFiber fiber{
          {nodes.begin(), nodes.end()}, state_.material(f).radius, state_.material(f).bending_stiffness()};
      const DenseMotion motion = solve_dense(fiber, flow_, loads[f]);
      for (const NodeIndex node : state_.nodes(f)) {
        const Vec3& velocity = motion.node_velocity[node - state_.begin_node(f)];
        state_.relative_velocity[node] = velocity - flow_.gradient * state_.position[node];
      }
    }
  }

  /// Velocity of a rod's skin at `off_axis` from its axis: the rod turns with its nodes, and spins about its
  /// axis with the fluid.
  [[nodiscard]] Vec3 skin_velocity(RodIndex rod, double place, const Vec3& off_axis) const {
    const Vec3 axis = state_.axis(rod);
    const Vec3 p = axis.normalized();
    const Vec3& begin = state_.relative_velocity[first_end(rod)];
    const Vec3& end = state_.relative_velocity[second_end(rod)];
    const Vec3 v = begin + place * (end - begin);
    const Vec3 change = end - begin + flow_.gradient * axis;
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

  void add_load(RodIndex rod, PointLoad load, Loads& loads) const {
    load.rod = first_end(rod) - state_.begin_node(fiber_of(rod));
    loads[fiber_of(rod)].points.push_back(load);
  }

  void add_contacts(FiberIndex f, FiberIndex g, std::vector<PairContact>& found) const {
    for (const RodIndex i : state_.rods(f)) {
      for (const RodIndex j : state_.rods(g)) {
        if (j < i) continue;
        const Vec3 apart = state_.position[first_end(j)] - state_.position[first_end(i)];
        const Vec3 nearest = (state_.cell.lattice.inverse() * apart).array().round();
        for (int image = 0; image < 27; ++image) {
          const Vec3 offset(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
          add_contact(i, j, (offset - nearest).cast<int>(), found);
        }
      }
    }
  }

  /// Keeps the contact of rod i with the given image of rod j when they touch there.
  void add_contact(RodIndex i, RodIndex j, const IntVec3& image, std::vector<PairContact>& found) const {
    const bool same_chain = fiber_of(i) == fiber_of(j);
    if (same_chain && image.isZero() && j - i <= 1) return;
    if (i == j && !is_positive(image)) return;  // a rod and its image are the same pair seen twice
    const Vec3 shift = state_.cell.shift(image);
    const double reach = 0.5 * (state_.rod_length[i] + state_.rod_length[j]) +
                         (contact_.cutoff + 1) * state_.materials[0].radius;
    if ((state_.centre(i) - state_.centre(j) - shift).norm() > reach) return;
    const auto closest = closest_points(state_.segment(i), shifted(state_.segment(j), shift));
    if (normal_force(closest.distance) <= 0) return;
    if (!is_nearest_along_fiber(i, closest.s, -closest.separation)) return;
    if (!is_nearest_along_fiber(j, closest.t, closest.separation)) return;
    found.push_back({i, j, closest.s, closest.t, closest.separation / closest.distance, closest.distance});
  }

  /// Both rods of a hinge may see the same contact there: it counts where the fiber is locally nearest, once.
  [[nodiscard]] bool is_nearest_along_fiber(RodIndex rod, double place, const Vec3& towards_other) const {
    const FiberIndex fiber = fiber_of(rod);
    if (place <= 0) return first_end(rod) == state_.begin_node(fiber);
    if (place < 1 || second_end(rod) == state_.last_node(fiber)) return true;
    return state_.axis(rod + 1).dot(towards_other) <= 0;
  }

  static bool is_positive(const IntVec3& image) {
    for (int d = 0; d < 3; ++d) {
      if (image[d] != 0) return image[d] > 0;
    }
    return false;
  }

  [[nodiscard]] FiberIndex fiber_of(RodIndex rod) const {
    const auto after = std::upper_bound(state_.first_node.begin(), state_.first_node.end(), first_end(rod));
    return FiberIndex(after - state_.first_node.begin() - 1);
  }

  /// Rods keep their lengths but for the step's error; the fiber's centroid stays.
  void restore_lengths(FiberIndex f) {
    const Vec3 centroid = fiber_centroid(state_, f);
    Vec3 end = state_.position[state_.begin_node(f)];
    for (const RodIndex rod : state_.rods(f)) {
      const Vec3 axis = state_.axis(rod).normalized() * state_.rod_length[rod];
      state_.position[first_end(rod)] = std::exchange(end, end + axis);
    }
    state_.position[state_.last_node(f)] = end;
    const Vec3 shift = centroid - fiber_centroid(state_, f);
    for (const NodeIndex node : state_.nodes(f)) state_.position[node] += shift;
  }

  FiberState state_;
  Flow flow_;
  ContactParameters contact_;
};

}  // namespace fiberfate::reference
