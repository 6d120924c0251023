// Steps packed chains by FIRE with neighbour lists, gathered loads and exact rod lengths.
#include "packing/minimiser.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/matrix_product.hpp"
#include "base/threads.hpp"

namespace fiberfate {
namespace {

// FIRE as published, but with a longer memory of the direction.
constexpr double initial_step = 0.05;
constexpr double growth = 1.1;
constexpr double shrink = 0.5;
constexpr double initial_mixing = 0.1;
constexpr double mixing_decay = 0.99;
constexpr int patience = 5;
// Farthest that a node moves in a step, in diameters: keeps the length corrections convergent.
constexpr double farthest_move = 0.1;
// Rods a load is computed for at a time by one thread.
constexpr Index chunk_size = 128;
// Lists are kept for between these numbers of steps by changing the skin between these widths.
constexpr int shortest_life = 8;
constexpr int longest_life = 40;
constexpr double narrowest_skin = 0.3;
constexpr double widest_skin = 3;

}  // namespace

void Minimiser::start() {
  const std::size_t nodes = chains_.position.size();
  chains_.velocity.assign(nodes, Vec3::Zero());
  chains_.force.assign(nodes, Vec3::Zero());
  sums_.resize(chains_.rod_length.size());
  constraints_.resize(chains_.rod_length.size());
  for (const FiberIndex fiber : chains_.fibers()) total_length_ += chains_.length(fiber);
  step_size_ = initial_step;
  mixing_ = initial_mixing;
}

void Minimiser::use(const PackingEnergy& energy) {
  const bool nearer = energy.repulsion.swelling <= range_.swelling &&
                      energy.repulsion.reach <= range_.reach &&
                      energy.repulsion.swelling > 0.8 * range_.swelling;
  energy_ = energy;
  if (!nearer) {
    range_ = {energy.repulsion.swelling, energy.repulsion.reach, range_.skin};
    lists_valid_ = false;
  }
  double stiffest = 0;
  for (const double stiffness : chains_.bending_stiffness) stiffest = std::max(stiffest, stiffness);
  // Largest eigenvalues: of the bending of a chain 16 per unit of stiffness, of contacts about 20 (ten a
  // node).
  const double hardest = 16 * (stiffest * energy.bending + (energy.barrier_radius > 0 ? energy.barrier : 0)) +
                         20 * energy.repulsion.stiffness + 10 * energy.repulsion.hardness;
  largest_step_size_ = 1.5 / std::sqrt(hardest);
  step_size_ = std::min(step_size_, largest_step_size_);
}

void Minimiser::renew_neighbours() {
  if (lists_valid_) {
    double farthest = 0;
    for (const FiberSums& sums : sums_) farthest = std::max(farthest, sums.farthest);
    ++list_age_;
    if (farthest < 0.25 * range_.skin * range_.skin) return;
    if (list_age_ < shortest_life) range_.skin = std::min(widest_skin, 1.3 * range_.skin);
    if (list_age_ > longest_life) range_.skin = std::max(narrowest_skin, 0.8 * range_.skin);
  }
  list_age_ = 0;
  neighbours_.build(chains_, range_);
  loads_.resize(neighbours_.rod_count());
  listed_position_ = chains_.position;
  lists_valid_ = true;
}

void Minimiser::add_bending(FiberIndex fiber, FiberSums& sums) {
  const double squared_length = chains_.rod_length[fiber] * chains_.rod_length[fiber];
  const double stiffness = energy_.bending * chains_.bending_stiffness[fiber];
  const double allowed = energy_.barrier_radius > 0 ? squared_length / energy_.barrier_radius : 1e300;
  for (const NodeIndex k : chains_.hinges(fiber)) {
    const Vec3 second = chains_.position[k + 1] - 2 * chains_.position[k] + chains_.position[k - 1];
    const double size = second.norm();
    sums.bend = std::max(sums.bend, size / squared_length);
    const double excess = std::max(0.0, size - allowed);
    const Vec3 pull = (stiffness + (excess > 0 ? energy_.barrier * excess / size : 0)) * second;
    chains_.force[k - 1] -= pull;
    chains_.force[k] += 2 * pull;
    chains_.force[k + 1] -= pull;
  }
}

void Minimiser::add_walls(FiberIndex fiber, FiberSums& sums) {
  for (int i = 0; i < 3; ++i) {
    if (chains_.cell.boundary[i] == Boundary::periodic) continue;
    const double height = chains_.cell.height(i);
    const Vec3 normal = chains_.cell.lattice.inverse().row(i).transpose() * height;
    for (const NodeIndex k : chains_.nodes(fiber)) {
      const double place = normal.dot(chains_.position[k]);
      const double below = std::max(0.0, chains_.radius[fiber] - place);
      const double above = std::max(0.0, place - (height - chains_.radius[fiber]));
      chains_.force[k] += energy_.repulsion.stiffness * (below - above) * normal;
      sums.overlap = std::max(sums.overlap, 0.5 * std::max(below, above) / chains_.radius[fiber]);
    }
  }
}

void Minimiser::add_moment(FiberIndex fiber, FiberSums& sums) const {
  for (const RodIndex rod : chains_.rods(fiber)) {
    const Vec3 axis = chains_.axis(rod);
    sums.moment += axis * axis.transpose();
  }
  sums.moment /= chains_.rod_length[fiber];
}

void Minimiser::load(FiberIndex fiber, FiberSums& sums) {
  const Mat3 couple = (energy_.orientation / chains_.rod_length[fiber]) * orientation_error_;
  for (const NodeIndex k : chains_.nodes(fiber)) chains_.force[k].setZero();
  for (const RodIndex rod : chains_.rods(fiber)) {
    const RepulsionLoad& load = loads_[neighbours_.slot(rod)];
    const Vec3 turn = product(couple, chains_.axis(rod));
    chains_.force[first_end(rod)] += Vec3(load.on_begin) + turn;
    chains_.force[second_end(rod)] += Vec3(load.on_end) - turn;
    sums.overlap = std::max(sums.overlap, load.largest_overlap);
    sums.energy += load.energy;
  }
  add_bending(fiber, sums);
  add_walls(fiber, sums);
  ChainConstraints& constraints = constraints_[fiber];
  constraints.factorise(chains_.positions(fiber), chains_.rod_length[fiber]);
  constraints.project(&chains_.force[chains_.begin_node(fiber)]);
  for (const NodeIndex k : chains_.nodes(fiber)) {
    sums.power += chains_.force[k].dot(chains_.velocity[k]);
    sums.force += chains_.force[k].squaredNorm();
    sums.speed += chains_.velocity[k].squaredNorm();
  }
}

void Minimiser::load_fibers() {
  const RepulsionKernel repel = repulsion_kernel();
  const RepulsionInput input = neighbours_.input();
  const Index rods = neighbours_.rod_count();
  parallel_for((rods + chunk_size - 1) / chunk_size, [&](Index chunk) {
    const Index last = std::min(rods, (chunk + 1) * chunk_size);
    repel(input, energy_.repulsion, chunk * chunk_size, last, loads_.data());
  });
  parallel_for(chains_.fibers(), [&](FiberIndex fiber) {
    const double farthest = sums_[fiber].farthest;
    sums_[fiber] = FiberSums{};
    sums_[fiber].farthest = farthest;
    add_moment(fiber, sums_[fiber]);
  });
  Mat3 moment = Mat3::Zero();
  for (const FiberSums& sums : sums_) moment += sums.moment;
  orientation_error_ = moment / total_length_ - target_;
  parallel_for(chains_.fibers(), [&](FiberIndex fiber) { load(fiber, sums_[fiber]); });
}

PackingMeasure Minimiser::summarise() const {
  PackingMeasure total;
  total.largest_overlap = -1;
  for (const FiberSums& sums : sums_) {
    total.largest_overlap = std::max(total.largest_overlap, sums.overlap);
    total.largest_bend = std::max(total.largest_bend, sums.bend);
    total.mean_square_force += sums.force;
    total.kinetic += sums.speed;
    total.energy += sums.energy;
  }
  const auto nodes = static_cast<double>(chains_.position.size());
  total.mean_square_force /= nodes;
  total.kinetic /= nodes;
  total.energy /= nodes;
  total.orientation_error = orientation_error_.cwiseAbs().maxCoeff();
  return total;
}

void Minimiser::steer(double power) {
  if (power > 0) {
    if (++downhill_ > patience) {
      step_size_ = std::min(step_size_ * growth, largest_step_size_);
      mixing_ *= mixing_decay;
    }
    return;
  }
  downhill_ = 0;
  step_size_ *= shrink;
  mixing_ = initial_mixing;
}

void Minimiser::move(FiberIndex fiber, double keep, double follow) {
  for (const NodeIndex k : chains_.nodes(fiber)) {
    Vec3& v = chains_.velocity[k];
    v = keep * v + follow * chains_.force[k];
    const double path = v.norm() * step_size_;
    if (path > farthest_move) v *= farthest_move / path;
    chains_.force[k] = chains_.position[k];
    chains_.position[k] += step_size_ * v;
  }
  constraints_[fiber].restore_lengths(&chains_.position[chains_.begin_node(fiber)]);
  double farthest = 0;
  for (const NodeIndex k : chains_.nodes(fiber)) {
    chains_.velocity[k] = (chains_.position[k] - chains_.force[k]) / step_size_;
    farthest = std::max(farthest, (chains_.position[k] - listed_position_[k]).squaredNorm());
  }
  sums_[fiber].farthest = farthest;
  neighbours_.refresh(chains_, fiber);
}

void Minimiser::move_fibers(double force, double speed) {
  const bool rising = downhill_ == 0;
  const double mix = force > 0 && !rising ? mixing_ * std::sqrt(speed / force) : 0;
  // v ← (1 − α)(v + F dt) + α |v| F / |F|, and from rest after going uphill.
  const double keep = rising ? 0 : 1 - mixing_;
  const double follow = step_size_ * (rising ? 1 : 1 - mixing_) + mix;
  parallel_for(chains_.fibers(), [&](FiberIndex fiber) { move(fiber, keep, follow); });
}

PackingMeasure Minimiser::step() {
  renew_neighbours();
  load_fibers();
  double power = 0, force = 0, speed = 0;
  for (const FiberSums& sums : sums_) {
    power += sums.power;
    force += sums.force;
    speed += sums.speed;
  }
  const PackingMeasure measure = summarise();
  steer(power);
  move_fibers(force, speed);
  return measure;
}

PackingMeasure Minimiser::measure() {
  renew_neighbours();
  load_fibers();
  return summarise();
}

void Minimiser::finish() {
  ChainConstraints constraints;
  for (const FiberIndex fiber : chains_.fibers()) {
    for (int pass = 0; pass < 2; ++pass) {
      constraints.factorise(chains_.positions(fiber), chains_.rod_length[fiber]);
      constraints.restore_lengths(&chains_.position[chains_.begin_node(fiber)], 3);
    }
  }
}

}  // namespace fiberfate
