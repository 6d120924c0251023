// Compares the solver in node velocities and tensions with the dense system of nine unknowns a rod.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dynamics/chain_solver.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"
#include "reference/dense_fiber.hpp"

namespace fiberfate {
namespace {

using reference::DenseFiber;
using reference::DenseLoads;

// Both solutions lose digits to the condition of the system, at most about 1e5 for the stiffest of 60 rods.
constexpr double tolerance = 1e-10;

class RandomSource {
 public:
  explicit RandomSource(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<>(low, high)(engine_); }
  Vec3 vector(double size) { return size * Vec3(between(-1, 1), between(-1, 1), between(-1, 1)); }

 private:
  std::mt19937_64 engine_;
};

/// A chain whose rods differ in length by up to a factor three and turn by up to 45 degrees from one to the
/// next.
std::vector<Vec3> bent_chain(RandomSource& random, int rods) {
  std::vector<Vec3> nodes = {random.vector(1e-3)};
  Vec3 direction = random.vector(1).normalized();
  for (int i = 0; i < rods; ++i) {
    const Vec3 sideways = random.vector(1).cross(direction).normalized();
    const double angle = random.between(0, pi / 4);
    direction = (std::cos(angle) * direction + std::sin(angle) * sideways).normalized();
    nodes.emplace_back(nodes.back() + random.between(0.5e-4, 1.5e-4) * direction);
  }
  return nodes;
}

Flow random_flow(RandomSource& random) {
  Flow flow;
  flow.gradient = Mat3::NullaryExpr([&]() { return random.between(-30, 30); });
  flow.gradient -= flow.gradient.trace() / 3 * Mat3::Identity();
  flow.viscosity = random.between(20, 500);
  return flow;
}

/// One fiber, its loads and its step, as both solvers take them.
struct Problem {
  FiberState state;
  Flow flow;
  double step = 0;
  std::vector<std::pair<int, RodLoad>> loads;
};

Problem random_problem(RandomSource& random, int rods) {
  Problem problem;
  problem.flow = random_flow(random);
  problem.step = random.integer(0, 1) == 0 ? 0.0 : random.between(1e-6, 1e-3);
  problem.state.materials = {{.radius = 9.5e-6, .youngs_modulus = 73e9, .density = 2550}};
  const auto nodes = bent_chain(random, rods);
  append_fiber(problem.state, {.nodes = nodes, .material_id = 0});
  for (int i = random.integer(0, 2 * rods); i > 0; --i) {
    RodLoad load;
    load.lever = random.between(0, 1);
    load.force = random.vector(1e-2);
    const Vec3 n = random.vector(1).normalized();
    const double resistance = random.between(0, 1);
    const Mat3 block = resistance * n * n.transpose();
    load.resistance = {block(0, 0), block(1, 1), block(2, 2), block(1, 2), block(2, 0), block(0, 1)};
    problem.loads.emplace_back(random.integer(0, rods - 1), load);
  }
  return problem;
}

RodLoads loads_of(const Problem& problem) {
  RodLoads loads;
  std::vector<RodLoads::Claim> claims;
  std::vector<RodLoads::Slot> slots;
  for (const auto& [rod, load] : problem.loads) claims.push_back({RodIndex(rod), claims.size()});
  loads.arrange(problem.state.node_count(), claims, slots);
  for (std::size_t i = 0; i < slots.size(); ++i) loads.slot(slots[i]) = problem.loads[i].second;
  return loads;
}

Mat3 full(const std::array<double, 6>& s) {
  Mat3 matrix;
  matrix << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
  return matrix;
}

/// Forces −(E I/l̄)(theta/sin theta) gamma_j (b + step db/dt) of bending over a step: what goes beyond the
/// moment is a damping of the nodes.
void add_implicit_bending(const Problem& problem, const DenseFiber& fiber, Eigen::MatrixXd& damping) {
  for (int k = 1; k < fiber.rods(); ++k) {
    const double before = fiber.axis(k - 1).norm();
    const double after = fiber.axis(k).norm();
    const double angle = std::acos(fiber.axis(k - 1).dot(fiber.axis(k)) / (before * after));
    const double stiffness = fiber.bending_stiffness / ((before + after) / 2) * angle / std::sin(angle);
    const Vec3 gamma(1 / before, -1 / before - 1 / after, 1 / after);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        damping.block<3, 3>(3 * (k - 1 + i), 3 * (k - 1 + j)) +=
            problem.step * stiffness * gamma[i] * gamma[j] * Mat3::Identity();
      }
    }
  }
}

/// The loads as the dense system takes them: force − resistance · (v − kappa·x) at a point.
DenseLoads dense_loads(const Problem& problem, const DenseFiber& fiber) {
  DenseLoads loads;
  const int unknowns = 3 * (fiber.rods() + 1);
  loads.node_damping.setZero(unknowns, unknowns);
  for (const auto& [rod, load] : problem.loads) {
    const Mat3 resistance = full(load.resistance);
    const Vec3 point = fiber.nodes[std::size_t(rod)] + load.lever * fiber.axis(rod);
    loads.points.push_back({rod, load.lever, load.force + resistance * problem.flow.gradient * point});
    const std::array<double, 2> weight = {1 - load.lever, load.lever};
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j)
        loads.node_damping.block<3, 3>(3 * (rod + i), 3 * (rod + j)) +=
            weight[std::size_t(i)] * weight[std::size_t(j)] * resistance;
    }
  }
  add_implicit_bending(problem, fiber, loads.node_damping);
  return loads;
}

DenseFiber dense_fiber(const Problem& problem, const std::string& law) {
  const FiberMaterial& material = problem.state.materials[0];
  DenseFiber fiber{problem.state.position, material.radius, material.bending_stiffness()};
  if (law == "beads") return fiber;  // the sums over the beads themselves
  const double whole = fiber_length(problem.state, FiberIndex(0));
  for (int i = 0; i < fiber.rods(); ++i) {
    const RodDrag drag =
        drag_law_named(law).drag(problem.flow.viscosity, {fiber.axis(i).norm(), fiber.radius, whole});
    fiber.resistance.push_back({drag.parallel, drag.perpendicular, drag.rotational, drag.shape});
  }
  return fiber;
}

IndexedVector<NodeIndex, Vec3> reduced_velocities(const Problem& problem, const std::string& law) {
  IndexedVector<NodeIndex, Vec3> relative(problem.state.position.size());
  IndexedVector<RodIndex, double> tension(problem.state.position.size());
  const RodLoads loads = loads_of(problem);
  ChainSolver solver;
  solver.arrange(problem.state, {.drag = law});
  solver.solve({problem.state, problem.state.position, loads, problem.flow, problem.step},
               {relative, tension});
  return relative;
}

/// Largest difference of node velocities over the largest velocity relative to the fluid.
double relative_difference(const Problem& problem, const std::string& law) {
  const DenseFiber fiber = dense_fiber(problem, law);
  const auto dense = reference::solve_dense(fiber, problem.flow, dense_loads(problem, fiber));
  const auto reduced = reduced_velocities(problem, law);
  double difference = 0;
  double size = 0;
  for (const NodeIndex k : problem.state.nodes()) {
    const Vec3 relative = dense.node_velocity[k.value()] - problem.flow.gradient * problem.state.position[k];
    difference = std::max(difference, (relative - reduced[k]).norm());
    size = std::max(size, relative.norm());
  }
  return difference / size;
}

// The reduced system (3 velocities a node, 1 tension a rod) is the dense one with the joint forces
// eliminated.
TEST(ReducedEqualsDense, OnRandomBentFibersOfBeads) {
  RandomSource random(20231);
  double worst = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int rods = trial < 60 ? trial + 1 : random.integer(1, 60);
    const Problem problem = random_problem(random, rods);
    const double difference = relative_difference(problem, "beads");
    EXPECT_LT(difference, tolerance) << rods << " rods, step " << problem.step;
    worst = std::max(worst, difference);
  }
  RecordProperty("worst_relative_difference", fmt::format("{:.1e}", worst));
}

TEST(ReducedEqualsDense, OnRandomBentFibersOfEveryLawOfDrag) {
  for (const DragRow& row : drag_laws()) {
    RandomSource random(20232);
    for (int trial = 0; trial < 20; ++trial) {
      const Problem problem = random_problem(random, random.integer(1, 30));
      EXPECT_LT(relative_difference(problem, row.text.name), tolerance) << row.text.name;
    }
  }
}

// Many fibers of different rod counts share vector lanes: each must come out as if it were alone.
TEST(ReducedEqualsDense, WhenFibersShareLanes) {
  RandomSource random(20233);
  Problem all = random_problem(random, 1);
  all.loads.clear();
  for (int i = 0; i < 20; ++i)
    append_fiber(all.state, {.nodes = bent_chain(random, random.integer(1, 12)), .material_id = 0});
  const auto together = reduced_velocities(all, "beads");
  for (const FiberIndex f : all.state.fibers()) {
    const auto nodes = all.state.positions(f);
    const DenseFiber fiber{{nodes.begin(), nodes.end()},
                           all.state.materials[0].radius,
                           all.state.materials[0].bending_stiffness()};
    DenseLoads loads;
    loads.node_damping.setZero(3 * (fiber.rods() + 1), 3 * (fiber.rods() + 1));
    add_implicit_bending(all, fiber, loads.node_damping);
    const auto dense = reference::solve_dense(fiber, all.flow, loads);
    double size = 0;
    for (const Vec3& v : dense.node_velocity) size = std::max(size, v.norm());
    for (const NodeIndex n : all.state.nodes(f)) {
      const Vec3 relative =
          dense.node_velocity[n - all.state.begin_node(f)] - all.flow.gradient * all.state.position[n];
      EXPECT_LT((relative - together[n]).norm(), tolerance * size);
    }
  }
}

// The bead formula for real m must be the sum over the beads themselves where m is an integer.
TEST(RealValuedBeads, EqualTheSumOverIntegerBeads) {
  const double radius = 9.5e-6;
  for (const int m : {1, 2, 5, 131}) {
    const double length = 2 * radius * m;
    const auto sum = reference::discrete_beads(m, length, radius);
    const auto formula = reference::real_valued_beads(length, radius);
    EXPECT_NEAR(formula.count, sum.count, 1e-12 * sum.count);
    EXPECT_NEAR(formula.first, sum.first, 1e-12 * sum.first);
    EXPECT_NEAR(formula.second, sum.second, 1e-12 * sum.second);
  }
}

// Real-valued sums telescope: the rods of a straight fiber, cut anywhere, add up to the sums of the whole
// fiber.
TEST(RealValuedBeads, AddUpOverTheRodsOfAStraightFiber) {
  const double radius = 9.5e-6;
  const std::vector<double> cuts = {0, 0.7e-4, 1.1e-4, 4.2e-4, 1e-3};
  double count = 0;
  double first = 0;
  double second = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const auto rod = reference::real_valued_beads(cuts[i + 1] - cuts[i], radius);
    count += rod.count;
    first += rod.first + rod.count * cuts[i];
    second += rod.second + 2 * rod.first * cuts[i] + rod.count * cuts[i] * cuts[i];
  }
  const auto whole = reference::real_valued_beads(cuts.back(), radius);
  EXPECT_NEAR(count, whole.count, 1e-12 * whole.count);
  EXPECT_NEAR(first, whole.first, 1e-12 * whole.first);
  // The −1 of m (m² − 1) a²/3 counts the beads' own extent: it is the same sum of m.
  EXPECT_NEAR(second, whole.second, 1e-12 * whole.second);
}

}  // namespace
}  // namespace fiberfate
