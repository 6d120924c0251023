// The contact of two fibers creates neither momentum nor angular momentum.
#include <gtest/gtest.h>

#include "dynamics/chain_solver.hpp"
#include "dynamics/contact_loads.hpp"
#include "reference/append_contact.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

/// Two bent fibers that overlap by a tenth of a radius, off their middles, in a fluid at rest.
FiberState overlapping_fibers() {
  FiberState state = scenes::empty_cell(2e-3);
  const std::vector<Vec3> first = {{-2e-4, 1e-5, 0}, {-1e-4, 0, 0}, {1e-4, 0, 0}, {2.2e-4, 3e-5, 0}};
  std::vector<Vec3> second = {{3e-5, -1e-4, 0}, {5e-5, 0, 0}, {5e-5, 1.5e-4, 0}};
  for (Vec3& node : second) node += Vec3(0, -3e-5, 1.9 * scenes::glass.radius);
  append_fiber(state, {.nodes = first, .material_id = 0});
  append_fiber(state, {.nodes = second, .material_id = 0});
  return state;
}

/// Sums of the drag on all rods: force, and torque about the origin.
struct Wrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  double force_scale = 0;
  double torque_scale = 0;
};

/// Names a law of each kind that acts between melt and fibers.
struct Laws {
  const char* drag;
  const char* contact;
  int sweeps;  ///< until friction has converged: the weaker the drag beside it, the more
};
constexpr Laws laws_to_try[] = {{"beads", "exponential", 200}, {"slender_body", "hertz", 40000}};

/// Evaluates the drag on every rod of a fiber from the velocities w of a fluid at rest: −(parallel p p +
/// perpendicular (I − p p)) w(c) at the centre, and −rotational p × (w_{i+1} − w_i)/l.
Wrench drag_of_fiber(const FiberState& state, const FiberNodes& start, FiberIndex f, const char* law) {
  Wrench sum;
  const auto drag = unit_drag_of_rods(state, law);
  for (const RodIndex n : state.rods(f)) {
    const Vec3& before = state.relative_velocity[first_end(n)];
    const Vec3& after = state.relative_velocity[second_end(n)];
    const Vec3 axis = start.axis(n);
    const Vec3 middle = 0.5 * (before + after);
    const Vec3 along = axis * axis.dot(middle) / axis.squaredNorm();
    const Vec3 force =
        -scenes::melt_viscosity * (drag[n].perpendicular * (middle - along) + drag[n].parallel * along);
    const Vec3 couple =
        -scenes::melt_viscosity * drag[n].rotational * axis.cross(after - before) / axis.squaredNorm();
    const Vec3 torque = couple + start.centre(n).cross(force);
    sum.force += force;
    sum.torque += torque;
    sum.force_scale += force.norm();
    sum.torque_scale += couple.norm() + axis.norm() * force.norm();
  }
  return sum;
}

Wrench drag_of(const FiberState& state, const FiberNodes& start, const char* law) {
  Wrench sum;
  for (const FiberIndex f : state.fibers()) {
    const Wrench one = drag_of_fiber(state, start, f, law);
    sum.force += one.force;
    sum.torque += one.torque;
    sum.force_scale += one.force_scale;
    sum.torque_scale += one.torque_scale;
  }
  return sum;
}

FiberState stepped(const FiberState& start, double friction, const Laws& laws) {
  DynamicsParameters parameters = scenes::fixed_step(1e-15);
  parameters.drag = laws.drag;
  parameters.contact.law = laws.contact;
  parameters.contact.friction = friction;
  parameters.contact.slip_velocity = 1e-4;
  parameters.contact.sweeps = laws.sweeps;
  Simulation simulation(parameters, FlowHistory::constant(0, scenes::melt_viscosity), start);
  for (int i = 0; i < 5; ++i) simulation.advance(1);
  EXPECT_EQ(simulation.contact_statistics().contacts, 1);
  return simulation.state();
}

// Without inertia, momentum balance means that the drag on both fibers sums to zero. Action equals reaction
// once the sweeps have converged (each side is implicit in its own velocity only); the rest is round-off.
TEST(ContactMomentum, BalancesWithoutFriction) {
  const FiberState start = overlapping_fibers();
  for (const Laws& laws : laws_to_try) {
    const Wrench sum = drag_of(stepped(start, 0, laws), start, laws.drag);
    EXPECT_GT(sum.force_scale, 1e-3);
    EXPECT_LT(sum.force.norm(), 1e-11 * sum.force_scale) << laws.drag << ' ' << laws.contact;
    EXPECT_LT(sum.torque.norm(), 1e-11 * sum.torque_scale) << laws.drag << ' ' << laws.contact;
  }
}

// Friction acts where the skins touch, so its forces balance, and so do its torques but for the parts along
// the rods' axes: those would spin the rods, and the fibers' torsion takes them up. The crossing rods' axes
// are given, so that part is known: −(d/2) p p·(n × F) of each, with F the force on the first rod.
class SpinOfFriction : public testing::TestWithParam<Laws> {};

TEST_P(SpinOfFriction, IsAllThatIsMissingFromTheBalance) {
  const Laws& laws = GetParam();
  const FiberState start = overlapping_fibers();
  const FiberState end = stepped(start, 0.3, laws);
  const Wrench sum = drag_of(end, start, laws.drag);
  EXPECT_LT(sum.force.norm(), 1e-11 * sum.force_scale);
  // The drag on the second fiber balances the force on it, −F.
  const Vec3 force = -drag_of_fiber(end, start, FiberIndex(0), laws.drag).force;
  const Vec3 n = Vec3::UnitZ() * -1;  // the second fiber lies above the first
  const double distance = 1.9 * scenes::glass.radius;
  Vec3 spin = Vec3::Zero();
  for (const Vec3& p : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
    spin -= 0.5 * distance * p * p.dot(n.cross(force));
  EXPECT_GT(spin.norm(), 1e-4 * sum.torque_scale) << "there is no friction to speak of";
  EXPECT_LT((sum.torque - spin).norm(), 1e-9 * sum.torque_scale);
}
INSTANTIATE_TEST_SUITE_P(Laws, SpinOfFriction, testing::ValuesIn(laws_to_try));

class ForceOfAContact : public testing::TestWithParam<std::string> {};

// The force of a contact, which the kernel evaluates in packs, is that of the laws.
TEST_P(ForceOfAContact, ObeysTheLaws) {
  FiberState state = overlapping_fibers();
  for (const NodeIndex k : state.nodes()) {
    const double n = k.value();
    state.relative_velocity[k] = 1e-4 * Vec3(std::sin(3 * n), std::cos(2 * n), 0.3 * n);
  }
  ContactParameters parameters;
  parameters.law = GetParam();
  ContactLoads loads(parameters, state);
  const Segment first = state.segment(RodIndex(1)), second = state.segment(RodIndex(5));
  const auto closest = closest_points(first, second);
  Contact contact;
  contact.first = RodIndex(1);
  contact.second = RodIndex(5);
  contact.s = closest.s;
  contact.t = closest.t;
  contact.normal = closest.separation / closest.distance;
  contact.distance = closest.distance;
  ContactSet contacts(1);
  reference::append_contact(contacts[0], contact);
  loads.arrange(contacts, state);
  loads.evaluate(contacts, {state.position, state.relative_velocity, simple_shear(10, 200), 1e-5});
  ASSERT_EQ(loads.pairs().forces().size(), 1u);
  // The force is stored once, so that reaction is its negative; it must be what the laws give.
  const PairForce& force = loads.pairs().forces()[0];
  const Flow flow = simple_shear(10, 200);
  // Velocity of the skin, off the axis by h, relative to the fluid at the axis.
  const auto skin_velocity = [&](RodIndex rod, double place, const Vec3& h) -> Vec3 {
    const Vec3 axis = state.axis(rod);
    const Vec3 p = axis.normalized();
    const Vec3& begin = state.relative_velocity[first_end(rod)];
    const Vec3 change = state.relative_velocity[second_end(rod)] - begin;
    const Vec3 turning =
        p.cross(change + flow.gradient * axis) / axis.norm() + p.dot(flow.angular_velocity()) * p;
    return begin + place * change + turning.cross(h);
  };
  const Vec3& n = contact.normal;
  const Vec3 half_way = 0.5 * contact.distance * n;
  const Vec3 relative = skin_velocity(contact.first, contact.s, -half_way) -
                        skin_velocity(contact.second, contact.t, half_way) +
                        contact.distance * (flow.gradient * n);
  const double approach = n.dot(relative);
  const double sine =
      (first.end - first.begin).normalized().cross((second.end - second.begin).normalized()).norm();
  const Vec3 slip = relative - approach * n;
  const double normal =
      NormalForce(parameters, scenes::glass_pair)({contact.distance + 1e-5 * approach, sine});
  const Vec3 expected =
      normal * n - Friction(parameters, parameters.friction)(normal, slip.squaredNorm()) * slip;
  EXPECT_GT(expected.norm(), 1e-3);
  EXPECT_LT((Vec3(force.force[0], force.force[1], force.force[2]) - expected).norm(),
            1e-13 * expected.norm());
}
INSTANTIATE_TEST_SUITE_P(Laws, ForceOfAContact, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const ContactRow& row : contact_laws()) names.emplace_back(row.text.name);
                           return names;
                         }()));

}  // namespace
}  // namespace fiberfate
