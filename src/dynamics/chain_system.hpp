// Lays out the linear systems of eight fibers side by side.
#pragma once

#include <cstddef>

#include "base/aligned_array.hpp"
#include "dynamics/pair_loads.hpp"

namespace fiberfate {

/// For eight fibers (lanes) with up to `nodes` nodes, the symmetric system in node velocities w and
/// tensions:
///   diagonal_k w_k + coupling_{k−1}ᵀ w_{k−1} + coupling_k w_{k+1} + second_{k−2} w_{k−2} + second_k w_{k+2}
///       − p_k λ_k + p_{k−1} λ_{k−1} = load_k
///   p_k · (w_{k+1} − w_k) + regular_k λ_k = stretch_k
/// Diagonal blocks are symmetric: xx, yy, zz, yz, zx, xy; couplings are stored by columns. A node of a lane
/// that has fewer nodes is an identity with no load. The storage is plain doubles, [node][component][lane],
/// because kernels of several instruction sets share it.
class ChainSystem {
 public:
  static constexpr int lanes = 8;
  /// First component of each part of a node's record, and the record's size.
  enum Component {
    diagonal = 0,
    coupling = 6,
    second = 15,
    load = 16,
    direction = 19,
    stretch = 22,
    regular = 23,
    size = 24
  };
  /// Size of what elimination keeps of a node for back substitution.
  static constexpr int kept = 28;

  /// Makes room for `nodes` nodes (grows only).
  void reserve(int nodes) {
    records_.reserve(std::size_t{lanes} * size * nodes);
    factors_.reserve(std::size_t{lanes} * kept * nodes);
  }
  [[nodiscard]] double* record(int node) { return records_.data() + std::ptrdiff_t{size * lanes} * node; }
  [[nodiscard]] double& at(int node, int component, int lane) {
    return record(node)[component * lanes + lane];
  }
  [[nodiscard]] double* factors() { return factors_.data(); }
  /// Scratch for the forces of pairs on the rods of the eight fibers.
  [[nodiscard]] PairSlots& slots() { return slots_; }

 private:
  AlignedArray records_;
  AlignedArray factors_;
  PairSlots slots_;
};

}  // namespace fiberfate
