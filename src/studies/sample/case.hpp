// The choices about the fibers at the start that the studies cluster and shear_cell share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "dynamics/parameters.hpp"
#include "fibers/cell.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"
#include "packing/packing.hpp"
#include "packing/population.hpp"
#include "studies/sample/fiber_kind.hpp"

namespace fiberfate {

/// A [[fibers.more_kinds]]: one more kind of fibers in the same cell.
struct FurtherKind : FiberKind {
  double volume_share = 0;  ///< volume of these fibers, relative to that of the first kind
};

/// [fibers]: what they are and how many.
struct FiberChoices : FiberKind {
  std::optional<std::int64_t> count;
  std::optional<double> volume_fraction;
  std::optional<double> weight_fraction;
  std::vector<FurtherKind> more_kinds;
};

/// Where the fibers come from.
enum class ClusterSource {
  generate,  ///< packed with the wanted orientation
  fiber,     ///< one straight fiber in the middle of the cell
  file,      ///< checkpoint.h5, fibers.csv or Initial_Positions.txt
};

/// [cluster]: how the fibers lie at the start. The names are those of PackingRequest.
struct ClusterChoices {
  ClusterSource source = ClusterSource::generate;
  std::string file;                         ///< of source = "file"; absolute
  std::optional<Vec3> direction;            ///< of source = "fiber"; of any length but zero
  Mat3 orientation = Mat3::Identity() / 3;  ///< wanted A2, length-weighted
  OrientationDistribution law = OrientationDistribution::angular_central_gaussian;
  std::vector<std::vector<double>>
      directions;  ///< rows of measured directions; where not empty, instead of A2
  PackingStart start = PackingStart::dispersed;
  BundleRequest bundle;
  PackingWeights weights;
  double swelling = PackingRequest{}.swelling;  ///< in diameters
  double minimum_radius =
      PackingRequest{}.minimum_radius;  ///< smallest radius of curvature wanted, m; 0: none
  double overlap_tolerance = PackingRequest{}.overlap_tolerance;          ///< in diameters
  double orientation_tolerance = PackingRequest{}.orientation_tolerance;  ///< in any component of A2
  int step_limit = PackingRequest{}.step_limit;
};

/// [matrix].
struct MatrixChoices {
  std::optional<double> density;  ///< kg/m³
};

/// [cell].
struct CellChoices {
  std::optional<Vec3> size;  ///< m
};

/// Everything about the fibers at the start.
struct SampleCase {
  FiberChoices fibers;
  MatrixChoices matrix;
  CellChoices cell;
  ClusterChoices cluster;
};

/// [boundary]: how the cell ends.
struct BoundaryChoices {
  Boundary y = Boundary::periodic;
};

/// Adds the keys of [fibers], [fibers.length_histogram], [matrix], [cell] and [cluster].
void describe_sample(KeyTable& table, SampleCase& sample);
/// The keys of [contact] that a packing at rest obeys too: force_constant, decay, cutoff, ramp.
[[nodiscard]] KeyRows<ContactParameters> contact_law_rows();

/// The materials of all kinds.
[[nodiscard]] std::vector<FiberMaterial> materials(const SampleCase& sample);

/// Finds what contradicts what.
void validate_sample(const SampleCase& sample, CaseChecker& checker);

/// What plan_population() gets of a valid sample (source "generate"): the kinds of fibers, at least
/// one.
[[nodiscard]] std::vector<FiberSpecies> species(const SampleCase& sample);
[[nodiscard]] ConcentrationRequest concentration(const SampleCase& sample);
/// What pack() gets of a valid sample, but for the fibers and the cell, which plan_population() works
/// out.
[[nodiscard]] PackingRequest packing_request(const SampleCase& sample, const ContactParameters& contact,
                                             std::uint64_t seed);
/// Makes the state of a sample with source "fiber": the fiber lies in the middle of the cell, which is four
/// fiber lengths wide unless the case gives its size, so that the fiber never meets its own image.
[[nodiscard]] FiberState single_fiber(const SampleCase& sample);

/// What follows from a sample, as far as it can be known before packing.
struct SamplePlan {
  std::int64_t fibers = 0;
  std::int64_t rods = 0;
  Vec3 cell_size = Vec3::Zero();          ///< m
  double volume_fraction = 0;             ///< that whole fibers make
  std::optional<double> weight_fraction;  ///< where both densities are known
};
/// Works out the plan of a valid sample; nothing for source "file".
[[nodiscard]] std::optional<SamplePlan> plan_sample(const SampleCase& sample, std::uint64_t seed);

}  // namespace fiberfate
