// The forces of contacts, each once for the two rods that it acts on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "dynamics/contact_set.hpp"

namespace fiberfate {

/// The force of one contact, linearised about the velocities w_old with which it was evaluated, each
/// side in its own velocity: at x_1 = (1 − s) x_i + s x_{i+1} of the first rod act
///   force − R (w − w_old),   R = along n nᵀ + across (I − n nᵀ)
/// and at x_2 of the second, place t, −force − R (w − w_old). Both rods also get the couple −(d/2) n × force,
/// because they touch midway between the axes; its part along a rod's axis, which would spin the rod, is
/// taken up by the fiber's torsion, which the model does not follow. Both sides use the same resistances, and
/// at w = w_old they drop out.
///
/// Plain numbers, because kernels of several instruction sets write it.
struct PairForce {
  double force[3];   ///< on the first rod, N
  double normal[3];  ///< unit vector from the second rod to the first
  double s;          ///< place on the first rod, in [0, 1]
  double t;          ///< place on the second rod, in [0, 1]
  double distance;   ///< of the axes, m
  double along;      ///< N s/m
  double across;     ///< N s/m
};

/// The forces of all contacts, and for every rod its shares of them.
class PairForces {
 public:
  /// What one rod has of a force.
  struct Share {
    std::int64_t key;  ///< orders the shares of a rod: who exerts it (rod, then image seen from this one)
    Index number;      ///< 2 × force, + 1 on the force's second rod

    /// The rod that exerts it.
    [[nodiscard]] RodIndex other() const { return RodIndex(key >> image_bits); }
  };
  static constexpr int image_bits = 30;  ///< of a key

  /// Deals the forces of contacts, chunk after chunk, to the rods of a state with `nodes` nodes. Each rod's
  /// shares are ordered by key, so that sums over them always round alike.
  void deal(const ContactSet& contacts, Index nodes);
  [[nodiscard]] std::span<PairForce> forces() { return forces_; }
  [[nodiscard]] std::span<const PairForce> forces() const { return forces_; }
  /// Number of the first force of every chunk of contacts, and of all forces at the end.
  [[nodiscard]] std::span<const Index> chunk_begin() const { return chunk_begin_; }

  [[nodiscard]] std::span<const Share> of_rod(RodIndex rod) const {
    return {shares_.data() + begin_[rod].value(), shares_.data() + begin_[rod + 1].value()};
  }

 private:
  using ShareIndex = IndexOf<struct ShareTag>;
  using RodCursors = IndexedVector<RodIndex, ShareIndex>;
  /// Consecutive chunks of contacts.
  struct Chunks {
    std::ptrdiff_t begin, end;
  };

  void count_forces(const ContactSet& contacts);
  [[nodiscard]] Chunks chunks_of(std::size_t dealer) const;
  void count_shares(const ContactSet& contacts, std::size_t dealer, Index nodes);
  void begin_shares(Index nodes);
  void place_shares(const ContactSet& contacts, std::size_t dealer);
  void sort_shares();

  std::vector<PairForce> forces_;
  std::vector<Index> chunk_begin_;
  IndexedVector<ShareIndex, Share> shares_;  // rod after rod
  RodCursors begin_;                         // of each rod's shares
  // Of every dealer (a thread, with a share of the chunks), by rod: how many shares it deals, then where the
  // next one goes.
  std::vector<RodCursors> next_;
  std::vector<Index> part_begin_;  // of the shares of each thread's part of the rods
};

}  // namespace fiberfate
