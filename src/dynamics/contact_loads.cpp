// Linearises contact, friction and walls.
#include "dynamics/contact_loads.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/threads.hpp"
#include "dynamics/contact_forces.hpp"

namespace fiberfate {

ContactLoads::ContactLoads(const ContactParameters& parameters, const FiberState& state)
    : friction_(parameters, parameters.friction),
      wall_friction_(parameters, parameters.wall_friction),
      materials_(state.materials.size()) {
  for (const FiberMaterial& first : state.materials) {
    for (const FiberMaterial& second : state.materials) {
      laws_.emplace_back(parameters, ContactPair{contact_body(first), contact_body(second)});
      constants_.push_back(laws_.back().constants());
    }
  }
}

double ContactLoads::range() const {
  double range = 0;
  for (const NormalForce& law : laws_) range = std::max(range, law.hold());
  return range;
}

void ContactLoads::arrange(const ContactSet& contacts, const FiberState& state) {
  pairs_.deal(contacts, state.node_count());
  arrange_walls(state);
}

void ContactLoads::arrange_walls(const FiberState& state) {
  walls_ = range() > 0 ? find_wall_contacts(state) : std::vector<WallContact>();
  if (walls_.empty() && claims_.empty()) return;
  claims_.clear();
  for (std::size_t w = 0; w < walls_.size(); ++w) claims_.push_back({walls_[w].rod, w});
  wall_loads_.arrange(state.node_count(), claims_, slots_);
}

void ContactLoads::evaluate(const ContactSet& contacts, const LoadContext& context) {
  const Mat3 strain_rate = context.flow.rate_of_strain();
  const ForceQuery query{context.position.front().data(),
                         context.relative_velocity.front().data(),
                         strain_rate.data(),
                         context.step,
                         laws_[0].law(),
                         constants_[0].data(),
                         static_cast<int>(std::tuple_size_v<LawNumbers>),
                         static_cast<int>(materials_),
                         friction_.law(),
                         friction_.constants().data()};
  parallel_for_weighted(pairs_.chunk_begin(), [&](std::size_t c) {
    evaluate_forces(contacts[c], query, pairs_.forces().data() + pairs_.chunk_begin()[c]);
  });
  for (std::size_t w = 0; w < walls_.size(); ++w) wall_loads_.slot(slots_[w]) = wall_load(walls_[w], context);
}

double ContactLoads::largest_normal_force() const {
  double largest = 0;
  for (const PairForce& pair : pairs_.forces()) {
    const double normal =
        pair.force[0] * pair.normal[0] + pair.force[1] * pair.normal[1] + pair.force[2] * pair.normal[2];
    largest = std::max(largest, normal);
  }
  return largest;
}

RodLoad ContactLoads::wall_load(const WallContact& wall, const LoadContext& context) const {
  // The wall acts like the fiber's own mirror image, crossed at right angles: axes twice the height apart.
  const NormalForce& law = laws_[wall.material * (materials_ + 1)];
  const Vec3& n = wall.normal;
  const Vec3 w = context.relative_velocity[wall.node];
  const Vec3 relative = w + wall.height * (context.flow.gradient * n);
  const double approach = n.dot(relative);
  const Vec3 slip = relative - approach * n;

  const double predicted = 2 * (wall.height + context.step * approach);
  const double force = law(predicted);
  const double friction = wall_friction_(force, slip.squaredNorm());
  const double stiffness = 2 * law.stiffness({predicted, 1}, force);
  // The wall's velocity is known, so its term needs no bound of a coupled one.
  const double normal = stiffness * context.step;
  const double excess = normal - friction;
  const Vec3 held = friction * w + excess * n.dot(w) * n;
  return {wall.node == first_end(wall.rod) ? 0.0 : 1.0,
          force * n - friction * slip + held,
          {friction + excess * n.x() * n.x(), friction + excess * n.y() * n.y(),
           friction + excess * n.z() * n.z(), excess * n.y() * n.z(), excess * n.z() * n.x(),
           excess * n.x() * n.y()}};
}

}  // namespace fiberfate
