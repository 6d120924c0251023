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

}  // namespace

void RodGrid::fill(const FiberNodes& fibers, const Cell& cell, double bin_width,
                   const IndexedVector<RodIndex, double>& margin) {
  cell_ = cell;
  to_fraction_ = cell.lattice.inverse();
  flow_with(cell);
  const double most = std::max(1.0, 2 * std::cbrt(bins_per_rod * fibers.rod_count()));
  for (std::size_t i = 0; i < 3; ++i)
    bins_[i] = std::max(1, static_cast<int>(std::min(std::floor(height_[i] / bin_width), most)));

  bin_rods(fibers);
  sort_bins();
  const std::size_t rods = unsorted_.size();
  for (auto* array : {&x, &y, &z, &axis_x, &axis_y, &axis_z, &half_length, &margin_of})
    array->resize(rods + padding, 0.0F);
  strayed_.assign(rods, 0.0F);
  rod.resize(rods);
  image.resize(rods);
  entry_of_.resize(fibers.position.size());
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
    entry_of_[one.rod] = e;
    image[e] = one.image;
  });
}

void RodGrid::flow_with(const Cell& cell) {
  for (std::size_t i = 0; i < 3; ++i) height_[i] = cell.height(direction[i]);
}

void RodGrid::renew(Entry entry, const Segment& one, double margin) {
  const Vec3 axis = one.end - one.begin;
  const double length = axis.norm();
  Vec3 wrapped = 0.5 * (one.begin + one.end);
  for (int i = 0; i < 3; ++i) wrapped -= image[entry][i] * cell_.lattice.col(i);
  strayed_[entry] += static_cast<float>((wrapped - midpoint(entry)).norm() * (1 + 1e-6));
  x[entry] = static_cast<float>(wrapped.x());
  y[entry] = static_cast<float>(wrapped.y());
  z[entry] = static_cast<float>(wrapped.z());
  axis_x[entry] = static_cast<float>(axis.x() / length);
  axis_y[entry] = static_cast<float>(axis.y() / length);
  axis_z[entry] = static_cast<float>(axis.z() / length);
  half_length[entry] = static_cast<float>(0.5 * length);
  margin_of[entry] = static_cast<float>(margin);
}

void RodGrid::renumber(const IndexedVector<RodIndex, RodIndex>& numbers, RodIndex end) {
  entry_of_.resize(end.value());
  parallel_for(rod.indices(), [&](Entry e) {
    rod[e] = numbers[rod[e]];
    entry_of_[rod[e]] = e;
  });
}

void RodGrid::bin_rods(const FiberNodes& fibers) {
  unsorted_.resize(fibers.rod_count());
  parallel_for_weighted(fibers.first_node, [&](FiberIndex fiber) {
    // One node a fiber, its last one, owns no rod.
    for (const RodIndex one : fibers.rods(fiber)) {
      BinnedRod& bin = unsorted_[one.value() - fiber.value()];
      bin = binned(fibers.segment(one));
      bin.rod = one;
    }
  });
}

RodGrid::BinnedRod RodGrid::binned(const Segment& one_rod) const {
  const Vec3 axis = one_rod.end - one_rod.begin;
  const double length = axis.norm();
  Vec3 wrapped = 0.5 * (one_rod.begin + one_rod.end);
  const Vec3 fraction = to_fraction_ * wrapped;
  BinnedRod one{};
  for (int i = 0; i < 3; ++i) {
    if (cell_.boundary[i] != Boundary::periodic) continue;
    const double turns = std::floor(fraction[i]);
    one.image[i] = static_cast<std::int16_t>(turns);
    wrapped -= turns * cell_.lattice.col(i);
  }
  for (int i = 0; i < 3; ++i) {
    one.midpoint[i] = static_cast<float>(wrapped[i]);
    one.axis[i] = static_cast<float>(axis[i] / length);
  }
  one.half_length = static_cast<float>(0.5 * length);
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

std::size_t RodGrid::Runs::entries() const {
  std::size_t count = 0;
  for (const EntryRun& run : runs) count += run.end - run.begin;
  return count;
}

void RodGrid::runs_ahead(Bin bin, double reach, Runs& runs) const {
  runs.runs.clear();
  runs.groups.clear();
  const int number = bin.value();
  const std::array<int, 3> centre = {number / (bins_[1] * bins_[2]), number / bins_[2] % bins_[1],
                                     number % bins_[2]};
  Block block{centre, centre};
  for (std::size_t i = 0; i < 3; ++i) {
    const int span = static_cast<int>(std::ceil(reach * bins_[i] / height_[i]));
    block.low[i] -= span;
    block.high[i] += span;
  }
  keep_within_walls(block);
  add_block({centre, {centre[0], centre[1], block.high[2]}}, runs);
  add_block({{centre[0], centre[1] + 1, block.low[2]}, {centre[0], block.high[1], block.high[2]}}, runs);
  add_block({{centre[0] + 1, block.low[1], block.low[2]}, block.high}, runs);
}

void RodGrid::runs_around(Entry entry, double reach, Runs& runs) const {
  runs.runs.clear();
  runs.groups.clear();
  const Vec3 fraction = to_fraction_ * midpoint(entry);
  Block block;
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = fraction[direction[i]] * bins_[i];
    const double span = reach * bins_[i] / height_[i];
    block.low[i] = static_cast<int>(std::floor(place - span));
    block.high[i] = static_cast<int>(std::floor(place + span));
  }
  keep_within_walls(block);
  add_block(block, runs);
}

void RodGrid::keep_within_walls(Block& block) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (cell_.boundary[direction[i]] == Boundary::periodic) continue;
    block.low[i] = std::clamp(block.low[i], 0, bins_[i] - 1);
    block.high[i] = std::clamp(block.high[i], 0, bins_[i] - 1);
  }
}

/// The bins from `low` on, no farther than `high`, that lie in one image.
RodGrid::Stretch RodGrid::stretch_from(int along, int low, int high) const {
  const int bins = bins_[along];
  const int turns = low >= 0 ? low / bins : -((bins - 1 - low) / bins);
  return {low - turns * bins, std::min(high - turns * bins + 1, bins), turns};
}

/// Adds the runs of a block, image by image.
void RodGrid::add_block(const Block& block, Runs& runs) const {
  const auto for_stretches = [&](int along, const auto& body) {
    for (int low = block.low[along]; low <= block.high[along];) {
      const Stretch stretch = stretch_from(along, low, block.high[along]);
      body(stretch);
      low += stretch.end - stretch.begin;
    }
  };
  for_stretches(0, [&](const Stretch& first) {
    for_stretches(1, [&](const Stretch& second) {
      for_stretches(2, [&](const Stretch& third) {
        const std::size_t before = runs.runs.size();
        for (int i = first.begin; i < first.end; ++i) {
          for (int j = second.begin; j < second.end; ++j) {
            const EntryRun run{begin_[bin_index({i, j, third.begin})].value(),
                               begin_[bin_index({i, j, third.end - 1}) + 1].value()};
            if (run.end > run.begin) runs.runs.push_back(run);
          }
        }
        if (runs.runs.size() == before) return;
        IntVec3 shift;
        shift[direction[0]] = first.turns;
        shift[direction[1]] = second.turns;
        shift[direction[2]] = third.turns;
        runs.groups.push_back({shift, static_cast<int>(runs.runs.size())});
      });
    });
  });
}

}  // namespace fiberfate
