// Moves packed chains downhill in energy: repulsion, bending, a barrier on curvature and a hold on
// orientation.
#pragma once

#include <functional>
#include <vector>

#include "base/vector.hpp"
#include "packing/chains.hpp"
#include "packing/rod_neighbours.hpp"
#include "packing/rod_repulsion.hpp"

namespace fiberfate {

/// The energy that is minimised (docs/theory/packing.md), in units of packing.
struct PackingEnergy {
  RepulsionLaw repulsion;
  double bending = 1;         ///< multiplies the fibers' own bending stiffness
  double barrier_radius = 0;  ///< hinges bent more sharply than this are straightened; 0: none
  double barrier = 1;         ///< stiffness of that, per E I / l³ of 1
  double orientation = 0;     ///< k of the couple k (A2 − A2*)·p on every rod
};

/// How far a minimisation is.
struct PackingMeasure {
  double largest_overlap = 0;  ///< in sums of two radii, of rods and walls; negative when none touch
  double largest_bend = 0;  ///< largest |x_{k+1} − 2 x_k + x_{k−1}| / l² = curvature, per unit of length
  double orientation_error = 0;  ///< largest component of |A2 − A2*|
  double mean_square_force = 0;  ///< per node, after projection
  double kinetic = 0;            ///< sum of v², per node
  double energy = 0;             ///< of repulsion, per node
};

/// Minimises by FIRE (Bitzek et al., PRL 97 (2006) 170201) under exactly inextensible rods. Bitwise the same
/// for any number of threads: loads are gathered by rod, sums run over fibers in order.
class Minimiser {
 public:
  Minimiser(Chains& chains, const Mat3& target) : chains_(chains), target_(target) { start(); }
  /// Takes another energy; velocities are kept.
  void use(const PackingEnergy& energy);
  /// Makes one step; the measure is that of the positions before it.
  PackingMeasure step();
  /// Measures the present positions without moving them.
  PackingMeasure measure();
  /// Lists neighbours anew: to be called after chains were put elsewhere or swollen.
  void forget_neighbours() { lists_valid_ = false; }
  /// Takes over that this fiber was shrunk, or made firmer or softer.
  void refresh(FiberIndex fiber) { neighbours_.refresh(chains_, fiber); }
  /// Largest overlap of a rod, in sums of two radii, as last measured.
  [[nodiscard]] double overlap(RodIndex rod) const { return loads_[neighbours_.slot(rod)].largest_overlap; }
  /// Lists the rods near a rod.
  [[nodiscard]] std::vector<NeighbourRod> near(RodIndex rod) const { return neighbours_.of(rod); }
  /// Brings all rods to their lengths to round-off.
  void finish();

 private:
  struct FiberSums {
    double power = 0, force = 0, speed = 0, bend = 0, overlap = -1, energy = 0, farthest = 0;
    Mat3 moment = Mat3::Zero();
  };
  void start();
  void renew_neighbours();
  void load_fibers();
  void add_moment(FiberIndex fiber, FiberSums& sums) const;
  void load(FiberIndex fiber, FiberSums& sums);
  void add_bending(FiberIndex fiber, FiberSums& sums);
  void add_walls(FiberIndex fiber, FiberSums& sums);
  PackingMeasure summarise() const;
  void steer(double power);
  void move_fibers(double force, double speed);
  /// Moves a fiber by its velocity, as load() left its constraints.
  void move(FiberIndex fiber, double keep, double follow);

  Chains& chains_;
  Mat3 target_;
  PackingEnergy energy_;
  RodNeighbours neighbours_;
  IndexedVector<SlotIndex, RepulsionLoad> loads_;
  IndexedVector<FiberIndex, FiberSums> sums_;
  IndexedVector<FiberIndex, ChainConstraints> constraints_;  ///< at the positions of the last load
  IndexedVector<NodeIndex, Vec3> listed_position_;
  Mat3 orientation_error_ = Mat3::Zero();
  double total_length_ = 0;
  NeighbourRange range_ = {1, 0, 1};
  int list_age_ = 0;
  bool lists_valid_ = false;

  double step_size_ = 0, largest_step_size_ = 0, mixing_ = 0;
  int downhill_ = 0;
};

}  // namespace fiberfate
