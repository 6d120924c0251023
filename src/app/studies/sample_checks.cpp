// Checks the choices about the fibers at the start.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/studies/sample_case.hpp"
#include "base/constants.hpp"
#include "base/error.hpp"
#include "packing/densest_fraction.hpp"

namespace fiberfate {
namespace {

constexpr double most_rods = 1e8;  ///< a population of 10⁸ rods needs some 200 GB
constexpr double fewest_diameters_a_cell =
    4;  ///< an edge; below it a rod would meet its own image everywhere

const std::vector<std::string> amount_keys = {"fibers.count", "fibers.volume_fraction",
                                              "fibers.weight_fraction"};

const std::vector<std::string> length_keys = {"fibers.length", "fibers.lengths",
                                              "fibers.length_histogram.edges",
                                              "fibers.length_distribution.number_average"};
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

void require(const std::string& key, const std::string& why, const std::string& example,
             CaseChecker& checker) {
  if (checker.is_given(key)) return;
  const auto dot = key.rfind('.');
  checker.error(key, "not given; " + why,
                fmt::format("add {} = {} under [{}]", key.substr(dot + 1), example, key.substr(0, dot)));
}

/// Demands one way of giving lengths, and tells which key it is.
std::string length_key(CaseChecker& checker) {
  const std::vector<std::string> given = given_of(length_keys, checker);
  if (given.empty()) require("fibers.length", "fibers need a length", "\"2.5 mm\"", checker);
  for (std::size_t i = 1; i < given.size(); ++i)
    checker.error(given[i], "contradicts " + checker.cite(given[0]), "remove one of the two");
  return given.empty() ? "fibers.length" : given[0];
}

/// Demands both of two keys, or none.
void require_both(const std::string& first, const std::string& second, const std::string& remedy,
                  CaseChecker& checker) {
  if (checker.is_given(first) == checker.is_given(second)) return;
  const bool lacks_first = !checker.is_given(first);
  checker.error(lacks_first ? first : second,
                fmt::format("not given, but {} is", lacks_first ? second : first), remedy);
}

void validate_lengths(const SampleCase& sample, CaseChecker& checker) {
  const std::string key = length_key(checker);
  require_both("fibers.length_histogram.edges", "fibers.length_histogram.heights",
               "give one more edge than there are heights", checker);
  require_both("fibers.length_distribution.number_average", "fibers.length_distribution.weight_average",
               "a law needs both means", checker);
  const auto sound = [&checker](const char* each) { return checker.is_sound(each); };
  constexpr std::array keys = {"fibers.length_histogram.edges", "fibers.length_histogram.heights",
                               "fibers.length_distribution.number_average",
                               "fibers.length_distribution.weight_average"};
  if (!checker.is_sound(key) || !std::all_of(keys.begin(), keys.end(), sound)) return;
  try {
    require_admissible(length_law(sample));
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems())
      checker.error(key, problem.complaint, problem.remedy);
  }
}

void validate_more_kinds(const FiberChoices& fibers, CaseChecker& checker) {
  for (std::size_t i = 0; i < fibers.more_kinds.size(); ++i) {
    const double length = fibers.more_kinds[i][0], diameter = fibers.more_kinds[i][1],
                 rod_length = fibers.more_kinds[i][4];
    if (length < diameter || rod_length < diameter)
      checker.error_in_row("fibers.more_kinds", i,
                           fmt::format("row {}: the fiber or its rods are shorter than it is thick", i + 1),
                           "give a length and a rod_length of at least one diameter");
  }
}

void validate_rods(const SampleCase& sample, CaseChecker& checker) {
  const FiberChoices& fibers = sample.fibers;
  require("fibers.rod_length", "fibers are cut into rods", "\"0.1 mm\"", checker);
  if (fibers.diameter <= 0) return;
  const std::string diameter = checker.cite("fibers.diameter");
  if (fibers.length && *fibers.length < fibers.diameter)
    checker.error("fibers.length", "a fiber is shorter than it is thick, " + diameter,
                  "give a length of at least one diameter");
  else if (fibers.rod_length && *fibers.rod_length < fibers.diameter)
    checker.error("fibers.rod_length", "a rod is shorter than it is thick, " + diameter,
                  "give at least one diameter; about five is usual");
  else if (fibers.rod_length && *fibers.rod_length < 2 * fibers.diameter)
    checker.warn("fibers.rod_length", "rods are shorter than two diameters",
                 "contacts next to a hinge are then counted on both of its rods; about five is usual");
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
    if (!cell) require("cell.size", "fibers need a cell", "\"1.5 mm\"", checker);
  } else if (given < 2) {
    const bool count = amounts.front() == "fibers.count";
    checker.error(amounts.front(), "does not fix the cell by itself",
                  count ? "add size under [cell], or a fraction under [fibers]"
                        : "add size under [cell], or count under [fibers]");
  }
}

void validate_densities(const SampleCase& sample, CaseChecker& checker) {
  if (!checker.is_given("fibers.weight_fraction")) {
    const std::string both = "a weight fraction with both densities";
    if (sample.fibers.density && !checker.is_given("matrix.density"))
      checker.warn_unused({"fibers.density"}, both);
    if (sample.matrix_density && !checker.is_given("fibers.density"))
      checker.warn_unused({"matrix.density"}, both);
    return;
  }
  const std::string why = "fibers.weight_fraction needs it";
  require("fibers.density", why, "\"2550 kg/m3\"", checker);
  require("matrix.density", why, "\"905 kg/m3\"", checker);
}

void validate_cell(const SampleCase& sample, CaseChecker& checker) {
  if (!sample.cell_size) return;
  if (sample.cell_size->minCoeff() < fewest_diameters_a_cell * sample.fibers.diameter)
    checker.error("cell.size",
                  fmt::format("the cell is hardly wider than a fiber, {}", checker.cite("fibers.diameter")),
                  fmt::format("give edges of at least {} diameters", fewest_diameters_a_cell));
}

/// Tells roughly how many rods a sample has, without making them.
double expected_rods(const SampleCase& sample) {
  const FiberChoices& fibers = sample.fibers;
  const double rod = fibers.rod_length.value_or(fibers.diameter);
  if (fibers.count)
    return static_cast<double>(*fibers.count) * std::max(1.0, number_average(length_law(sample)) / rod);
  const std::vector<FiberSpecies> kinds = species(sample);
  const double fraction =
      fibers.volume_fraction
          ? *fibers.volume_fraction
          : volume_from_weight_fraction(*fibers.weight_fraction, mean_density(kinds), *sample.matrix_density);
  double shares = 0, rods = 0;
  for (const FiberSpecies& kind : kinds) {
    const double radius = kind.material.radius;
    shares += kind.volume_share;
    rods += kind.volume_share / (pi * radius * radius * kind.rod_length);
  }
  return fraction * sample.cell_size->prod() * rods / shares;
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
  try {
    const std::optional<SamplePlan> plan = plan_sample(sample, 1);
    const double densest = densest_fraction(sample.cluster.orientation);
    if (holds_orientation(sample.cluster.start) && sample.cluster.directions.empty() &&
        plan->volume_fraction >= densest)
      checker.error(blamed,
                    fmt::format("the fibers fill {:.4g} of the cell, and with {} they fill at most {:.4g}",
                                plan->volume_fraction, checker.cite("cluster.orientation"), densest),
                    "lower the concentration, or align the fibers");
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems())
      checker.error(blamed, problem.complaint, problem.remedy);
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
  validate_lengths(sample, checker);
  validate_rods(sample, checker);
  validate_more_kinds(sample.fibers, checker);
  validate_concentration(checker);
  validate_densities(sample, checker);
  validate_plan(sample, checker);
}

void validate_single(const SampleCase& sample, CaseChecker& checker) {
  checker.warn_unused({"cluster.file"}, "cluster.source = \"file\"");
  checker.warn_unused(packing_keys, "cluster.source = \"generate\"");
  const std::string source = checker.cite("cluster.source");
  require("cluster.direction", "a single fiber needs one", "[0.0, 1.0, 1.0]", checker);
  if (sample.cluster.direction && !(sample.cluster.direction->norm() > 0))
    checker.error("cluster.direction", "has no length", "give components that are not all zero");
  require("fibers.length", "the fiber needs a length", "\"0.5 mm\"", checker);
  validate_rods(sample, checker);
  if (sample.fibers.count.value_or(1) != 1)
    checker.error("fibers.count", "contradicts " + source, "remove it, or give 1");
  for (const std::string key :
       {"fibers.volume_fraction", "fibers.weight_fraction", "fibers.lengths", "fibers.length_histogram.edges",
        "fibers.length_distribution.number_average", "fibers.more_kinds"})
    if (checker.is_given(key)) checker.error(key, "contradicts " + source, "remove one of the two");
}

void validate_from_file(const SampleCase& sample, CaseChecker& checker) {
  require("cluster.file", "cluster.source = \"file\" needs it", "\"../cluster/checkpoint.h5\"", checker);
  checker.check_file("cluster.file", sample.cluster.file);
  const std::string generate = "cluster.source = \"generate\"";
  checker.warn_unused({"cluster.direction"}, "cluster.source = \"fiber\"");
  checker.warn_unused({"fibers.rod_length"}, generate);
  checker.warn_unused(length_keys, generate);
  checker.warn_unused(amount_keys, generate);
  checker.warn_unused(packing_keys, generate);
  const bool tells_its_cell = sample.cluster.file.ends_with(".h5");
  if (!tells_its_cell && !sample.cluster.file.empty())
    require("cell.size", "the cluster's file does not tell its cell", "\"1.5 mm\"", checker);
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
