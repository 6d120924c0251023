// Checks the choices about the fibers at the start.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "packing/bundles.hpp"
#include "packing/densest_fraction.hpp"
#include "packing/drawn_directions.hpp"
#include "studies/sample/case.hpp"

namespace fiberfate {
namespace {

constexpr double most_rods = 1e8;  ///< a population of 10⁸ rods needs some 200 GB
constexpr double fewest_diameters_a_cell =
    4;  ///< an edge; below it a rod would meet its own image everywhere

const std::vector<std::string> amount_keys = {"fibers.count", "fibers.volume_fraction",
                                              "fibers.weight_fraction"};

// What only a cluster that is generated reads.
const std::vector<std::string> packing_keys = {"cluster.orientation",       "cluster.law",
                                               "cluster.directions",        "cluster.start",
                                               "cluster.bundle_fibers",     "cluster.bundle_fraction",
                                               "cluster.curvature_weight",  "cluster.orientation_weight",
                                               "cluster.swelling",          "cluster.minimum_radius",
                                               "cluster.overlap_tolerance", "cluster.orientation_tolerance",
                                               "cluster.step_limit"};

std::vector<std::string> given_of(const std::vector<std::string>& keys, const CaseChecker& checker) {
  std::vector<std::string> given;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(given),
               [&checker](const std::string& key) { return checker.is_given(key); });
  return given;
}

/// Demands two of amount and cell, and no more.
void validate_concentration(CaseChecker& checker) {
  const std::vector<std::string> amounts = given_of(amount_keys, checker);
  const bool cell = checker.is_given("cell.size");
  const std::size_t given = amounts.size() + (cell ? 1 : 0);
  const bool both_fractions =
      checker.is_given("fibers.volume_fraction") && checker.is_given("fibers.weight_fraction");
  if (given > 2 || both_fractions) {
    std::vector<std::string> others;
    for (std::size_t i = 0; i + 1 < amounts.size(); ++i) others.push_back(checker.cite(amounts[i]));
    if (cell) others.push_back(checker.cite("cell.size"));
    checker.error(amounts.back(), fmt::format("contradicts {}", fmt::join(others, " and ")),
                  "remove all but two of number, fraction and cell; the third follows from them");
  } else if (amounts.empty()) {
    checker.error("fibers.count", "not given, and no fraction either",
                  "add count, volume_fraction or weight_fraction under [fibers]");
    if (!cell) checker.require("cell.size", "fibers need a cell", "\"1.5 mm\"");
  } else if (given < 2) {
    const bool count = amounts.front() == "fibers.count";
    checker.error(amounts.front(), "does not fix the cell by itself",
                  count ? "add size under [cell], or a fraction under [fibers]"
                        : "add size under [cell], or count under [fibers]");
  }
}

/// The name of the table of a further kind (from 0).
std::string kind_table(std::size_t kind) {
  return KeyTable::repeated_name("fibers.more_kinds", kind);
}

void validate_densities(const SampleCase& sample, CaseChecker& checker) {
  if (!checker.is_given("fibers.weight_fraction")) {
    const std::string both = "a weight fraction with both densities";
    if (sample.fibers.density && !checker.is_given("matrix.density"))
      checker.warn_unused({"fibers.density"}, both);
    if (sample.matrix.density && !checker.is_given("fibers.density"))
      checker.warn_unused({"matrix.density"}, both);
    return;
  }
  const std::string why = "fibers.weight_fraction needs it";
  checker.require("fibers.density", why, "\"2550 kg/m3\"");
  for (std::size_t i = 0; i < sample.fibers.more_kinds.size(); ++i)
    checker.require(kind_table(i) + ".density", why, "\"1800 kg/m3\"");
  checker.require("matrix.density", why, "\"905 kg/m3\"");
}

void validate_cell(const SampleCase& sample, CaseChecker& checker) {
  if (!sample.cell.size) return;
  std::string table = "fibers";
  double thickest = sample.fibers.diameter;
  for (std::size_t i = 0; i < sample.fibers.more_kinds.size(); ++i) {
    if (sample.fibers.more_kinds[i].diameter <= thickest) continue;
    thickest = sample.fibers.more_kinds[i].diameter;
    table = kind_table(i);
  }
  if (sample.cell.size->minCoeff() < fewest_diameters_a_cell * thickest)
    checker.error("cell.size",
                  fmt::format("the cell is hardly wider than a fiber, {}", checker.cite(table + ".diameter")),
                  fmt::format("give edges of at least {} diameters", fewest_diameters_a_cell));
}

/// About how many rods a sample has, without making them.
double expected_rods(const SampleCase& sample) {
  const FiberChoices& fibers = sample.fibers;
  const double rod = fibers.rod_length.value_or(fibers.diameter);
  if (fibers.count)
    return static_cast<double>(*fibers.count) *
           std::max(1.0, number_average(length_law(sample.fibers)) / rod);
  const std::vector<FiberSpecies> kinds = species(sample);
  const double fraction =
      fibers.volume_fraction
          ? *fibers.volume_fraction
          : volume_from_weight_fraction(*fibers.weight_fraction, mean_density(kinds), *sample.matrix.density);
  double shares = 0, rods = 0;
  for (const FiberSpecies& kind : kinds) {
    const double radius = kind.material.radius;
    shares += kind.volume_share;
    rods += kind.volume_share / (pi * radius * radius * kind.rod_length);
  }
  return fraction * sample.cell.size->prod() * rods / shares;
}

/// Finds what packing would refuse: fibers too few for their orientation, bundles too thick for their cell.
void validate_packing(const SampleCase& sample, const Population& population, const std::string& blamed,
                      CaseChecker& checker) {
  constexpr std::size_t surely_enough = 1000;  // for any orientation
  PackingRequest request = packing_request(sample, {}, 1);
  request.materials = population.materials;
  request.fibers = population.fibers;
  request.cell = rectangular_cell(population.cell_size);
  if (request.start != PackingStart::bundles) {
    if (request.fibers.size() < surely_enough)
      checker.report_at(blamed, [&request] { static_cast<void>(draw_directions(request)); });
    return;
  }
  const std::string key = "cluster.bundle_fibers";
  checker.report_at(key, [&] { request = plan_bundles(request).bundles; });
  if (!checker.is_sound(key) || request.fibers.size() >= surely_enough) return;
  try {
    static_cast<void>(draw_directions(request));
  } catch (const InputError&) {
    checker.error(
        key, fmt::format("{} bundles cannot have the orientation that is asked for", request.fibers.size()),
        "put fewer fibers into a bundle, or ask for more fibers");
  }
}

/// Works the plan out, so that what cannot exist is found now.
void validate_plan(const SampleCase& sample, CaseChecker& checker) {
  if (!checker.is_sound()) return;
  const std::string blamed = given_of(amount_keys, checker).back();
  const double rods = expected_rods(sample);
  if (rods > most_rods) {
    checker.error(blamed, fmt::format("makes {:.2g} rods, more than sensible", rods),
                  "take a smaller cell, fewer fibers or longer rods");
    return;
  }
  checker.report_at(blamed, [&] {
    const Population population = plan_population(species(sample), concentration(sample), 1);
    const double densest = densest_fraction(sample.cluster.orientation);
    if (holds_orientation(sample.cluster.start) && sample.cluster.directions.empty() &&
        population.volume_fraction >= densest)
      checker.error(blamed,
                    fmt::format("the fibers fill {:.4g} of the cell, and with {} they fill at most {:.4g}",
                                population.volume_fraction, checker.cite("cluster.orientation"), densest),
                    "lower the concentration, or align the fibers");
    else
      validate_packing(sample, population, blamed, checker);
  });
}

void validate_directions(const ClusterChoices& cluster, CaseChecker& checker) {
  for (std::size_t i = 0; i < cluster.directions.size(); ++i) {
    const std::vector<double>& row = cluster.directions[i];
    if (std::any_of(row.begin(), row.end(), [](double component) { return component != 0; })) continue;
    checker.error_in_row("cluster.directions", i, fmt::format("the direction in row {} has no length", i + 1),
                         "give components that are not all zero");
  }
}

void validate_start(const ClusterChoices& cluster, CaseChecker& checker) {
  if (cluster.start != PackingStart::bundles)
    checker.warn_unused({"cluster.bundle_fibers", "cluster.bundle_fraction"}, "cluster.start = \"bundles\"");
  if (cluster.start == PackingStart::compressed)
    checker.warn_unused({"cluster.directions", "cluster.orientation_weight", "cluster.orientation_tolerance"},
                        "a start that keeps an orientation");
  if (checker.is_given("cluster.directions")) {
    checker.warn_unused({"cluster.law"}, "cluster.orientation");
    if (checker.is_given("cluster.orientation"))
      checker.warn("cluster.orientation", "the measured directions take its place", "remove one of the two");
  }
}

void validate_generated(const SampleCase& sample, CaseChecker& checker) {
  checker.warn_unused({"cluster.file"}, "cluster.source = \"file\"");
  checker.warn_unused({"cluster.direction"}, "cluster.source = \"fiber\"");
  validate_start(sample.cluster, checker);
  validate_directions(sample.cluster, checker);
  validate_fiber_kind(sample.fibers, "fibers", checker);
  for (std::size_t i = 0; i < sample.fibers.more_kinds.size(); ++i)
    validate_fiber_kind(sample.fibers.more_kinds[i], kind_table(i), checker);
  validate_concentration(checker);
  validate_densities(sample, checker);
  validate_plan(sample, checker);
}

void validate_single(const SampleCase& sample, CaseChecker& checker) {
  checker.warn_unused({"cluster.file"}, "cluster.source = \"file\"");
  checker.warn_unused(packing_keys, "cluster.source = \"generate\"");
  const std::string source = checker.cite("cluster.source");
  checker.require("cluster.direction", "a single fiber needs one", "[0.0, 1.0, 1.0]");
  if (sample.cluster.direction && !(sample.cluster.direction->norm() > 0))
    checker.error("cluster.direction", "has no length", "give components that are not all zero");
  checker.require("fibers.length", "the fiber needs a length", "\"0.5 mm\"");
  if (sample.fibers.count.value_or(1) != 1)
    checker.error("fibers.count", "contradicts " + source, "remove it, or give 1");
  for (const std::string key :
       {"fibers.volume_fraction", "fibers.weight_fraction", "fibers.lengths", "fibers.length_histogram.edges",
        "fibers.length_distribution.number_average", "fibers.more_kinds.1.diameter"})
    if (checker.is_given(key)) checker.error(key, "contradicts " + source, "remove one of the two");
  validate_fiber_kind(sample.fibers, "fibers", checker);
}

void validate_from_file(const SampleCase& sample, CaseChecker& checker) {
  checker.require("cluster.file", "cluster.source = \"file\" needs it", "\"../cluster/checkpoint.h5\"");
  checker.check_file("cluster.file", sample.cluster.file);
  const std::string generate = "cluster.source = \"generate\"";
  checker.warn_unused({"cluster.direction"}, "cluster.source = \"fiber\"");
  checker.warn_unused({"fibers.rod_length"}, generate);
  checker.warn_unused(length_keys("fibers"), generate);
  checker.warn_unused(amount_keys, generate);
  checker.warn_unused(packing_keys, generate);
  const bool tells_its_cell = sample.cluster.file.ends_with(".h5");
  if (!tells_its_cell && !sample.cluster.file.empty())
    checker.require("cell.size", "the cluster's file does not tell its cell", "\"1.5 mm\"");
}

}  // namespace

void validate_sample(const SampleCase& sample, CaseChecker& checker) {
  validate_cell(sample, checker);
  if (!checker.is_sound("cluster.source")) return;
  if (sample.cluster.source == ClusterSource::generate) validate_generated(sample, checker);
  if (sample.cluster.source == ClusterSource::fiber) validate_single(sample, checker);
  if (sample.cluster.source == ClusterSource::file) validate_from_file(sample, checker);
}

}  // namespace fiberfate
