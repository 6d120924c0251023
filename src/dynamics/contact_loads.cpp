// Linearises contact, friction and walls.
#include "dynamics/contact_loads.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

/// Resists motion along n and across it differently: normal n nᵀ + tangential (I − n nᵀ).
struct Resistance {
  Vec3 n;
  double normal;
  double tangential;

  [[nodiscard]] Vec3 times(const Vec3& w) const {
    return tangential * w + (normal - tangential) * n.dot(w) * n;
  }
  [[nodiscard]] std::array<double, 6> components() const {
    const double e = normal - tangential;
    return {tangential + e * n.x() * n.x(),
            tangential + e * n.y() * n.y(),
            tangential + e * n.z() * n.z(),
            e * n.y() * n.z(),
            e * n.z() * n.x(),
            e * n.x() * n.y()};
  }
};

/// Makes the load force − R (w − w_old).
RodLoad linear_load(double lever, const Vec3& force, const Resistance& resistance, const Vec3& old_velocity) {
  return {lever, force + resistance.times(old_velocity), resistance.components()};
}

// Loads of walls come after those of contacts.
constexpr std::uint64_t first_wall_key = std::uint64_t{1} << 60;

/// Orders the loads of a rod by the rod that exerts them and its image, seen from this one.
std::uint64_t order_key(Index other, const std::array<std::int8_t, 3>& image, int sign) {
  std::uint64_t key = static_cast<std::uint64_t>(other);
  for (const std::int8_t turns : image) key = key * 256 + static_cast<std::uint64_t>(128 + sign * turns);
  return key;
}

Vec3 velocity_at(std::span<const Vec3> w, Index rod, double place) {
  const auto n = static_cast<std::size_t>(rod);
  return (1 - place) * w[n] + place * w[n + 1];
}

}  // namespace

ContactLoads::ContactLoads(const ContactParameters& parameters, const FiberState& state)
    : parameters_(parameters), materials_(state.materials.size()) {
  for (const FiberMaterial& first : state.materials) {
    for (const FiberMaterial& second : state.materials)
      laws_.emplace_back(parameters, 0.5 * (first.radius + second.radius));
  }
}

double ContactLoads::range() const {
  double range = 0;
  for (const NormalForce& law : laws_) range = std::max(range, law.reach() + parameters_.ramp);
  return range;
}

void ContactLoads::arrange(std::span<const Contact> contacts, const FiberState& state) {
  walls_ = parameters_.force_constant > 0 ? find_wall_contacts(state) : std::vector<WallContact>();
  claims_.clear();
  for (const Contact& contact : contacts) {
    claims_.push_back({contact.first, order_key(contact.second, contact.image, 1)});
    claims_.push_back({contact.second, order_key(contact.first, contact.image, -1)});
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) claims_.push_back({walls_[w].rod, first_wall_key + w});
  loads_.arrange(state.node_count(), claims_, slots_);
  normal_force_.resize(contacts.size());
}

void ContactLoads::evaluate(std::span<const Contact> contacts, const LoadContext& context) {
  parallel_for(static_cast<std::ptrdiff_t>(contacts.size()), [&](std::ptrdiff_t c) {
    evaluate_contact(static_cast<std::size_t>(c), contacts[static_cast<std::size_t>(c)], context);
  });
  for (std::size_t w = 0; w < walls_.size(); ++w)
    loads_.slot(slots_[2 * contacts.size() + w]) = wall_load(walls_[w], context);
}

void ContactLoads::evaluate_contact(std::size_t index, const Contact& contact, const LoadContext& context) {
  const NormalForce& law = laws_[contact.first_material * materials_ + contact.second_material];
  const Vec3& n = contact.normal;
  const Vec3 w1 = velocity_at(context.relative_velocity, contact.first, contact.s);
  const Vec3 w2 = velocity_at(context.relative_velocity, contact.second, contact.t);
  const Vec3 relative = w1 - w2 + contact.distance * (context.flow.gradient * n);
  const double approach = n.dot(relative);
  const Vec3 slip = relative - approach * n;

  const double predicted = contact.distance + context.step * approach;
  const double force = law(predicted);
  const double friction =
      Friction{parameters_.friction, parameters_.slip_velocity}(force, slip.squaredNorm());
  // Pairs about to close are held like closed ones, or they would overshoot the ramp within a step.
  const bool near = predicted < law.reach() + parameters_.ramp;
  const double stiffness = near ? law.stiffness(force) : 0;
  const Resistance resistance{n, 2 * stiffness * context.step, 2 * friction};
  const Vec3 on_first = force * n - friction * slip;
  normal_force_[index] = force;
  loads_.slot(slots_[2 * index]) = linear_load(contact.s, on_first, resistance, w1);
  loads_.slot(slots_[2 * index + 1]) = linear_load(contact.t, -on_first, resistance, w2);
}

RodLoad ContactLoads::wall_load(const WallContact& wall, const LoadContext& context) const {
  // The wall acts like the fiber's own mirror image: axes twice the height apart.
  const NormalForce& law = laws_[wall.material * (materials_ + 1)];
  const Vec3& n = wall.normal;
  const Vec3 w = context.relative_velocity[static_cast<std::size_t>(wall.node)];
  const Vec3 relative = w + wall.height * (context.flow.gradient * n);
  const double approach = n.dot(relative);
  const Vec3 slip = relative - approach * n;

  const double predicted = 2 * (wall.height + context.step * approach);
  const double force = law(predicted);
  const double friction =
      Friction{parameters_.wall_friction, parameters_.slip_velocity}(force, slip.squaredNorm());
  const double stiffness = predicted < law.reach() + parameters_.ramp ? 2 * law.stiffness(force) : 0;
  // The wall's velocity is known, so its term needs no bound of a coupled one.
  const Resistance resistance{n, stiffness * context.step, friction};
  return linear_load(wall.node == wall.rod ? 0.0 : 1.0, force * n - friction * slip, resistance, w);
}

}  // namespace fiberfate
