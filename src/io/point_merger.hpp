// Points that lie at the same place, made one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Numbers points in the order in which they first come, and gives those within `reach` of an earlier one
/// that one's number.
class PointMerger {
 public:
  explicit PointMerger(double reach) : reach_(reach) {}
  [[nodiscard]] Index index_of(const Vec3& point);
  [[nodiscard]] std::span<const Vec3> points() const { return points_; }

 private:
  using Box = std::array<std::int64_t, 3>;  ///< of the size of the reach
  struct BoxHash {
    std::size_t operator()(const Box& box) const;
  };
  [[nodiscard]] Box box_of(const Vec3& point) const;
  [[nodiscard]] std::optional<Index> find(const Vec3& point, const Box& box) const;

  double reach_;
  std::vector<Vec3> points_;
  std::unordered_multimap<Box, Index, BoxHash> in_box_;
};

}  // namespace fiberfate
