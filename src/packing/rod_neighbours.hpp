// Finds the rods near each rod in a periodic or walled cell and keeps the records that the repulsion kernels
// read.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vector.hpp"
#include "packing/box_grid.hpp"
#include "packing/chains.hpp"
#include "packing/rod_repulsion.hpp"

namespace fiberfate {

/// A rod near another one.
struct NeighbourRod {
  std::size_t fiber = 0;
  std::size_t node = 0;       ///< where it begins
  Vec3 shift = Vec3::Zero();  ///< to be added to its nodes to bring it near
};

/// Lists rod pairs. Rods are kept in slots sorted by place, so that neighbours are near in memory.
///
/// Rods of one fiber that are nearer along it than twice the contact distance are not listed with each other
/// (they could only touch by bending more sharply than any packing does); images of its own are.
class RodNeighbours {
 public:
  /// Sorts and lists the rods at their present positions.
  void build(const Chains& chains, const NeighbourRange& range);
  /// Writes the records of a fiber's rods from its nodes; to be called after it moved.
  void refresh(const Chains& chains, std::size_t fiber);
  [[nodiscard]] RepulsionInput input() const;
  /// Lists the rods near the one that begins at this node.
  [[nodiscard]] std::vector<NeighbourRod> of(std::size_t node) const;
  [[nodiscard]] std::size_t slot(std::size_t node) const {
    return static_cast<std::size_t>(slot_of_node_[node]);
  }
  [[nodiscard]] std::ptrdiff_t rod_count() const { return static_cast<std::ptrdiff_t>(rods_); }
  /// Number of listed neighbours, every pair twice, without padding.
  [[nodiscard]] std::int64_t listed() const { return listed_; }

 private:
  struct ChunkLists;
  struct Candidates;
  struct ImagedRod {
    std::size_t slot;
    std::int32_t image;
  };
  void sort(const Chains& chains, BoxGrid& grid);
  void arrange(const Chains& chains, const NeighbourRange& range, const BoxGrid& grid);
  void collect(const Chains& chains, const NeighbourRange& range, const BoxGrid& grid, std::size_t subject,
               Candidates& candidates) const;
  [[nodiscard]] bool is_own_neighbour(const Chains& chains, const NeighbourRange& range, std::size_t subject,
                                      const ImagedRod& other) const;
  void keep_near(const NeighbourRange& range, std::size_t subject, const Candidates& candidates,
                 ChunkLists& lists) const;
  void join(const std::vector<ChunkLists>& found);
  void list(const Chains& chains, const NeighbourRange& range, const BoxGrid& grid);

  std::size_t rods_ = 0;
  std::int64_t listed_ = 0;
  std::vector<std::int32_t> slot_of_node_;
  std::vector<Vec3> wrap_;  ///< by node: displacement that brought the rod into the cell
  std::vector<std::int32_t> node_of_slot_, fiber_of_slot_;
  std::vector<RodRecord> records_;         ///< by slot; one dummy more
  std::vector<double> x_, y_, z_, reach_;  ///< by slot, when the lists were made; a pack more
  std::vector<std::int32_t> begin_, rod_, image_;
  std::vector<ImageShift> shifts_;
};

}  // namespace fiberfate
