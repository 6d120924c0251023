// Makes the list of neighbours and keeps account of how long it remains valid.
#include "fibers/neighbour_list.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "fibers/pair_collector.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate {
namespace {

// Bins a chunk: small enough to balance threads, large enough to amortise their start.
constexpr Index chunk_size = 64;
// Bins of the grid are this share of the farthest midpoints: smaller ones hold fewer rods in vain, but make
// more runs.
constexpr double bin_share = 0.5;
// Rounding of coordinates in single precision, relative to the largest one.
constexpr double single_rounding = 4e-7;

// Travels in single precision are rounded up: relative, and for the sum of many steps by a length far below
// any that matters.
float round_up(double length) {
  return static_cast<float>(length * (1 + 1e-6) + 1e-14);
}

}  // namespace

double NeighbourList::name_fibers(const FiberState& state) {
  fiber_of_.resize(state.rod_length.size());
  part_.assign(fiber_of_.size(), 0);
  double longest = 0;
  for (const FiberIndex fiber : state.fibers()) {
    for (const RodIndex rod : state.rods(fiber)) {
      fiber_of_[rod] = fiber;
      longest = std::max(longest, state.rod_length[rod]);
    }
    part_[rod_after(state.begin_node(fiber))] |= first_of_fiber;
    part_[rod_before(state.last_node(fiber))] |= last_of_fiber;
  }
  return longest;
}

void NeighbourList::build(const FiberState& state, double range,
                          const IndexedVector<RodIndex, double>& margin) {
  margin_ = margin;
  travel_.assign(margin_.size(), 0.0F);
  origin_ = state.position;
  deformation_.setIdentity();
  strain_ = 0;
  range_ = range;
  farthest_ = range_ + 2 * *std::max_element(margin_.begin(), margin_.end());

  const double longest = name_fibers(state);
  const double widest = (longest + farthest_) * (1 + 1e-5);
  grid_.fill(state, bin_share * widest, margin_);
  // Of coordinates, and of places along nearly parallel rods.
  rounding_ = single_rounding * (state.cell.lattice.cwiseAbs().rowwise().sum().maxCoeff() + widest +
                                 longest * longest / range_);
  const Index bins = grid_.bin_count();
  const Index chunks = (bins + chunk_size - 1) / chunk_size;
  const auto begin_of = [&](Index chunk) { return RodGrid::Bin(std::min(chunk * chunk_size, bins)); };
  chunks_.resize(chunks);
  rods_before_.clear();
  for (Index c = 0; c <= chunks; ++c) rods_before_.push_back(grid_.first_entry(begin_of(c)).value());
  candidates_.fit();
  parallel_for_weighted(rods_before_, [&](Index c) {
    PairCollector(state, *this, widest, candidates_.mine()).run({begin_of(c), begin_of(c + 1)}, chunks_[c]);
  });
  pairs_before_.assign(1, 0);
  for (const RodPairs& chunk : chunks_) pairs_before_.push_back(pairs_before_.back() + chunk.size());
}

void NeighbourList::carry(const Flow& flow, double step, IndexedSpan<RodIndex, const double> travelled) {
  const double share = strain_share(flow, step);
  parallel_for(travel_.indices(), [&](RodIndex rod) {
    travel_[rod] = (travel_[rod] + round_up(travelled[rod] + share)) * (1 + 2e-7F);
  });
  Cell fluid;
  fluid.lattice = deformation_;
  deform(fluid, flow.gradient, step);
  deformation_ = fluid.lattice;
  strain_ += principal_rate(flow) * step;
}

bool NeighbourList::look_ahead(const FiberState& state, const Flow& flow, double step) {
  const std::size_t nodes = state.position.size();
  ahead_.resize(nodes);
  reach_.resize(nodes);
  has_left_.assign(state.fiber_count(), 0);
  const bool is_listed = travel_.size() == nodes;
  if (!is_listed) travel_.assign(nodes, 0.0F);
  const Outlook outlook = {step, strain_share(flow, step),
                           is_listed ? std::exp(-strain_ - principal_rate(flow) * step) : 0.0};
  margin_.resize(nodes, 0.0);
  origin_.resize(nodes, Vec3::Zero());
  parallel_for_weighted(state.first_node, [&](FiberIndex fiber) {
    if (!look_ahead(state, fiber, outlook)) has_left_[fiber] = 1;
  });
  return std::find(has_left_.begin(), has_left_.end(), 1) == has_left_.end();
}

bool NeighbourList::look_ahead(const FiberState& state, FiberIndex fiber, const Outlook& outlook) {
  bool covers = true;
  double moved_before = 0;
  double speed_before = 0;
  for (const NodeIndex node : state.nodes(fiber)) {
    const double moved = (state.position[node] - deformation_ * origin_[node]).squaredNorm();
    const double speed = state.relative_velocity[node].norm();
    if (node > state.begin_node(fiber)) {
      const RodIndex rod = rod_before(node);
      const double ahead = outlook.step * std::max(speed, speed_before);
      const double allowed = 0.5 * (outlook.shrunk * (range_ + 2 * margin_[rod]) - range_) - ahead;
      covers = covers && allowed > 0 && std::max(moved, moved_before) <= allowed * allowed;
      ahead_[rod] = round_up(ahead + outlook.strain_share);
      reach_[rod] = (travel_[rod] + ahead_[rod]) * (1 + 2e-7F);
    }
    moved_before = moved;
    speed_before = speed;
  }
  return covers;
}

double NeighbourList::strain_share(const Flow& flow, double step) const {
  return 0.5 * std::expm1(principal_rate(flow) * step) * farthest_;
}

}  // namespace fiberfate
