// Measures a packing: overlap, curvature, orientation, contacts and pair distances beside the theory of
// random rods.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vector.hpp"
#include "fibers/state.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Compares pairs of fibers at one range of axis distances with fibers placed at random.
struct PairDistanceBin {
  double low = 0;        ///< axis distance, in diameters
  double high = 0;       ///< in diameters
  double per_fiber = 0;  ///< places per fiber where another fiber passes at that distance
  double random = 0;     ///< the same expected of fibers of these directions placed at random
};

/// How a packing was left.
enum class PackingEnd {
  separated,  ///< without overlap, bent fibers held by nothing
  at_rest,    ///< in equilibrium of bending and contact under the law that will be run
};

/// What a packing was to be and what it is.
struct PackingReport {
  Mat3 orientation_asked = Mat3::Zero();    ///< A2, length-weighted
  Mat3 orientation_reached = Mat3::Zero();  ///< A2, length-weighted
  double orientation_error = 0;             ///< largest component of the difference
  /// A4 of the directions that were drawn: that of the law which was fitted to A2; length-weighted, 6×6 in
  /// the order 11, 22, 33, 23, 31, 12.
  Mat6 orientation4_drawn = Mat6::Zero();
  Mat6 orientation4_reached = Mat6::Zero();  ///< A4 of the rods
  double volume_fraction = 0;
  double largest_overlap = 0;     ///< in diameters; 0 when no fibers overlap
  double minimum_radius = 0;      ///< smallest radius of curvature, m; infinity when all are straight
  double mean_curvature = 0;      ///< mean over the hinges, 1/m
  double rms_curvature = 0;       ///< root of the mean square over the hinges, 1/m
  double sharp_hinges = 0;        ///< share of the hinges within 10 % of the smallest radius
  double contacts_per_fiber = 0;  ///< places where another fiber is nearer than 1.05 diameters
  double contacts_random = 0;     ///< the same expected of fibers placed at random (Toll 1993)
  std::vector<PairDistanceBin> pair_distances;
  PackingEnd end = PackingEnd::separated;
  double overlap_at_rest = 0;         ///< largest overlap in the equilibrium under the contact law, diameters
  double minimum_radius_at_rest = 0;  ///< smallest radius of curvature there, m
  int steps = 0;                      ///< minimisation steps
  double wall_seconds = 0;
};

/// Measures a packing; `asked` is the A2 that was wanted.
[[nodiscard]] PackingReport measure_packing(const FiberState& state, const Mat3& asked);

}  // namespace fiberfate
