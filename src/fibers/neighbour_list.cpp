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
  fiber_of_.resize(static_cast<std::size_t>(state.node_count()));
  part_.assign(fiber_of_.size(), 0);
  double longest = 0;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k) {
      fiber_of_[static_cast<std::size_t>(k)] = fiber;
      longest = std::max(longest, state.rod_length[static_cast<std::size_t>(k)]);
    }
    part_[static_cast<std::size_t>(state.begin_node(fiber))] |= first_of_fiber;
    part_[static_cast<std::size_t>(state.end_node(fiber)) - 2] |= last_of_fiber;
  }
  return longest;
}

void NeighbourList::build(const FiberState& state, double range, const std::vector<double>& margin) {
  margin_.assign(margin.begin(), margin.end());
  travel_.assign(margin_.size(), 0.0F);
  origin_.assign(state.position.begin(), state.position.end());
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
  chunks_.resize(static_cast<std::size_t>((bins + chunk_size - 1) / chunk_size));
  rods_before_.resize(chunks_.size() + 1);
  for (std::size_t c = 0; c < rods_before_.size(); ++c)
    rods_before_[c] = grid_.first_entry(std::min(static_cast<Index>(c) * chunk_size, bins));
  candidates_.fit();
  parallel_for_weighted(rods_before_, [&](std::ptrdiff_t c) {
    const Index begin = static_cast<Index>(c) * chunk_size;
    PairCollector(state, *this, widest, candidates_.mine())
        .run(begin, std::min(begin + chunk_size, bins), chunks_[static_cast<std::size_t>(c)]);
  });
  pairs_before_.assign(1, 0);
  for (const RodPairs& chunk : chunks_) pairs_before_.push_back(pairs_before_.back() + chunk.size());
}

void NeighbourList::carry(const Flow& flow, double step, std::span<const double> travelled) {
  const double share = strain_share(flow, step);
  parallel_for(static_cast<std::ptrdiff_t>(travel_.size()), [&](std::ptrdiff_t rod) {
    const auto r = static_cast<std::size_t>(rod);
    travel_[r] = (travel_[r] + round_up(travelled[r] + share)) * (1 + 2e-7F);
  });
  Cell fluid;
  fluid.lattice = deformation_;
  deform(fluid, flow.gradient, step);
  deformation_ = fluid.lattice;
  strain_ += principal_rate(flow) * step;
}

bool NeighbourList::look_ahead(const FiberState& state, const Flow& flow, double step) {
  const auto nodes = static_cast<std::size_t>(state.node_count());
  ahead_.resize(nodes);
  reach_.resize(nodes);
  has_left_.assign(static_cast<std::size_t>(state.fiber_count()), 0);
  const bool is_listed = travel_.size() == nodes;
  if (!is_listed) travel_.assign(nodes, 0.0F);
  const double shrunk = is_listed ? std::exp(-strain_ - principal_rate(flow) * step) : 0.0;
  const double share = strain_share(flow, step);
  margin_.resize(nodes, 0.0);
  origin_.resize(nodes, Vec3::Zero());
  parallel_for_weighted(state.first_node, [&](std::ptrdiff_t f) {
    if (!look_ahead(state, static_cast<Index>(f), step, share, shrunk))
      has_left_[static_cast<std::size_t>(f)] = 1;
  });
  return std::find(has_left_.begin(), has_left_.end(), 1) == has_left_.end();
}

bool NeighbourList::look_ahead(const FiberState& state, Index fiber, double step, double share,
                               double shrunk) {
  bool covers = true;
  double moved_before = 0;
  double speed_before = 0;
  for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k) {
    const auto n = static_cast<std::size_t>(k);
    const double moved = (state.position[n] - deformation_ * origin_[n]).squaredNorm();
    const double speed = state.relative_velocity[n].norm();
    if (k > state.begin_node(fiber)) {
      const double ahead = step * std::max(speed, speed_before);
      const double allowed = 0.5 * (shrunk * (range_ + 2 * margin_[n - 1]) - range_) - ahead;
      covers = covers && allowed > 0 && std::max(moved, moved_before) <= allowed * allowed;
      ahead_[n - 1] = round_up(ahead + share);
      reach_[n - 1] = (travel_[n - 1] + ahead_[n - 1]) * (1 + 2e-7F);
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
