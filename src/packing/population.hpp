// Works out which fibers and which cell a concentration asks for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/vector.hpp"
#include "fibers/state.hpp"
#include "microstructure/length_distribution.hpp"

namespace fiberfate {

/// Describes one kind of fiber.
struct FiberSpecies {
  FiberMaterial material;
  LengthLaw length = SingleLength{};
  double rod_length = 0;    ///< target; every fiber is cut in equal rods nearest to it, m; 0: one rod a fiber
  double volume_share = 1;  ///< share of the fibers' volume, relative to the other species
};

/// Asks for an amount of fibers. One of count, volume_fraction and weight_fraction, and cell_size, or two of
/// count and a fraction; more is a contradiction.
struct ConcentrationRequest {
  std::optional<std::int64_t> count;
  std::optional<double> volume_fraction;
  std::optional<double> weight_fraction;  ///< needs the densities of fibers and matrix
  std::optional<Vec3> cell_size;          ///< edges, m
  double matrix_density = 0;              ///< kg/m³; only the weight fraction needs it
};

/// Describes one fiber to be made.
struct FiberBlank {
  double length = 0;              ///< m
  Index rods = 1;                 ///< equal rods
  std::uint16_t material_id = 0;  ///< index into the materials
};

/// What a concentration comes to.
struct Population {
  std::vector<FiberMaterial> materials;  ///< one a species
  std::vector<FiberBlank> fibers;
  Vec3 cell_size = Vec3::Zero();  ///< m
  double volume_fraction = 0;     ///< realised
};

/// Volume fraction of fibers from their weight fraction w: (w/ρ_f) / (w/ρ_f + (1 − w)/ρ_m).
[[nodiscard]] double volume_from_weight_fraction(double weight_fraction, double fiber_density,
                                                 double matrix_density);
/// Weight fraction of fibers from their volume fraction, the inverse of the above.
[[nodiscard]] double weight_from_volume_fraction(double volume_fraction, double fiber_density,
                                                 double matrix_density);

/// Density of all fibers together, by their shares of volume, kg/m³.
[[nodiscard]] double mean_density(const std::vector<FiberSpecies>& species);

/// Works out count, lengths, rods and cell. A fixed count with a fraction makes a cube that fits exactly. A
/// fixed cell rounds the count of every kind to the nearest fiber; then lengths that follow a histogram or a
/// smooth law change a little (L_N by less than 0.5 %) so that the volume is exact, while single and listed
/// lengths stay as they are and the volume is that of whole fibers. No rod is shorter than it is thick, and
/// nor is a fiber whose length follows a histogram or a smooth law. Raises InputError for contradictions and
/// for what cannot exist (a fraction beyond the densest packing of parallel rods, pi/sqrt(12) = 0.907),
/// saying what would be possible.
[[nodiscard]] Population plan_population(const std::vector<FiberSpecies>& species,
                                         const ConcentrationRequest& request, std::uint64_t seed);

}  // namespace fiberfate
