// Bins rods with a counting sort.
#include "fibers/rod_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

// Bins are not made finer than this many per rod: empty bins cost time too.
constexpr double bins_per_rod = 2.0;

std::array<float, 3> single(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

void RodGrid::fill(const FiberState& state, double bin_width) {
  boundary_ = state.cell.boundary;
  to_fraction_ = state.cell.lattice.inverse();
  const double crowd = std::max(1.0, std::cbrt(bins_per_rod * state.rod_count()));
  for (std::size_t i = 0; i < 3; ++i) {
    height_[i] = state.cell.height(static_cast<int>(i));
    const double wanted = std::min(std::floor(height_[i] / bin_width), 4 * crowd);
    bins_[i] = std::max(1, static_cast<int>(wanted));
  }

  std::vector<Entry> unsorted(static_cast<std::size_t>(state.rod_count()));
  parallel_for(state.fiber_count(), [&](std::ptrdiff_t f) {
    const Index fiber = static_cast<Index>(f);
    for (Index k = state.begin_node(fiber); k + 1 < state.end_node(fiber); ++k) {
      const auto n = static_cast<std::size_t>(k);
      const Vec3 midpoint = 0.5 * (state.position[n] + state.position[n + 1]);
      const IntVec3 image = image_of(state.cell, midpoint);
      const Vec3 half = 0.5 * (state.position[n + 1] - state.position[n]);
      Entry& entry = unsorted[static_cast<std::size_t>(k - fiber)];
      entry.midpoint = single(midpoint - state.cell.shift(image));
      entry.half_axis = single(half);
      entry.half_length = static_cast<float>(half.norm());
      entry.rod = k;
      for (std::size_t i = 0; i < 3; ++i)
        entry.image[i] = static_cast<std::int16_t>(image[static_cast<int>(i)]);
    }
  });

  begin_.assign(static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(bins_[1]) *
                        static_cast<std::size_t>(bins_[2]) +
                    1,
                0);
  std::vector<Index> bin(unsorted.size());
  for (std::size_t i = 0; i < unsorted.size(); ++i) {
    bin[i] = static_cast<Index>(bin_index(bin_of(unsorted[i])));
    ++begin_[static_cast<std::size_t>(bin[i]) + 1];
  }
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  std::vector<Index> next(begin_.begin(), begin_.end() - 1);
  entries_.resize(unsorted.size());
  place_.assign(static_cast<std::size_t>(state.node_count()), -1);
  for (std::size_t i = 0; i < unsorted.size(); ++i) {
    const Index place = next[static_cast<std::size_t>(bin[i])]++;
    entries_[static_cast<std::size_t>(place)] = unsorted[i];
    place_[static_cast<std::size_t>(unsorted[i].rod)] = place;
  }
}

std::array<int, 3> RodGrid::bin_of(const Entry& entry) const {
  const Vec3 midpoint(entry.midpoint[0], entry.midpoint[1], entry.midpoint[2]);
  const Vec3 fraction = to_fraction_ * midpoint;
  std::array<int, 3> bin{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = std::floor(fraction[static_cast<int>(i)] * bins_[i]);
    bin[i] = static_cast<int>(std::clamp(place, 0.0, bins_[i] - 1.0));
  }
  return bin;
}

std::array<int, 3> RodGrid::bins_within(double reach) const {
  std::array<int, 3> span{};
  for (std::size_t i = 0; i < 3; ++i) {
    span[i] = static_cast<int>(std::ceil(reach * bins_[i] / height_[i] * (1 + 1e-6)));
    if (boundary_[i] != Boundary::periodic) span[i] = std::min(span[i], bins_[i] - 1);
  }
  return span;
}

}  // namespace fiberfate
