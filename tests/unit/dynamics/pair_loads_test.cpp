// Tests the kernels that add pair forces to the systems of fibers against the definition by matrices.
#include "dynamics/pair_loads.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "../fibers/sample_fibers.hpp"
#include "base/aligned_array.hpp"
#include "base/kernels.hpp"
#include "dynamics/chain_assembly.hpp"
#include "dynamics/chain_system.hpp"
#include "fibers/rod_pairs.hpp"
#include "reference/append_contact.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group))

using Kernel = decltype(&baseline::add_pair_loads);

namespace {

using System = ChainSystem;

/// Tells the kernels that this processor can run.
std::vector<Kernel> kernels() {
  std::vector<Kernel> list = {baseline::add_pair_loads};
  if (instruction_set() != InstructionSet::baseline) list.push_back(avx2::add_pair_loads);
  if (instruction_set() == InstructionSet::avx512) list.push_back(avx512::add_pair_loads);
  return list;
}

double wave(int i) {
  return std::sin(1.7 * i + 0.3);
}
Vec3 waves(int i) {
  return {wave(3 * i), wave(3 * i + 1), wave(3 * i + 2)};
}

/// Three fibers of three, two and one rods whose lengths are near 1, and forces between their rods.
struct Scene {
  FiberState state = empty_state();
  IndexedVector<NodeIndex, Vec3> velocity;
  PairForces pairs;
  std::vector<std::array<RodIndex, 2>> rods_of_force;  // first and second
  ChainGroup group;
  AlignedArray rods;

  Scene() {
    for (const int count : {3, 2, 1}) append_straight(state, Vec3::Zero(), Vec3::UnitX(), count);
    for (const NodeIndex n : state.nodes()) {
      state.position[n] += 0.1 * waves(n.value());
      velocity.push_back(waves(n.value() + 20));
    }
    for (const FiberIndex f : state.fibers()) {
      for (const RodIndex rod : state.rods(f)) state.rod_length[rod] = state.axis(rod).norm();
    }
    add_forces();
    make_group();
  }

  void add_forces() {
    // Rod 1 of the first fiber has five shares, two of them of a pair with its own image; rod 2 has none.
    const std::array<Index, 2> between[] = {{1, 4}, {0, 7}, {7, 1}, {5, 1}, {1, 1}, {4, 7}};
    ContactSet contacts(2);
    for (int i = 0; i < 6; ++i) {
      ContactChunk& chunk = contacts[std::size_t(i % 2)];
      Contact contact;
      contact.first = RodIndex(between[i][0]);
      contact.second = RodIndex(between[i][1]);
      contact.image = i == 4 ? pack_image({1, 0, 0}) : 0;
      reference::append_contact(chunk, contact);
    }
    pairs.deal(contacts, state.node_count());
    int number = 0;
    for (std::size_t c = 0; c < 2; ++c) {
      for (int i = 0; i < contacts[c].count; ++i, ++number) {
        PairForce& to = pairs.forces()[std::size_t(number)];
        rods_of_force.push_back({contacts[c].first[std::size_t(i)], contacts[c].second[std::size_t(i)]});
        const Vec3 force = waves(number + 40);
        const Vec3 normal = waves(number + 60).normalized();
        std::copy_n(force.data(), 3, to.force);
        std::copy_n(normal.data(), 3, to.normal);
        to.s = std::abs(wave(number));
        to.t = std::abs(wave(number + 9));
        to.distance = 0.1 + 0.01 * number;
        to.along = 2 + wave(number + 30);
        to.across = 0.5 + 0.3 * wave(number + 31);
      }
    }
  }

  void make_group() {
    group.nodes = 4;
    rods.reserve(std::size_t{4} * RodNumber::rod_numbers * System::lanes);
    for (int lane = 0; lane < System::lanes; ++lane) {
      const FiberIndex fiber(lane < 3 ? lane : 0);
      group.fiber[lane] = lane < 3 ? fiber.value() : -1;
      group.first[lane] = state.begin_node(fiber).value();
      group.rods[lane] = state.rod_count(fiber);
      group.used[lane] = lane < 3 ? group.rods[lane] : 0;
      for (int k = 0; k < group.nodes; ++k) {
        const RodIndex rod(group.first[lane] + std::min(k, group.rods[lane] - 1));
        rods.data()[offset_of(RodNumber::length, k) + lane] = state.rod_length[rod];
      }
    }
  }

  /// Runs a kernel on empty records.
  void run(Kernel kernel, System& system) const {
    system.reserve(group.nodes);
    std::fill_n(system.record(0), group.nodes * System::size * System::lanes, 0.0);
    PairSlots slots;
    slots.collect(pairs, group);
    kernel({system.record(0), state.position.front().data(), velocity.front().data(), rods.data(),
            pairs.forces().data(), slots.numbers(), slots.ends(), slots.rod_count()},
           group);
  }
};

/// The system of one fiber as matrices: (sum of Jᵀ R J) w = sum of Jᵀ (F + R J w_old) with v = J w the
/// velocity of the skin.
struct Definition {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd load;
};

/// Adds the share that the first (side 0) or the second rod (side 1) has of a force.
void add_share(const Scene& scene, std::size_t number, std::size_t side, RodIndex begin, Definition& sum) {
  const PairForce& force = scene.pairs.forces()[number];
  const RodIndex rod = scene.rods_of_force[number][side];
  const double place = side == 0 ? force.s : force.t;
  const double sign = side == 0 ? 1 : -1;
  const double length = scene.state.rod_length[rod];
  const Vec3 p = scene.state.axis(rod) / length;
  const Vec3 n(force.normal[0], force.normal[1], force.normal[2]);
  const Mat3 turn = sign * force.distance / (2 * length) * (p * n.transpose() - n.dot(p) * Mat3::Identity());
  Eigen::Matrix<double, 3, 6> skin;
  skin << (1 - place) * Mat3::Identity() - turn, place * Mat3::Identity() + turn;
  const Mat3 resistance =
      force.along * n * n.transpose() + force.across * (Mat3::Identity() - n * n.transpose());
  Eigen::Matrix<double, 6, 1> old;
  old << scene.velocity[first_end(rod)], scene.velocity[second_end(rod)];
  const Vec3 at_rest = sign * Vec3(force.force[0], force.force[1], force.force[2]) + resistance * skin * old;
  const auto at = 3 * (rod - begin);
  sum.matrix.block<6, 6>(at, at) += skin.transpose() * resistance * skin;
  sum.load.segment<6>(at) += skin.transpose() * at_rest;
}

Definition definition(const Scene& scene, FiberIndex fiber) {
  const auto size = 3 * (scene.state.rod_count(fiber) + 1);
  Definition sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  const RodIndex begin = scene.state.rods(fiber).front(), end = begin + scene.state.rod_count(fiber);
  for (std::size_t number = 0; number < scene.rods_of_force.size(); ++number) {
    for (const std::size_t side : {0, 1}) {
      const RodIndex rod = scene.rods_of_force[number][side];
      if (rod >= begin && rod < end) add_share(scene, number, side, begin, sum);
    }
  }
  return sum;
}

/// Reads a lane of the records back as matrices.
Definition in_lane(System& system, int lane, int nodes) {
  Definition read{Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes), Eigen::VectorXd::Zero(3 * nodes)};
  for (int k = 0; k < nodes; ++k) {
    const auto at = [&](int component) { return system.at(k, component, lane); };
    Mat3 block;
    block << at(0), at(5), at(4), at(5), at(1), at(3), at(4), at(3), at(2);
    read.matrix.block<3, 3>(3 * k, 3 * k) = block;
    for (int c = 0; c < 3; ++c) read.load[3 * k + c] = at(System::load + c);
    if (k + 1 == nodes) continue;
    for (int c = 0; c < 9; ++c) block.data()[c] = at(System::coupling + c);
    read.matrix.block<3, 3>(3 * k, 3 * k + 3) = block;
    read.matrix.block<3, 3>(3 * k + 3, 3 * k) = block.transpose();
  }
  return read;
}

TEST(PairLoads, AreTheirDefinitionOnEveryInstructionSet) {
  const Scene scene;
  for (const Kernel kernel : kernels()) {
    System system;
    scene.run(kernel, system);
    for (const FiberIndex fiber : scene.state.fibers()) {
      const int lane = fiber.value();
      const Definition expected = definition(scene, fiber);
      const Definition found = in_lane(system, lane, scene.state.rod_count(fiber) + 1);
      EXPECT_GT(expected.matrix.norm(), 1) << lane;
      EXPECT_LT((found.matrix - expected.matrix).norm(), 1e-14 * expected.matrix.norm()) << lane;
      EXPECT_LT((found.load - expected.load).norm(), 1e-14 * expected.load.norm()) << lane;
    }
    EXPECT_EQ(in_lane(system, 3, 4).matrix.norm(), 0) << "an unused lane got something";
  }
}

TEST(PairForces, DealEveryRodItsSharesOrderedByWhoExertsThem) {
  const Scene scene;
  std::size_t shares = 0;
  for (const RodIndex rod : scene.state.rod_length.indices()) {
    std::int64_t before = -1;
    for (const PairForces::Share& share : scene.pairs.of_rod(rod)) {
      EXPECT_EQ(scene.rods_of_force[std::size_t(share.number / 2)][std::size_t(share.number % 2)], rod);
      EXPECT_LE(before, share.key);
      before = share.key;
      ++shares;
    }
  }
  EXPECT_EQ(shares, 2 * scene.pairs.forces().size());
  EXPECT_EQ(scene.pairs.of_rod(RodIndex(1)).size(), 5u);
}

}  // namespace
}  // namespace fiberfate
