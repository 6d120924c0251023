// Culls pairs of rods in single precision.
#include "fibers/pair_collector.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fiberfate {
namespace {

bool is_later_image(const IntVec3& image) {
  return std::make_tuple(image[0], image[1], image[2]) > std::make_tuple(0, 0, 0);
}

}  // namespace

void PairCollector::run(IndexRange<RodGrid::Bin> bins, RodPairs& pairs) {
  pairs.clear();
  pairs_ = &pairs;
  for (const RodGrid::Bin bin : bins) {
    const IndexRange<Entry> entries = list_.grid_.entries(bin);
    if (entries.size() == 0) continue;
    list_.grid_.runs_ahead(bin, widest_, candidates_.runs);
    std::size_t room = 0;
    for (const RodGrid::Run& run : candidates_.runs) room += run.end - run.begin;
    if (candidates_.entries.size() < room + cull_overrun) {
      candidates_.entries.resize(2 * room + cull_overrun);
      candidates_.squared_distances.resize(candidates_.entries.size());
    }
    for (const Entry entry : entries) collect(entry);
  }
  pairs.pad();
}

RodCull PairCollector::query_of(Entry e) const {
  const RodGrid& grid = list_.grid_;
  RodCull query{};
  query.ax = grid.axis_x[e];
  query.ay = grid.axis_y[e];
  query.az = grid.axis_z[e];
  query.half_length = grid.half_length[e];
  query.keep = static_cast<float>(list_.range_ + list_.margin_[grid.rod[e]] + list_.rounding_);
  query.midpoint_x = grid.x.data();
  query.midpoint_y = grid.y.data();
  query.midpoint_z = grid.z.data();
  query.axis_x = grid.axis_x.data();
  query.axis_y = grid.axis_y.data();
  query.axis_z = grid.axis_z.data();
  query.half_lengths = grid.half_length.data();
  query.margins = grid.margin_of.data();
  return query;
}

/// Collects the pairs of one entry with those that come after it.
void PairCollector::collect(Entry entry) {
  const RodGrid& grid = list_.grid_;
  RodCull query = query_of(entry);
  IntVec3 shift = IntVec3::Zero();
  count_ = 0;
  const auto stand_at = [&](const IntVec3& image) {
    const Vec3 apart = state_.cell.shift(image);
    query.x = grid.x[entry] - static_cast<float>(apart.x());
    query.y = grid.y[entry] - static_cast<float>(apart.y());
    query.z = grid.z[entry] - static_cast<float>(apart.z());
  };
  stand_at(shift);
  for (std::size_t r = 0; r < candidates_.runs.size(); ++r) {
    if (candidates_.runs[r].shift != shift) {
      measure(entry, query, shift);
      shift = candidates_.runs[r].shift;
      stand_at(shift);
    }
    // The first run begins with the entry's own bin, whose earlier entries have met this one.
    const Entry begin = r == 0 ? entry + 1 : candidates_.runs[r].begin;
    count_ +=
        cull_rods(query, begin.value(), candidates_.runs[r].end.value(), candidates_.entries.data() + count_);
  }
  measure(entry, query, shift);
}

/// Measures the candidates found so far, which all stand in one image.
void PairCollector::measure(Entry entry, RodCull& query, const IntVec3& shift) {
  if (count_ == 0) return;
  const int near = keep_near_rods(query, candidates_.entries.data(), count_, candidates_.entries.data(),
                                  candidates_.squared_distances.data());
  for (int i = 0; i < near; ++i)
    consider(entry, Entry(candidates_.entries[i]), shift, candidates_.squared_distances[i]);
  count_ = 0;
}

void PairCollector::consider(Entry entry, Entry other_entry, const IntVec3& shift, float squared_distance) {
  const RodGrid& grid = list_.grid_;
  const auto& mine = grid.image[entry];
  const auto& theirs = grid.image[other_entry];
  RodIndex rod = grid.rod[entry];
  RodIndex other = grid.rod[other_entry];
  IntVec3 image(mine[0] - theirs[0] + shift[0], mine[1] - theirs[1] + shift[1],
                mine[2] - theirs[2] + shift[2]);
  if (other < rod || (other == rod && !is_later_image(image))) {
    std::swap(rod, other);
    image = -image;
  }
  if (image.isZero() && is_own_neighbour(rod, other)) return;
  const double gap = std::sqrt(squared_distance) - list_.range_ - list_.rounding_;
  pairs_->add(rod, other, pack_image(image), static_cast<float>(std::max(0.0, gap)));
}

bool PairCollector::is_own_neighbour(RodIndex rod, RodIndex other) const {
  if (list_.fiber_of(rod) != list_.fiber_of(other)) return false;
  double between = 0;
  for (RodIndex k = rod + 1; k < other && between < list_.range_; ++k) between += state_.rod_length[k];
  return between < list_.range_;
}

}  // namespace fiberfate
