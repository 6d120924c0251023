// Bins rods with a counting sort.
#include "fibers/rod_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

// Bins are not made finer than this many per rod: empty bins cost time too.
constexpr double bins_per_rod = 4.0;

/// Holds a bin index wrapped into the grid and the image it was wrapped by.
struct WrappedBin {
  int bin;
  int turns;
};

WrappedBin wrap(int bin, int bins) {
  const int turns = bin >= 0 ? bin / bins : -((bins - 1 - bin) / bins);
  return {bin - turns * bins, turns};
}

/// Holds a rod before it is sorted.
struct BinnedRod {
  Vec3 midpoint;
  IntVec3 image;
  double half_length;
  Index rod;
  Index bin;
};

}  // namespace

void RodGrid::fill(const FiberState& state, double bin_width, const std::vector<double>& margin) {
  boundary_ = state.cell.boundary;
  to_fraction_ = state.cell.lattice.inverse();
  const double most = std::max(1.0, 2 * std::cbrt(bins_per_rod * state.rod_count()));
  for (std::size_t i = 0; i < 3; ++i) {
    height_[i] = state.cell.height(static_cast<int>(i));
    bins_[i] = std::max(1, static_cast<int>(std::min(std::floor(height_[i] / bin_width), most)));
  }

  const auto rods = static_cast<std::size_t>(state.rod_count());
  std::vector<BinnedRod> unsorted(rods);
  parallel_for(state.fiber_count(), [&](std::ptrdiff_t f) {
    const Index fiber = static_cast<Index>(f);
    for (Index k = state.begin_node(fiber); k + 1 < state.end_node(fiber); ++k) {
      const auto n = static_cast<std::size_t>(k);
      const Vec3 midpoint = 0.5 * (state.position[n] + state.position[n + 1]);
      const IntVec3 in_image = image_of(state.cell, midpoint);
      const Vec3 wrapped = midpoint - state.cell.shift(in_image);
      const double half = 0.5 * (state.position[n + 1] - state.position[n]).norm();
      unsorted[static_cast<std::size_t>(k - fiber)] = {wrapped, in_image, half, k,
                                                       static_cast<Index>(bin_index(bin_at(wrapped)))};
    }
  });

  begin_.assign(static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(bins_[1] * bins_[2]) + 1, 0);
  for (const BinnedRod& one : unsorted) ++begin_[static_cast<std::size_t>(one.bin) + 1];
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  std::vector<Index> next(begin_.begin(), begin_.end() - 1);
  for (auto* array : {&x, &y, &z, &half_length, &margin_of}) array->resize(rods + padding, 0.0F);
  rod.resize(rods);
  image.resize(rods);
  for (const BinnedRod& one : unsorted) {
    const Index place = next[static_cast<std::size_t>(one.bin)]++;
    const auto e = static_cast<std::size_t>(place);
    x[e] = static_cast<float>(one.midpoint.x());
    y[e] = static_cast<float>(one.midpoint.y());
    z[e] = static_cast<float>(one.midpoint.z());
    half_length[e] = static_cast<float>(one.half_length);
    margin_of[e] = static_cast<float>(margin[static_cast<std::size_t>(one.rod)]);
    rod[e] = one.rod;
    for (std::size_t i = 0; i < 3; ++i)
      image[e][i] = static_cast<std::int16_t>(one.image[static_cast<int>(i)]);
  }
}

std::array<int, 3> RodGrid::bin_at(const Vec3& midpoint) const {
  const Vec3 fraction = to_fraction_ * midpoint;
  std::array<int, 3> bin{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = std::floor(fraction[static_cast<int>(i)] * bins_[i]);
    bin[i] = static_cast<int>(std::clamp(place, 0.0, bins_[i] - 1.0));
  }
  return bin;
}

void RodGrid::runs_around(Index bin, double reach, std::vector<Run>& runs) const {
  runs.clear();
  const std::array<int, 3> centre = {bin / (bins_[1] * bins_[2]), bin / bins_[2] % bins_[1], bin % bins_[2]};
  std::array<int, 3> low{};
  std::array<int, 3> high{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int span = static_cast<int>(std::ceil(reach * bins_[i] / height_[i]));
    low[i] = centre[i] - span;
    high[i] = centre[i] + span;
    if (boundary_[i] == Boundary::periodic) continue;
    low[i] = std::max(low[i], 0);
    high[i] = std::min(high[i], bins_[i] - 1);
  }
  for (int i = low[0]; i <= high[0]; ++i) {
    for (int j = low[1]; j <= high[1]; ++j) {
      const WrappedBin first = wrap(i, bins_[0]);
      const WrappedBin second = wrap(j, bins_[1]);
      add_row({first.bin, second.bin, low[2]}, high[2] - low[2] + 1, {first.turns, second.turns, 0}, runs);
    }
  }
}

void RodGrid::add_row(const std::array<int, 3>& from, int count, IntVec3 shift,
                      std::vector<Run>& runs) const {
  int third = from[2];
  while (count > 0) {
    const WrappedBin wrapped = wrap(third, bins_[2]);
    const int length = std::min(count, bins_[2] - wrapped.bin);
    const std::size_t first = bin_index({from[0], from[1], wrapped.bin});
    shift[2] = wrapped.turns;
    const Run run{begin_[first], begin_[first + static_cast<std::size_t>(length)], shift};
    if (run.end > run.begin) runs.push_back(run);
    third += length;
    count -= length;
  }
}

}  // namespace fiberfate
