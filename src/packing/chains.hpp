// The fibers while they are packed: chains of exactly inextensible rods, in units of the thickest
// diameter.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "fibers/cell.hpp"
#include "fibers/fiber_nodes.hpp"

namespace fiberfate {

/// Nodes and shapes as a struct of arrays. Unit of length: the diameter of the thickest fiber; unit of
/// stiffness: the contact stiffness of the first stage; every node has the mass 1.
struct Chains : FiberNodes {
  IndexedVector<NodeIndex, Vec3> velocity;
  IndexedVector<NodeIndex, Vec3> force;

  IndexedVector<FiberIndex, double> rod_length;  ///< of its rods, which are equal
  IndexedVector<FiberIndex, double> radius;
  IndexedVector<FiberIndex, double> bending_stiffness;  ///< E I / l³ over the unit of stiffness

  // 1 but for fibers that are being put in among others (Relief).
  IndexedVector<FiberIndex, double> swelling;  ///< multiplies the radius
  IndexedVector<FiberIndex, double> firmness;  ///< see RodRecord

  Cell cell;

  /// Length of a fiber.
  [[nodiscard]] double length(FiberIndex fiber) const { return rod_length[fiber] * rod_count(fiber); }
};

/// Eliminates the tridiagonal constraint matrix J Jᵀ of one chain, J_i = (−p_i at node i, +p_i at node i +
/// 1), p_i the unit vectors of its rods: diagonal 2, off-diagonal −p_i·p_{i+1}. Keeps its buffers from chain
/// to chain.
class ChainConstraints {
 public:
  /// Takes the rods of the chain at its present positions.
  void factorise(std::span<const Vec3> nodes, double rod_length);
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
