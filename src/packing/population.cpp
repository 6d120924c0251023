// Works out which fibers and which cell a concentration asks for.
#include "packing/population.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "packing/densest_fraction.hpp"

namespace fiberfate {
namespace {

// A cell holds at least this many fibers when it is chosen for them.
constexpr double memory_limit_fibers = 2e8;

double section(const FiberSpecies& species) {
  return pi * species.material.radius * species.material.radius;
}

double total_share(const std::vector<FiberSpecies>& species) {
  return std::accumulate(species.begin(), species.end(), 0.0,
                         [](double sum, const FiberSpecies& one) { return sum + one.volume_share; });
}

void require_species(const std::vector<FiberSpecies>& species) {
  if (species.empty()) throw InputError("no fibers are described", "give at least one kind of fiber");
  for (const FiberSpecies& one : species) {
    if (!(one.material.radius > 0)) throw InputError("a fiber has no diameter", "give a diameter above zero");
    if (!(one.volume_share > 0))
      throw InputError(fmt::format("a kind of fiber has the volume share {:.4g}", one.volume_share),
                       "give shares above zero, or leave that kind out");
    require_admissible(one.length);
  }
}

void require_fraction(double fraction, const char* what) {
  if (!(fraction > 0) || !(fraction < 1))
    throw InputError(fmt::format("the {} is {:.4g}", what, fraction), "give a number between 0 and 1");
}

double requested_fraction(const std::vector<FiberSpecies>& species, const ConcentrationRequest& request) {
  double fraction = 0;
  if (request.volume_fraction) {
    require_fraction(*request.volume_fraction, "volume fraction");
    fraction = *request.volume_fraction;
  } else {
    require_fraction(*request.weight_fraction, "weight fraction");
    const double density = mean_density(species);
    if (!(density > 0) || !(request.matrix_density > 0))
      throw InputError("a weight fraction is given without the densities",
                       "give the densities of fibers and matrix, or the volume fraction");
    fraction = volume_from_weight_fraction(*request.weight_fraction, density, request.matrix_density);
  }
  if (fraction >= densest_parallel)
    throw InputError(
        fmt::format("a volume fraction of fibers of {:.4g} does not exist", fraction),
        fmt::format("even parallel fibers fill at most {:.4g} (pi / sqrt 12)", densest_parallel));
  return fraction;
}

void require_two(const ConcentrationRequest& request) {
  const bool fraction = request.volume_fraction || request.weight_fraction;
  if (request.volume_fraction && request.weight_fraction)
    throw InputError("both a volume fraction and a weight fraction are given", "give one of them");
  const int given = (request.count ? 1 : 0) + (fraction ? 1 : 0) + (request.cell_size ? 1 : 0);
  if (given == 3)
    throw InputError("count, fraction and cell size of the fibers are all given",
                     "two of them fix the third: leave one out");
  if (given < 2)
    throw InputError("the amount of fibers is not fixed",
                     "give two of: count, volume or weight fraction, cell size");
  if (request.count && *request.count < 1)
    throw InputError(fmt::format("the number of fibers is {}", *request.count), "give at least 1");
}

void require_room(const Vec3& size, const std::vector<FiberSpecies>& species) {
  double thickest = 0;
  for (const FiberSpecies& one : species) thickest = std::max(thickest, one.material.diameter());
  // A fiber and its own image keep their distance only in a cell of two diameters.
  if (!(size.minCoeff() >= 2 * thickest))
    throw InputError(fmt::format("an edge of the cell is {:.4g} m", size.minCoeff()),
                     fmt::format("give at least two fiber diameters, {:.4g} m", 2 * thickest));
}

/// Fibers of one kind in a volume of that kind's fibers: to the nearest fiber.
std::int64_t count_in(double volume, const FiberSpecies& species) {
  const double count = volume / (section(species) * number_average(species.length));
  if (count > memory_limit_fibers)
    throw InputError(fmt::format("the cell would hold {:.3g} fibers", count),
                     fmt::format("at most {:.1g} are possible: make the cell smaller", memory_limit_fibers));
  return std::llround(count);
}

/// Shares a number of fibers out to the kinds by their numbers (volume share over fiber volume), to one fiber
/// each.
std::vector<std::int64_t> share_out(std::int64_t count, const std::vector<FiberSpecies>& species) {
  std::vector<double> numbers;
  for (const FiberSpecies& one : species)
    numbers.push_back(one.volume_share / (section(one) * number_average(one.length)));
  const double total = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  std::vector<std::int64_t> counts;
  double reached = 0;
  std::int64_t given = 0;
  for (const double number : numbers) {
    reached += number / total;
    const std::int64_t upto = std::llround(reached * static_cast<double>(count));
    counts.push_back(upto - given);
    given = upto;
  }
  return counts;
}

/// Works out for each kind how many fibers there are, and what a given cell needs their lengths to sum up to.
std::vector<LengthRequest> lengths_of(const std::vector<FiberSpecies>& species,
                                      const ConcentrationRequest& request, std::uint64_t seed) {
  std::vector<LengthRequest> lengths;
  if (request.count) {
    for (const std::int64_t count : share_out(*request.count, species))
      lengths.push_back(
          {static_cast<std::size_t>(count), seed++, {}, species[lengths.size()].material.diameter()});
    return lengths;
  }
  const double volume = requested_fraction(species, request) * request.cell_size->prod();
  std::size_t fibers = 0;
  for (const FiberSpecies& one : species) {
    const double own = volume * one.volume_share / total_share(species);
    lengths.push_back(
        {static_cast<std::size_t>(count_in(own, one)), seed++, own / section(one), one.material.diameter()});
    fibers += lengths.back().count;
  }
  if (fibers == 0)
    throw InputError("the cell would hold no fiber", "make the cell larger or the fraction higher");
  return lengths;
}

/// Rods nearest to the target, but none shorter than it is thick.
Index rods_of(double length, const FiberSpecies& species) {
  const auto most = static_cast<Index>(length / species.material.diameter());
  return std::max<Index>(1, std::min<Index>(most, rods_for(length, species.rod_length)));
}

}  // namespace

double volume_from_weight_fraction(double weight_fraction, double fiber_density, double matrix_density) {
  const double fibers = weight_fraction / fiber_density;
  return fibers / (fibers + (1 - weight_fraction) / matrix_density);
}

double weight_from_volume_fraction(double volume_fraction, double fiber_density, double matrix_density) {
  const double fibers = volume_fraction * fiber_density;
  return fibers / (fibers + (1 - volume_fraction) * matrix_density);
}

double mean_density(const std::vector<FiberSpecies>& species) {
  double mass = 0;
  for (const FiberSpecies& one : species) mass += one.volume_share * one.material.density;
  return mass / total_share(species);
}

Population plan_population(const std::vector<FiberSpecies>& species, const ConcentrationRequest& request,
                           std::uint64_t seed) {
  require_species(species);
  require_two(request);
  if (request.cell_size) require_room(*request.cell_size, species);
  const std::vector<LengthRequest> lengths = lengths_of(species, request, seed);

  Population population;
  double volume = 0;
  for (std::size_t s = 0; s < species.size(); ++s) {
    population.materials.push_back(species[s].material);
    for (const double length : sample_lengths(species[s].length, lengths[s])) {
      population.fibers.push_back({length, rods_of(length, species[s]), static_cast<std::uint16_t>(s)});
      volume += section(species[s]) * length;
    }
  }
  population.cell_size = request.cell_size
                             ? *request.cell_size
                             : Vec3(Vec3::Constant(std::cbrt(volume / requested_fraction(species, request))));
  require_room(population.cell_size, species);
  population.volume_fraction = volume / population.cell_size.prod();
  if (population.volume_fraction >= densest_parallel)
    throw InputError(
        fmt::format("{} fibers fill {:.4g} of the cell", population.fibers.size(),
                    population.volume_fraction),
        fmt::format("even parallel fibers fill at most {:.4g} (pi / sqrt 12)", densest_parallel));
  return population;
}

}  // namespace fiberfate
