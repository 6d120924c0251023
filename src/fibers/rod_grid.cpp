// Bins rods with a counting sort.
#include "fibers/rod_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

// Bins are not made finer than this many per rod: empty bins cost time too.
constexpr double bins_per_rod = 4.0;

// Lattice directions of the grid, whose bins are numbered with the first one slowest: the gradient direction
// of a shear, along which fibers soon extend least, so that threads, which share the bins by number, meet few
// of each other's fibers; the flow direction last, in which the rods of a fiber follow one another.
constexpr std::array<int, 3> direction = {1, 2, 0};

/// A bin index wrapped into the grid and the image it was wrapped by.
struct WrappedBin {
  int bin;
  int turns;
};

WrappedBin wrap(int bin, int bins) {
  const int turns = bin >= 0 ? bin / bins : -((bins - 1 - bin) / bins);
  return {bin - turns * bins, turns};
}

}  // namespace

void RodGrid::fill(const FiberState& state, double bin_width, const IndexedVector<RodIndex, double>& margin) {
  boundary_ = state.cell.boundary;
  to_fraction_ = state.cell.lattice.inverse();
  const double most = std::max(1.0, 2 * std::cbrt(bins_per_rod * state.rod_count()));
  for (std::size_t i = 0; i < 3; ++i) {
    height_[i] = state.cell.height(direction[i]);
    bins_[i] = std::max(1, static_cast<int>(std::min(std::floor(height_[i] / bin_width), most)));
  }

  bin_rods(state);
  sort_bins();
  const std::size_t rods = unsorted_.size();
  for (auto* array : {&x, &y, &z, &axis_x, &axis_y, &axis_z, &half_length, &margin_of})
    array->resize(rods + padding, 0.0F);
  rod.resize(rods);
  image.resize(rods);
  // Entry after entry: threads that wrote into one another's cache lines would wait for them.
  parallel_for(rod.indices(), [&](Entry e) {
    const BinnedRod& one = unsorted_[source_[e]];
    x[e] = one.midpoint[0];
    y[e] = one.midpoint[1];
    z[e] = one.midpoint[2];
    axis_x[e] = one.axis[0];
    axis_y[e] = one.axis[1];
    axis_z[e] = one.axis[2];
    half_length[e] = one.half_length;
    margin_of[e] = static_cast<float>(margin[one.rod]);
    rod[e] = one.rod;
    image[e] = one.image;
  });
}

void RodGrid::bin_rods(const FiberState& state) {
  unsorted_.resize(state.rod_count());
  parallel_for_weighted(state.first_node, [&](FiberIndex fiber) {
    // One node a fiber, its last one, owns no rod.
    for (const RodIndex one : state.rods(fiber)) unsorted_[one.value() - fiber.value()] = binned(state, one);
  });
}

RodGrid::BinnedRod RodGrid::binned(const FiberState& state, RodIndex which) const {
  const Vec3 axis = state.axis(which);
  const double length = axis.norm();
  Vec3 wrapped = state.centre(which);
  const Vec3 fraction = to_fraction_ * wrapped;
  BinnedRod one{};
  for (int i = 0; i < 3; ++i) {
    if (boundary_[i] != Boundary::periodic) continue;
    const double turns = std::floor(fraction[i]);
    one.image[i] = static_cast<std::int16_t>(turns);
    wrapped -= turns * state.cell.lattice.col(i);
  }
  for (int i = 0; i < 3; ++i) {
    one.midpoint[i] = static_cast<float>(wrapped[i]);
    one.axis[i] = static_cast<float>(axis[i] / length);
  }
  one.half_length = static_cast<float>(0.5 * length);
  one.rod = which;
  one.bin = bin_index(bin_at(wrapped));
  return one;
}

/// Finds the rod of every entry: by bin, then by rod.
void RodGrid::sort_bins() {
  // A bin's first entry is counted two bins further on, so that, advanced in placing, it ends up in place.
  begin_.assign(static_cast<std::size_t>(bins_[0]) * bins_[1] * bins_[2] + 2, Entry(0));
  source_.resize(unsorted_.size());
  for (const BinnedRod& one : unsorted_) ++begin_[one.bin + 2];
  for (Bin bin(2); bin < Bin(begin_.size()); ++bin) begin_[bin] = begin_[bin] + begin_[bin - 1].value();
  for (Index i = 0; i < std::ssize(unsorted_); ++i) source_[begin_[unsorted_[i].bin + 1]++] = i;
  begin_.pop_back();
}

std::array<int, 3> RodGrid::bin_at(const Vec3& midpoint) const {
  const Vec3 fraction = to_fraction_ * midpoint;
  std::array<int, 3> bin{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = std::floor(fraction[direction[i]] * bins_[i]);
    bin[i] = static_cast<int>(std::clamp(place, 0.0, bins_[i] - 1.0));
  }
  return bin;
}

RodGrid::Block RodGrid::block_around(Bin bin, double reach) const {
  Block block;
  const int number = bin.value();
  block.centre = {number / (bins_[1] * bins_[2]), number / bins_[2] % bins_[1], number % bins_[2]};
  for (std::size_t i = 0; i < 3; ++i) {
    const int span = static_cast<int>(std::ceil(reach * bins_[i] / height_[i]));
    block.low[i] = block.centre[i] - span;
    block.high[i] = block.centre[i] + span;
    if (boundary_[direction[i]] == Boundary::periodic) continue;
    block.low[i] = std::max(block.low[i], 0);
    block.high[i] = std::min(block.high[i], bins_[i] - 1);
  }
  return block;
}

void RodGrid::runs_ahead(Bin bin, double reach, std::vector<Run>& runs) const {
  runs.clear();
  Block block = block_around(bin, reach);
  const int low = block.low[2];
  block.low[2] = block.centre[2];
  add_row(block, block.centre[0], block.centre[1], runs);
  block.low[2] = low;
  for (int j = block.centre[1] + 1; j <= block.high[1]; ++j) add_row(block, block.centre[0], j, runs);
  for (int i = block.centre[0] + 1; i <= block.high[0]; ++i) {
    for (int j = block.low[1]; j <= block.high[1]; ++j) add_row(block, i, j, runs);
  }
}

/// Adds the runs of the bins (i, j, low to high) of a block, split where they wrap around the cell.
void RodGrid::add_row(const Block& block, int i, int j, std::vector<Run>& runs) const {
  const WrappedBin first = wrap(i, bins_[0]);
  const WrappedBin second = wrap(j, bins_[1]);
  int third = block.low[2];
  while (third <= block.high[2]) {
    const WrappedBin wrapped = wrap(third, bins_[2]);
    const int length = std::min(block.high[2] - third + 1, bins_[2] - wrapped.bin);
    const Bin from = bin_index({first.bin, second.bin, wrapped.bin});
    Run run{begin_[from], begin_[from + length]};
    run.shift[direction[0]] = first.turns;
    run.shift[direction[1]] = second.turns;
    run.shift[direction[2]] = wrapped.turns;
    if (run.end > run.begin) runs.push_back(run);
    third += length;
  }
}

}  // namespace fiberfate
