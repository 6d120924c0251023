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
  FiberIndex fiber;
  RodIndex rod;
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
  void refresh(const Chains& chains, FiberIndex fiber);
  [[nodiscard]] RepulsionInput input() const;
  /// Lists the rods near a rod.
  [[nodiscard]] std::vector<NeighbourRod> of(RodIndex rod) const;
  [[nodiscard]] SlotIndex slot(RodIndex rod) const { return slot_of_rod_[rod]; }
  [[nodiscard]] Index rod_count() const { return rods_; }
  /// Number of listed neighbours, every pair twice, without padding.
  [[nodiscard]] std::int64_t listed() const { return listed_; }

 private:
  struct ChunkLists;
  struct Candidates;
  /// Where and how far to look.
  struct Search {
    const Chains& chains;
    const NeighbourRange& range;
    const BoxGrid& grid;
  };
  /// A rod in an image of the cell.
  struct ImagedRod {
    SlotIndex slot;
    ImageIndex image;
  };
  void sort(const Chains& chains, BoxGrid& grid);
  void arrange(const Search& search);
  void number_images(const Search& search);
  void collect(const Search& search, SlotIndex subject, Candidates& candidates) const;
  [[nodiscard]] bool is_own_neighbour(const Search& search, SlotIndex subject, const ImagedRod& other) const;
  void keep_near(const NeighbourRange& range, SlotIndex subject, const Candidates& candidates,
                 ChunkLists& lists) const;
  void join(const std::vector<ChunkLists>& found);
  void list(const Search& search);
  [[nodiscard]] Vec3 shift_of(ImageIndex image) const { return Vec3(shifts_[image].shift); }

  Index rods_ = 0;
  std::int64_t listed_ = 0;
  IndexedVector<RodIndex, SlotIndex> slot_of_rod_;
  IndexedVector<RodIndex, Vec3> wrap_;  ///< displacement that brought the rod into the cell
  IndexedVector<SlotIndex, RodIndex> rod_of_slot_;
  IndexedVector<SlotIndex, FiberIndex> fiber_of_slot_;
  IndexedVector<SlotIndex, RodRecord> records_;         ///< one dummy more
  IndexedVector<SlotIndex, double> x_, y_, z_, reach_;  ///< when the lists were made; a pack more
  IndexedVector<SlotIndex, std::int32_t> begin_;        ///< of its neighbours in `rod_` and `image_`
  std::vector<SlotIndex> rod_;
  std::vector<ImageIndex> image_;
  IndexedVector<ImageIndex, ImageShift> shifts_;
};

}  // namespace fiberfate
