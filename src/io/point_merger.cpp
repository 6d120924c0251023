// Finds points that lie at the same place.
#include "io/point_merger.hpp"

#include <cmath>

namespace fiberfate {

std::size_t PointMerger::BoxHash::operator()(const Box& box) const {
  constexpr std::uint64_t spread = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio (Knuth 1998, 6.4)
  std::uint64_t hash = 0;
  for (const std::int64_t number : box) hash = (hash ^ static_cast<std::uint64_t>(number)) * spread;
  return hash ^ (hash >> 32);
}

PointMerger::Box PointMerger::box_of(const Vec3& point) const {
  Box box{};
  if (reach_ > 0)
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = std::llround(std::floor(point[static_cast<Eigen::Index>(k)] / reach_));
  return box;
}

std::optional<Index> PointMerger::find(const Vec3& point, const Box& box) const {
  const auto [first, last] = in_box_.equal_range(box);
  for (auto one = first; one != last; ++one)
    if ((points_[one->second] - point).norm() <= reach_) return one->second;
  return std::nullopt;
}

Index PointMerger::index_of(const Vec3& point) {
  const Box here = box_of(point);
  if (const auto found = find(point, here)) return *found;  // nearly always, where there is one
  for (int step = 0; step < 27; ++step) {
    const Box beside = {here[0] + step % 3 - 1, here[1] + step / 3 % 3 - 1, here[2] + step / 9 - 1};
    if (const auto found = find(point, beside)) return *found;
  }
  points_.push_back(point);
  const auto index = static_cast<Index>(points_.size()) - 1;
  in_box_.emplace(here, index);
  return index;
}

}  // namespace fiberfate
