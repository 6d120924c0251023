// Holds the choices about a population of fibers that the studies cluster and shear_cell share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/case_checker.hpp"
#include "app/key_table.hpp"
#include "base/vector.hpp"

namespace fiberfate {

/// Holds [fibers]: what they are and how many.
struct FiberChoices {
  std::optional<double> length;                       ///< of every fiber, m
  std::vector<std::vector<double>> length_histogram;  ///< rows (length m, share of the fibers by number)
  double diameter = 0;                                ///< m
  double youngs_modulus = 0;                          ///< Pa
  std::optional<double> density;                      ///< kg/m³
  double rod_length = 0;  ///< wanted, m; a fiber has round(length/rod_length) rods
  std::optional<std::int64_t> count;
  std::optional<double> volume_fraction;
  std::optional<double> weight_fraction;
};

/// Names where the fibers come from.
enum class ClusterSource {
  generate,  ///< packed with the wanted orientation, then relaxed
  fiber,     ///< one straight fiber in the middle of the cell
  file,      ///< checkpoint.h5, fibers.csv or Initial_Positions.txt
};

/// Names how orientations are drawn.
enum class OrientationMethod {
  gaussian,     ///< angular central Gaussian fitted to the tensor: smooth
  subclusters,  ///< mixture of isotropic, planar and aligned fibers (thesis section 3.2.1)
};

/// Holds [cluster]: how the fibers lie at the start.
struct ClusterChoices {
  ClusterSource source = ClusterSource::generate;
  std::string file;                         ///< of source = "file"; absolute
  std::optional<Vec3> direction;            ///< of source = "fiber"; any length
  Mat3 orientation = Mat3::Identity() / 3;  ///< wanted A2, length-weighted
  OrientationMethod method = OrientationMethod::gaussian;
  double maximum_overlap = 0.02;  ///< (a_i + a_j − d)/a at which relaxation is content, in radii
  std::optional<double>
      minimum_radius;     ///< no hinge is bent below this, m; not given: as the overlap demands
  double swelling = 2.5;  ///< effective diameter of the swollen stage, in diameters; 1: no such stage
  std::int64_t iterations = 3000;  ///< most iterations of relaxation
};

/// Holds everything about the fibers at the start.
struct Population {
  FiberChoices fibers;
  std::optional<double> matrix_density;  ///< [matrix] density, kg/m³
  std::optional<Vec3> cell_size;         ///< [cell] size, m
  ClusterChoices cluster;
};

/// Holds what follows from a population: of count, fraction and cell two fix the third.
struct PopulationPlan {
  std::int64_t count = 0;
  Vec3 cell_size = Vec3::Zero();          ///< m
  double volume_fraction = 0;             ///< that `count` whole fibers make in the cell
  std::optional<double> weight_fraction;  ///< where both densities are known
  double mean_length = 0;                 ///< by number, m
  std::int64_t rods = 0;                  ///< of all fibers
};

/// Adds the keys of [fibers], [matrix], [cell] and [cluster].
void describe_population(KeyTable& table, Population& population);

/// Finds what contradicts what.
void validate_population(const Population& population, CaseChecker& checker);

/// Works out count, cell and fractions of a valid population whose source is not a file.
/// A volume fraction with a count gives a cubic cell; with a cell it gives the nearest whole number of
/// fibers.
[[nodiscard]] PopulationPlan plan_population(const Population& population);

/// Tells how many rods a fiber of this length gets: round(length / rod_length), at least 1.
[[nodiscard]] std::int64_t rods_of(double length, double rod_length);

}  // namespace fiberfate
