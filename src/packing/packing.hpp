// Packs fibers of any length into a cell: orientation as asked, no overlap, as little bending as possible.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/vector.hpp"
#include "fibers/state.hpp"
#include "microstructure/orientation_sampling.hpp"
#include "packing/packing_statistics.hpp"
#include "packing/population.hpp"

namespace fiberfate {

/// How the fibers lie before they are pushed apart.
enum class PackingStart {
  dispersed,   ///< straight fibers with centres anywhere in the cell
  bundles,     ///< parallel fibers in bundles, as pellets hold them; the bundles lie anywhere
  compressed,  ///< the published route: planar fibers at 2.5 % by volume whose cell is then compressed
};

/// Whether packings with this start keep the orientation that the request wants.
[[nodiscard]] constexpr bool holds_orientation(PackingStart start) {
  return start != PackingStart::compressed;
}

/// Asks for bundles of parallel fibers (PackingStart::bundles).
struct BundleRequest {
  int fibers = 19;               ///< in a bundle; 7, 19, 37, ... fill hexagons
  double volume_fraction = 0.6;  ///< of fibers inside a bundle, on a hexagonal lattice
};

/// Weighs what packing trades, against overlap, whose stiffness is 1: where not all can be had, more weight
/// means less of that error. docs/theory/packing.md has the energy.
struct PackingWeights {
  double curvature = 0.5;   ///< stiffness of the barrier on curvature, per E I / l³ of 1
  double orientation = 20;  ///< stiffness k of the couple k (A2 − A2*)·p that holds the orientation
};

/// Asks for directions: a tensor with the law that realises it, or measured directions.
struct OrientationRequest {
  Mat3 tensor = Mat3::Identity() / 3;  ///< A2, length-weighted
  OrientationDistribution law = OrientationDistribution::angular_central_gaussian;
  std::vector<Vec3> directions;  ///< where not empty: dealt to the fibers, and their moment replaces `tensor`
};

/// Asks for a packing.
struct PackingRequest {
  std::vector<FiberMaterial> materials;
  std::vector<FiberBlank> fibers;
  Cell cell;  ///< periodic, or with walls in some directions
  OrientationRequest orientation;
  PackingStart start = PackingStart::dispersed;
  BundleRequest bundle;
  PackingWeights weights;
  /// Distance in diameters from which fibers repel each other while they spread: more gives straighter
  /// fibers, but spaces them more evenly than chance (PackingReport::pair_distances shows by how much). 2.5
  /// to 4 at 20 % by volume.
  double swelling = 4;
  double minimum_radius = 0;             ///< smallest radius of curvature wanted, m; 0: no limit given
  double overlap_tolerance = 0.01;       ///< largest overlap allowed, in diameters
  double orientation_tolerance = 0.005;  ///< largest error allowed in any component of A2
  /// The law of contact under which the packing comes to rest: the one that will be run, taken for the
  /// thickest fiber (RestingContact).
  ContactParameters rest;
  int step_limit = 20000;  ///< most minimisation steps before giving up
  std::uint64_t seed = 1;
};

/// Reports how far a packing is.
struct PackingProgress {
  const char* stage = "";
  int step = 0;
  double largest_overlap = 0;    ///< in diameters
  double minimum_radius = 0;     ///< m
  double orientation_error = 0;  ///< largest component of |A2 − asked|
};

/// A packing and what is known of it.
struct PackingResult {
  FiberState state;  ///< fibers in the order of the request, wrapped into the cell, at rest
  PackingReport report;
};

/// Packs the fibers (docs/theory/packing.md). The result is bitwise the same for any number of threads.
///
/// Overlap, smallest radius and orientation are as asked; but the start `compressed` takes the orientation
/// that comes, and the report tells it. Then the packing is brought to rest under `rest`, without friction;
/// that equilibrium is returned where it meets all that was asked too, else the packing before; the report
/// tells which, and both. Raises InputError for requests that cannot be met by any packing, and
/// SimulationFailure with what was reached when none was found within the step limit.
[[nodiscard]] PackingResult pack(const PackingRequest& request,
                                 const std::function<void(const PackingProgress&)>& progress = {});

}  // namespace fiberfate
