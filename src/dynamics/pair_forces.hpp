// Holds the forces of contacts, each once for the two rods that it acts on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "dynamics/contact_set.hpp"

namespace fiberfate {

/// Holds the force of one contact, linearised about the velocities w_old with which it was evaluated, each
/// side in its own velocity: at x_1 = (1 − s) x_i + s x_{i+1} of the first rod act
///   force − R (w − w_old),   R = along n nᵀ + across (I − n nᵀ)
/// and at x_2 of the second, place t, −force − R (w − w_old). Both rods also get the couple −(d/2) n × force,
/// because they touch midway between the axes; its part along a rod's axis, which would spin the rod, is
/// taken up by the fiber's torsion, which the model does not follow. Resistances are in single precision:
/// they only bound how the force changes, both sides use the same numbers, and at w = w_old they drop out.
///
/// Plain numbers, because kernels of several instruction sets write it.
struct PairForce {
  double force[3];   ///< on the first rod, N
  double normal[3];  ///< unit vector from the second rod to the first
  double s;          ///< place on the first rod, in [0, 1]
  double t;          ///< place on the second rod, in [0, 1]
  double distance;   ///< of the axes, m
  float along;       ///< N s/m
  float across;      ///< N s/m
  Index first;
  Index second;
  std::int32_t image;  ///< of the second rod, packed
};

/// Holds the forces of all contacts and finds those of a rod.
class PairForces {
 public:
  /// Names what one rod has of a force.
  struct Share {
    std::int64_t key;  ///< orders the shares of a rod
    Index force;
    bool is_first;  ///< which of the force's rods this is
  };

  /// Makes room for so many forces on the rods of a state with `nodes` nodes.
  void reset(Index nodes, Index forces);
  [[nodiscard]] std::span<PairForce> forces() { return forces_; }
  [[nodiscard]] std::span<const PairForce> forces() const { return forces_; }
  /// Tells the rods of a chunk of contacts that the forces from `begin` on act on them; any thread may do so.
  void link(Index begin, const ContactChunk& contacts);

  /// Asks the memory for what of_rod() will read of a rod.
  void fetch(Index rod) const {
    const Index head = head_[static_cast<std::size_t>(rod)];
    if (head >= 0) __builtin_prefetch(&links_[static_cast<std::size_t>(head)]);
  }
  /// Appends the shares of a rod, ordered by who exerts them (rod, then image seen from this one): sums over
  /// them always round alike.
  void of_rod(Index rod, std::vector<Share>& shares) const;

 private:
  /// Joins a share to the next one of the same rod.
  struct Link {
    std::int64_t key;
    Index next;  ///< −1 ends a chain
  };

  std::vector<PairForce> forces_;
  // Every force is in two chains, one a rod: shares are numbered 2 × force, + 1 for the second rod.
  std::vector<Index> head_;  // by rod: its first share
  std::vector<Link> links_;  // by share
};

}  // namespace fiberfate
