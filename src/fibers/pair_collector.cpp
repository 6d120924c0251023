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

PairCollector::PairCollector(const NeighbourList& list, const IndexedVector<RodIndex, double>& rod_length,
                             PairCandidates& candidates)
    : list_(list), rod_length_(rod_length), candidates_(candidates) {
  const RodGrid& grid = list_.grid_;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) fluid_.fluid[i][j] = static_cast<float>(list_.deformation_(i, j));
  }
  fluid_.stretch = static_cast<float>(list_.stretch() * (1 + 1e-6));
  fluid_.midpoint_x = grid.x.data();
  fluid_.midpoint_y = grid.y.data();
  fluid_.midpoint_z = grid.z.data();
  fluid_.axis_x = grid.axis_x.data();
  fluid_.axis_y = grid.axis_y.data();
  fluid_.axis_z = grid.axis_z.data();
  fluid_.half_lengths = grid.half_length.data();
  fluid_.margins = grid.margin_of.data();
}

void PairCollector::list(Bins bins, RodPairs& pairs) {
  pairs.clear();
  pairs_ = &pairs;
  is_renewing_ = false;
  const double reach = list_.widest();
  for (const RodGrid::Bin bin : bins) {
    const IndexRange<Entry> entries = list_.grid_.entries(bin);
    if (entries.size() == 0) continue;
    list_.grid_.runs_ahead(bin, reach, candidates_.runs);
    make_room();
    for (const Entry entry : entries) {
      // The first run begins with the entry's own bin, whose earlier entries have met this one.
      candidates_.runs.runs.front().begin = entry.value() + 1;
      collect(entry);
    }
  }
  pairs.pad();
}

void PairCollector::add(std::span<const Entry> entries, RodPairs& pairs) {
  pairs.unpad();
  pairs_ = &pairs;
  is_renewing_ = true;
  const double reach = list_.reach_of_strayed();
  for (const Entry entry : entries) {
    list_.grid_.runs_around(entry, reach, candidates_.runs);
    make_room();
    collect(entry);
  }
  pairs.pad();
}

void PairCollector::make_room() {
  const std::size_t room = candidates_.runs.entries() + cull_overrun;
  if (candidates_.entries.size() >= room) return;
  candidates_.entries.resize(2 * room);
  candidates_.squared_distances.resize(candidates_.entries.size());
}

RodCull PairCollector::query_of(Entry e) const {
  const RodGrid& grid = list_.grid_;
  RodCull query = fluid_;
  const Vec3 axis = list_.deformation_ * grid.axis(e);
  const double stretch = axis.norm();
  query.ax = static_cast<float>(axis.x() / stretch);
  query.ay = static_cast<float>(axis.y() / stretch);
  query.az = static_cast<float>(axis.z() / stretch);
  query.half_length = static_cast<float>(grid.half_length[e] * stretch);
  query.keep = static_cast<float>(list_.range_ + list_.margin_[grid.rod[e]] + list_.rounding_);
  return query;
}

/// Collects the pairs of one entry with those of the runs, image by image.
void PairCollector::collect(Entry entry) {
  const RodGrid& grid = list_.grid_;
  RodCull query = query_of(entry);
  Index* candidates = candidates_.entries.data();
  int first = 0;
  for (const RodGrid::Runs::Group& group : candidates_.runs.groups) {
    const Vec3 apart = list_.frame_.shift(group.shift);
    query.x = grid.x[entry] - static_cast<float>(apart.x());
    query.y = grid.y[entry] - static_cast<float>(apart.y());
    query.z = grid.z[entry] - static_cast<float>(apart.z());
    const int count = cull_rods(query, candidates_.runs.runs.data() + first, group.end - first, candidates);
    first = group.end;
    if (count == 0) continue;
    const int near =
        keep_near_rods(query, candidates, count, candidates, candidates_.squared_distances.data());
    for (int i = 0; i < near; ++i)
      consider(entry, Entry(candidates[i]), group.shift, candidates_.squared_distances[i]);
  }
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
    if (is_renewing_ && is_listed_anew(other)) return;  // that one finds the pair, too
    std::swap(rod, other);
    image = -image;
  }
  if (image.isZero() && is_own_neighbour(rod, other)) return;
  pairs_->add(rod, other, pack_image(image), wake(rod, other, std::sqrt(squared_distance)));
}

/// The travels of both rods at which a pair may matter that lie so far apart. In a list that is renewed rods
/// may be nearer than they lie: the pair is awake until it has been measured.
std::int32_t PairCollector::wake(RodIndex rod, RodIndex other, double distance) const {
  const double gap = is_renewing_ ? 0.0 : distance - list_.range_ - list_.rounding_;
  const double asleep = std::clamp(gap, 0.0, list_.widest_gap()) / list_.quantum_;
  return list_.travel_[rod] + list_.travel_[other] + static_cast<std::int32_t>(asleep);
}

bool PairCollector::is_own_neighbour(RodIndex rod, RodIndex other) const {
  if (list_.fiber_of(rod) != list_.fiber_of(other)) return false;
  double between = 0;
  for (RodIndex k = rod + 1; k < other && between < list_.range_; ++k) between += rod_length_[k];
  return between < list_.range_;
}

}  // namespace fiberfate
