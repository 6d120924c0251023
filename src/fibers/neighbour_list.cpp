// Makes the list of neighbours and keeps account of how long it remains valid.
#include "fibers/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/threads.hpp"
#include "fibers/pair_collector.hpp"

namespace fiberfate {
namespace {

// Bins a chunk: small enough to balance threads, large enough to amortise their start.
constexpr Index chunk_size = 64;
// Bins of the grid are this share of the farthest midpoints: smaller ones hold fewer rods in vain, but make
// more runs.
constexpr double bin_share = 0.5;
// Rounding of coordinates in single precision, relative to the largest one.
constexpr double single_rounding = 4e-7;

}  // namespace

void NeighbourList::build(const FiberState& state, double range, std::vector<double> margin) {
  margin_ = std::move(margin);
  travel_.assign(margin_.size(), 0.0);
  origin_ = state.position;
  deformation_.setIdentity();
  strain_ = 0;
  range_ = range;
  farthest_ = range_ + 2 * *std::max_element(margin_.begin(), margin_.end());

  fiber_of_.resize(static_cast<std::size_t>(state.node_count()));
  double longest = 0;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k) {
      fiber_of_[static_cast<std::size_t>(k)] = fiber;
      longest = std::max(longest, state.rod_length[static_cast<std::size_t>(k)]);
    }
  }
  const double widest = (longest + farthest_) * (1 + 1e-5);
  grid_.fill(state, bin_share * widest, margin_);
  rounding_ = single_rounding * (state.cell.lattice.cwiseAbs().rowwise().sum().maxCoeff() + widest);
  const Index bins = grid_.bin_count();
  chunks_.resize(static_cast<std::size_t>((bins + chunk_size - 1) / chunk_size));
  parallel_for(static_cast<std::ptrdiff_t>(chunks_.size()), [&](std::ptrdiff_t c) {
    const Index begin = static_cast<Index>(c) * chunk_size;
    PairCollector(state, *this, widest)
        .run(begin, std::min(begin + chunk_size, bins), chunks_[static_cast<std::size_t>(c)]);
  });
}

void NeighbourList::carry(const Flow& flow, double step, std::span<const double> travelled) {
  const double share = strain_share(flow, step);
  for (std::size_t r = 0; r < travel_.size(); ++r) travel_[r] += travelled[r] + share;
  Cell fluid;
  fluid.lattice = deformation_;
  deform(fluid, flow.gradient, step);
  deformation_ = fluid.lattice;
  strain_ += principal_rate(flow) * step;
}

bool NeighbourList::covers(const FiberState& state, const Flow& flow, double step,
                           std::span<const double> ahead) const {
  if (travel_.size() != static_cast<std::size_t>(state.node_count())) return false;
  const double shrunk = std::exp(-strain_ - principal_rate(flow) * step);
  std::vector<std::uint8_t> has_left(static_cast<std::size_t>(state.fiber_count()), 0);
  parallel_for(state.fiber_count(), [&](std::ptrdiff_t f) {
    const Index fiber = static_cast<Index>(f);
    double before = 0;
    for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k) {
      const auto n = static_cast<std::size_t>(k);
      const double moved = (state.position[n] - deformation_ * origin_[n]).squaredNorm();
      if (k > state.begin_node(fiber)) {
        const double allowed = 0.5 * (shrunk * (range_ + 2 * margin_[n - 1]) - range_) - ahead[n - 1];
        if (allowed <= 0 || std::max(moved, before) > allowed * allowed)
          has_left[static_cast<std::size_t>(f)] = 1;
      }
      before = moved;
    }
  });
  return std::find(has_left.begin(), has_left.end(), 1) == has_left.end();
}

double NeighbourList::strain_share(const Flow& flow, double step) const {
  return 0.5 * std::expm1(principal_rate(flow) * step) * farthest_;
}

std::size_t NeighbourList::pair_count() const {
  std::size_t count = 0;
  for (const auto& chunk : chunks_) count += chunk.size();
  return count;
}

}  // namespace fiberfate
