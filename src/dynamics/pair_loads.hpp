// Adds the forces of pairs to the systems of eight fibers, side by side.
#pragma once

#include <vector>

#include "dynamics/pair_forces.hpp"

namespace fiberfate {

struct ChainGroup;

/// Lists, for every rod number k, what the k-th rods of eight fibers have of pair forces: slots of eight
/// numbers, one a fiber, 2 × force + (1 on the force's second rod), −1 for none.
class PairSlots {
 public:
  /// Collects the shares of a group's rods, in an order that no thread count changes.
  void collect(const PairForces& pairs, const ChainGroup& group);

  [[nodiscard]] int rod_count() const { return static_cast<int>(ends_.size()); }
  /// Slot number at which those of rod k end; those of the next one begin there.
  [[nodiscard]] const int* ends() const { return ends_.data(); }
  [[nodiscard]] const Index* numbers() const { return numbers_.data(); }

 private:
  std::vector<Index> numbers_;
  std::vector<int> ends_;
};

/// States what pair forces add to the records of eight fibers.
struct PairLoadQuery {
  double* records;            ///< of ChainSystem
  const double* position;     ///< m, by node
  const double* velocity;     ///< w about which forces are linearised, m/s, by node
  const double* numbers;      ///< RodNumber: of the group
  const PairForce* forces;    ///< of all pairs
  const Index* slot_numbers;  ///< PairSlots::numbers()
  const int* slot_ends;       ///< PairSlots::ends()
  int rods;                   ///< PairSlots::rod_count(): of the longest fiber
};

/// Adds the forces. The skin where rods touch moves with the rod's nodes at
///   v = (1 − s) w_k + s w_{k+1} + e M (w_{k+1} − w_k),   M = p nᵀ − (n·p) I,   e = ± d/2l
/// (+ on the first rod, − on the second), so nodes get the transposed shares of the force there. Turning
/// moves the skins along each other only: nᵀM = 0.
void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group);

}  // namespace fiberfate
