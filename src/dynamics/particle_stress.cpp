// Sums first moments of forces over rods, hinges and contacts.
#include "dynamics/particle_stress.hpp"

#include <cmath>

#include "base/threads.hpp"
#include "dynamics/contact_sides.hpp"
#include "dynamics/dissipation.hpp"

namespace fiberfate {
namespace {

Mat3 sym(const Vec3& a, const Vec3& b) {
  const Mat3 dyad = a * b.transpose();
  return 0.5 * (dyad + dyad.transpose());
}

/// Stresslet of one rod whose centre the melt's force acts on, N m; what it dissipates is rod_dissipation's.
Mat3 rod_stresslet(const RodDrag& drag, const RodMotion& motion) {
  const Vec3& p = motion.direction;
  const Vec3 strained = motion.rate_of_strain * p;
  const double stretch = p.dot(strained);
  const StrainResistance& s = drag.strain;
  return s.along * stretch * sym(p, p) + s.aslant * sym(p, strained - stretch * p) +
         s.across * (motion.rate_of_strain - 2 * sym(p, strained) + 0.5 * stretch * sym(p, p)) +
         drag.rotational * drag.shape * sym(p, motion.spin.cross(p));
}

/// Sums over one fiber, N m and W.
class FiberSum {
 public:
  FiberSum(const SolvedStep& step, FiberIndex fiber)
      : step_(step),
        problem_(step.problem),
        state_(step.problem.state),
        strain_rate_(problem_.flow.rate_of_strain()),
        fiber_(fiber),
        centroid_(Vec3::Zero()) {
    for (const NodeIndex node : state_.nodes(fiber)) centroid_ += problem_.geometry[node];
    centroid_ /= static_cast<double>(state_.nodes(fiber).size());
  }

  void add_rod(RodIndex rod, const RodDrag& drag);
  void add_hinge(NodeIndex hinge, const Hinge& law);
  void add_pairs(RodIndex rod);
  void add_wall(const WallContact& wall, const RodLoad& load);
  [[nodiscard]] const ParticleStress& sum() const { return sum_; }

 private:
  [[nodiscard]] Vec3 place(NodeIndex node) const { return problem_.geometry[node] - centroid_; }
  Mat3& part(StressCause cause) { return sum_.by_cause[static_cast<std::size_t>(cause)]; }
  double& power(PowerSink sink) { return sum_.power[static_cast<std::size_t>(sink)]; }
  void add_moment(const Mat3& moment, const Vec3& normal, const Vec3& arm, const Vec3& force);

  const SolvedStep& step_;
  const ChainProblem& problem_;
  const FiberState& state_;
  Mat3 strain_rate_;
  FiberIndex fiber_;
  Vec3 centroid_;
  ParticleStress sum_;
};

void FiberSum::add_rod(RodIndex rod, const RodDrag& unit_drag) {
  const RodDrag drag = scaled(unit_drag, problem_.flow.viscosity);
  const Vec3 begin = place(first_end(rod)), axis = place(second_end(rod)) - begin;
  const double length = state_.rod_length[rod];
  const Vec3 &w = step_.velocity[first_end(rod)], &w_end = step_.velocity[second_end(rod)];
  RodMotion motion;
  motion.direction = axis.normalized();
  motion.slip = -0.5 * (w + w_end);
  motion.rate_of_strain = strain_rate_;
  const Vec3& p = motion.direction;
  const Vec3 turning = (w_end - w) / length;
  const Vec3 spin = problem_.flow.angular_velocity() - p.cross(turning + problem_.flow.gradient * p);
  motion.spin = spin - p.dot(spin) * p;

  const Vec3 force =
      drag.perpendicular * motion.slip + (drag.parallel - drag.perpendicular) * p.dot(motion.slip) * p;
  // As the solver has it: the couple as two forces at the ends, its part along the rod in the tension.
  const Vec3 end_force = -drag.rotational / length * (turning + (1 - drag.shape) * (strain_rate_ * p));
  const Mat3 own = rod_stresslet(drag, motion);
  sum_.stress += sym(begin + 0.5 * axis, force) + own;
  part(StressCause::drag) += own - sym(axis, end_force);
  part(StressCause::tension) += step_.tension[rod] * sym(axis, p);
  power(PowerSink::drag) += rod_dissipation(drag, motion);
}

/// Adds the bending moment of a hinge, half of it implicit in the velocities.
void FiberSum::add_hinge(NodeIndex hinge, const Hinge& law) {
  const double before = 1 / state_.rod_length[rod_before(hinge)];
  const double after = 1 / state_.rod_length[rod_after(hinge)];
  const auto second_difference = [&](const auto& field) -> Vec3 {
    return before * (field[hinge - 1] - field[hinge]) + after * (field[hinge + 1] - field[hinge]);
  };
  const Vec3 turn = second_difference(state_.position);
  const double mean = 2 * before * after / (before + after);
  const double stiffness =
      state_.material(fiber_).bending_stiffness() * mean * law(0.25 * turn.squaredNorm());
  const Vec3 change = second_difference(step_.velocity);
  const Vec3 moment = stiffness * (turn + problem_.step * (problem_.flow.gradient * turn + change));
  const Vec3 here = second_difference(problem_.geometry);
  part(StressCause::bending) += sym(here, moment);
  power(PowerSink::bending) += moment.dot(change + problem_.flow.gradient * here);
}

/// Adds the first moment of a force with the given arm, the part along the normal as contact.
void FiberSum::add_moment(const Mat3& couple, const Vec3& normal, const Vec3& arm, const Vec3& force) {
  const Vec3 along = normal.dot(force) * normal;
  part(StressCause::contact) -= sym(arm, along);
  part(StressCause::friction) -= sym(arm, force - along) + couple;
}

void FiberSum::add_pairs(RodIndex rod) {
  for (const PairForces::Share& share : step_.loads.pairs().of_rod(rod)) {
    const ContactSides sides(step_, rod, share);
    const RodSide& own = sides.own();
    const Vec3 arm = own.on_axis(problem_.geometry) - centroid_;
    const Vec3 mean = sides.mean_force(), gap = 0.5 * sides.gap();
    add_moment(own.couple_moment(problem_.geometry), sides.normal(), arm, own.force() - own.sign() * mean);
    add_moment(Mat3::Zero(), sides.normal(), gap, mean);
    sum_.stress += sym(arm, own.sign() * mean) - sym(gap, mean);
    const double normal_force = sides.normal().dot(mean), approach = sides.normal().dot(sides.slip());
    power(PowerSink::contact) -= 0.5 * normal_force * approach;
    power(PowerSink::friction) -= 0.5 * (mean.dot(sides.slip()) - normal_force * approach);
    sum_.antisymmetric += own.lost_torque();
    sum_.unanswered += 0.5 * (sides.own().force() + sides.other().force()).squaredNorm();
    sum_.answered += 0.5 * mean.squaredNorm();
  }
}

void FiberSum::add_wall(const WallContact& wall, const RodLoad& load) {
  const Vec3& w = step_.velocity[wall.node];
  const auto& r = load.resistance;
  Mat3 resistance;
  resistance << r[0], r[5], r[4], r[5], r[1], r[3], r[4], r[3], r[2];
  const Vec3 force = load.force - resistance * w, gap = wall.height * wall.normal;
  const Vec3 slip = w + problem_.flow.gradient * gap;
  add_moment(Mat3::Zero(), wall.normal, gap, force);
  sum_.stress += sym(place(wall.node), force) - sym(gap, force);
  const double normal_force = wall.normal.dot(force), approach = wall.normal.dot(slip);
  power(PowerSink::contact) -= normal_force * approach;
  power(PowerSink::friction) -= force.dot(slip) - normal_force * approach;
}

}  // namespace

const char* name(StressCause cause) {
  static constexpr std::array<const char*, stress_causes> names = {"drag", "tension", "bending", "contact",
                                                                   "friction"};
  return names[static_cast<std::size_t>(cause)];
}

const char* name(PowerSink sink) {
  static constexpr std::array<const char*, power_sinks> names = {"drag", "bending", "contact", "friction"};
  return names[static_cast<std::size_t>(sink)];
}

double ParticleStress::spent_power() const {
  double sum = 0;
  for (const double one : power) sum += one;
  return sum;
}

void ParticleStress::add(const ParticleStress& other, double share) {
  stress += share * other.stress;
  for (std::size_t i = 0; i < stress_causes; ++i) by_cause[i] += share * other.by_cause[i];
  for (std::size_t i = 0; i < power_sinks; ++i) power[i] += share * other.power[i];
  supplied_power += share * other.supplied_power;
  antisymmetric += share * other.antisymmetric;
  unanswered += share * other.unanswered;
  answered += share * other.answered;
}

ParticleStress particle_stress(const SolvedStep& step, const ChainLaws& laws) {
  const FiberState& state = step.problem.state;
  const auto drag = unit_drag_of_rods(state, laws.drag);
  const Hinge hinge(laws.hinge);
  IndexedVector<FiberIndex, ParticleStress> sums(state.fiber_count());
  parallel_for_weighted(state.first_node, [&](FiberIndex fiber) {
    FiberSum sum(step, fiber);
    for (const RodIndex rod : state.rods(fiber)) {
      sum.add_rod(rod, drag[rod]);
      if (step.problem.pairs != nullptr) sum.add_pairs(rod);
    }
    for (const NodeIndex node : state.hinges(fiber)) sum.add_hinge(node, hinge);
    sums[fiber] = sum.sum();
  });
  const auto& walls = step.loads.wall_contacts();
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const FiberIndex fiber = state.fiber_of(walls[w].node);
    FiberSum sum(step, fiber);
    sum.add_wall(walls[w], step.loads.load_of_wall(w));
    sums[fiber].add(sum.sum(), 1);
  }
  ParticleStress total;
  for (const ParticleStress& fiber : sums) total.add(fiber, 1 / state.cell.volume());
  total.supplied_power = total.stress.cwiseProduct(step.problem.flow.rate_of_strain()).sum();
  return total;
}

}  // namespace fiberfate
