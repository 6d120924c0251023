// The fibers while they are packed: chains of exactly inextensible rods, in units of the thickest
// diameter.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vector.hpp"
#include "fibers/cell.hpp"

namespace fiberfate {

/// Nodes and shapes as a struct of arrays. Unit of length: the diameter of the thickest fiber; unit of
/// stiffness: the contact stiffness of the first stage; every node has the mass 1.
struct Chains {
  std::vector<Vec3> position;  ///< one entry a node, unwrapped
  std::vector<Vec3> velocity;
  std::vector<Vec3> force;

  std::vector<Index> first_node = {0};  ///< CSR offsets, fibers + 1 entries
  std::vector<double> rod_length;       ///< one entry a fiber: its rods are equal
  std::vector<double> radius;
  std::vector<double> bending_stiffness;  ///< E I / l³ over the unit of stiffness

  // 1 but for fibers that are being put in among others (Relief).
  std::vector<double> swelling;  ///< one entry a fiber: multiplies its radius
  std::vector<double> firmness;  ///< one entry a fiber: see RodRecord

  Cell cell;

  [[nodiscard]] std::ptrdiff_t fiber_count() const { return static_cast<std::ptrdiff_t>(rod_length.size()); }
  [[nodiscard]] std::size_t begin_node(std::size_t fiber) const {
    return static_cast<std::size_t>(first_node[fiber]);
  }
  [[nodiscard]] std::size_t end_node(std::size_t fiber) const {
    return static_cast<std::size_t>(first_node[fiber + 1]);
  }
};

/// Eliminates the tridiagonal constraint matrix J Jᵀ of one chain, J_i = (−p_i at node i, +p_i at node i +
/// 1), p_i the unit vectors of its rods: diagonal 2, off-diagonal −p_i·p_{i+1}. Keeps its buffers from chain
/// to chain.
class ChainConstraints {
 public:
  /// Takes the rods of the chain at its present positions.
  void factorise(const Vec3* position, std::size_t nodes, double rod_length);
  /// Removes from node vectors what would stretch the rods: f ← f − Jᵀ (J Jᵀ)⁻¹ J f.
  void project(Vec3* vectors);
  /// Restores the rod lengths of displaced positions along the factorised directions (two Newton
  /// corrections), leaving the chain's mean position as it is.
  void restore_lengths(Vec3* position, int corrections = 2);

 private:
  void solve();

  std::size_t rods_ = 0;
  double rod_length_ = 0;
  std::vector<Vec3> direction_;
  std::vector<double> reciprocal_pivot_, ratio_, unknown_;
};

}  // namespace fiberfate
