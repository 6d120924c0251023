// The nodes of fibers: where they are, and which fiber and which rods they belong to.
#pragma once

#include <algorithm>
#include <span>

#include "base/index.hpp"
#include "base/vector.hpp"
#include "fibers/closest_points.hpp"

namespace fiberfate {

using FiberIndex = IndexOf<struct FiberTag>;
using NodeIndex = IndexOf<struct NodeTag>;
/// A rod has the number of its first node; the number of a fiber's last node stands for no rod.
using RodIndex = IndexOf<struct RodTag>;

/// The nodes between which a rod lies.
[[nodiscard]] constexpr NodeIndex first_end(RodIndex rod) {
  return NodeIndex(rod.value());
}
[[nodiscard]] constexpr NodeIndex second_end(RodIndex rod) {
  return NodeIndex(rod.value() + 1);
}
/// The rods that a node of a fiber joins, where there are any.
[[nodiscard]] constexpr RodIndex rod_before(NodeIndex node) {
  return RodIndex(node.value() - 1);
}
[[nodiscard]] constexpr RodIndex rod_after(NodeIndex node) {
  return RodIndex(node.value());
}

/// Chains of rods between nodes. The nodes of a fiber are contiguous, in order, and unwrapped.
struct FiberNodes {
  IndexedVector<NodeIndex, Vec3> position;
  IndexedVector<FiberIndex, NodeIndex> first_node = {NodeIndex(0)};  ///< CSR offsets, fibers + 1 entries

  [[nodiscard]] Index fiber_count() const { return static_cast<Index>(first_node.size()) - 1; }
  [[nodiscard]] Index node_count() const { return static_cast<Index>(position.size()); }
  [[nodiscard]] Index rod_count() const { return node_count() - fiber_count(); }
  [[nodiscard]] Index rod_count(FiberIndex fiber) const { return end_node(fiber) - begin_node(fiber) - 1; }
  [[nodiscard]] NodeIndex begin_node(FiberIndex fiber) const { return first_node[fiber]; }
  [[nodiscard]] NodeIndex end_node(FiberIndex fiber) const { return first_node[fiber + 1]; }
  [[nodiscard]] NodeIndex last_node(FiberIndex fiber) const { return end_node(fiber) - 1; }

  [[nodiscard]] IndexRange<FiberIndex> fibers() const { return first_indices<FiberIndex>(fiber_count()); }
  [[nodiscard]] IndexRange<NodeIndex> nodes() const { return position.indices(); }
  [[nodiscard]] IndexRange<NodeIndex> nodes(FiberIndex fiber) const {
    return {begin_node(fiber), end_node(fiber)};
  }
  [[nodiscard]] IndexRange<RodIndex> rods(FiberIndex fiber) const {
    return {rod_after(begin_node(fiber)), rod_after(last_node(fiber))};
  }
  /// The fiber that a node belongs to.
  [[nodiscard]] FiberIndex fiber_of(NodeIndex node) const {
    const auto next = std::upper_bound(first_node.begin(), first_node.end(), node);
    return FiberIndex(next - first_node.begin() - 1);
  }
  /// The inner nodes of a fiber.
  [[nodiscard]] IndexRange<NodeIndex> hinges(FiberIndex fiber) const {
    return {begin_node(fiber) + 1, last_node(fiber)};
  }

  /// The positions of a fiber's nodes.
  [[nodiscard]] std::span<const Vec3> positions(FiberIndex fiber) const {
    return {&position[begin_node(fiber)], static_cast<std::size_t>(nodes(fiber).size())};
  }
  /// From a rod's first end to its second.
  [[nodiscard]] Vec3 axis(RodIndex rod) const { return position[second_end(rod)] - position[first_end(rod)]; }
  [[nodiscard]] Vec3 centre(RodIndex rod) const {
    return 0.5 * (position[first_end(rod)] + position[second_end(rod)]);
  }
  [[nodiscard]] Segment segment(RodIndex rod) const {
    return {position[first_end(rod)], position[second_end(rod)]};
  }
};

}  // namespace fiberfate
