// Culls pairs in single precision and measures the rest exactly.
#include "fibers/pair_collector.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fibers/rod_cull.hpp"

namespace fiberfate {
namespace {

bool is_later_image(const IntVec3& image) {
  return std::make_tuple(image[0], image[1], image[2]) > std::make_tuple(0, 0, 0);
}

}  // namespace

void PairCollector::run(Index begin, Index end, std::vector<RodPair>& pairs) {
  pairs.clear();
  pairs_ = &pairs;
  for (Index bin = begin; bin < end; ++bin) {
    const Index first = list_.grid_.first_entry(bin);
    const Index last = list_.grid_.first_entry(bin + 1);
    if (first == last) continue;
    list_.grid_.runs_around(bin, widest_, runs_);
    shifts_.clear();
    for (const RodGrid::Run& run : runs_) shifts_.push_back(state_.cell.shift(run.shift));
    for (Index entry = first; entry < last; ++entry) cull(entry);
  }
  if (count_ > 0) measure();
}

void PairCollector::cull(Index entry) {
  const RodGrid& grid = list_.grid_;
  const auto e = static_cast<std::size_t>(entry);
  const auto n = static_cast<std::size_t>(grid.rod[e]);
  const Vec3 axis = (state_.position[n + 1] - state_.position[n]).normalized();
  RodCull query{};
  query.ax = static_cast<float>(axis.x());
  query.ay = static_cast<float>(axis.y());
  query.az = static_cast<float>(axis.z());
  query.half_length = grid.half_length[e];
  query.keep = static_cast<float>(list_.range_ + list_.margin_[n] + list_.rounding_);
  query.midpoint_x = grid.x.data();
  query.midpoint_y = grid.y.data();
  query.midpoint_z = grid.z.data();
  query.half_lengths = grid.half_length.data();
  query.margins = grid.margin_of.data();
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const RodGrid::Run& run = runs_[r];
    query.x = grid.x[e] - static_cast<float>(shifts_[r].x());
    query.y = grid.y[e] - static_cast<float>(shifts_[r].y());
    query.z = grid.z[e] - static_cast<float>(shifts_[r].z());
    found_.resize(std::max(found_.size(), static_cast<std::size_t>(run.end - run.begin) + RodGrid::padding));
    const int near = cull_rods(query, run.begin, run.end, found_.data());
    for (int i = 0; i < near; ++i) consider(entry, found_[static_cast<std::size_t>(i)], run.shift);
  }
}

void PairCollector::consider(Index entry, Index other_entry, const IntVec3& shift) {
  const RodGrid& grid = list_.grid_;
  const Index rod = grid.rod[static_cast<std::size_t>(entry)];
  const Index other = grid.rod[static_cast<std::size_t>(other_entry)];
  if (other < rod) return;
  const auto& mine = grid.image[static_cast<std::size_t>(entry)];
  const auto& theirs = grid.image[static_cast<std::size_t>(other_entry)];
  const IntVec3 image(mine[0] - theirs[0] + shift[0], mine[1] - theirs[1] + shift[1],
                      mine[2] - theirs[2] + shift[2]);
  if (other == rod && !is_later_image(image)) return;
  if (image.isZero() && is_own_neighbour(rod, other)) return;
  add({rod,
       other,
       {static_cast<std::int8_t>(image[0]), static_cast<std::int8_t>(image[1]),
        static_cast<std::int8_t>(image[2])},
       0.0});
}

bool PairCollector::is_own_neighbour(Index rod, Index other) const {
  if (list_.fiber_of(rod) != list_.fiber_of(other)) return false;
  double between = 0;
  for (Index k = rod + 1; k < other && between < list_.range_; ++k)
    between += state_.rod_length[static_cast<std::size_t>(k)];
  return between < list_.range_;
}

void PairCollector::add(const RodPair& pair) {
  candidate_[static_cast<std::size_t>(count_)] = pair;
  block_.put(count_, state_, pair.first, pair.second, pair.image);
  if (++count_ == SegmentBlock::capacity) measure();
}

void PairCollector::measure() {
  block_.fill_up(count_);
  find_segment_distances(block_, count_);
  for (int i = 0; i < count_; ++i) {
    RodPair pair = candidate_[static_cast<std::size_t>(i)];
    const double margins = list_.margin_[static_cast<std::size_t>(pair.first)] +
                           list_.margin_[static_cast<std::size_t>(pair.second)];
    const double gap = block_.distance[i] - list_.range_;
    if (gap > margins) continue;
    pair.wake = std::max(0.0, gap);
    pairs_->push_back(pair);
  }
  count_ = 0;
}

}  // namespace fiberfate
