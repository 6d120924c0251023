// Checks the choices about the fibers at the start and translates them for the packing.
#include "app/studies/sample_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr double most_rods = 1e8;  ///< a population of 10⁸ rods needs some 200 GB
constexpr double fewest_diameters_a_cell =
    4;                                   ///< an edge; below it a rod would meet its own image everywhere
constexpr double single_fiber_cell = 4;  ///< edge of the cell of a lone fiber, in fiber lengths

const std::vector<std::string> amount_keys = {"fibers.count", "fibers.volume_fraction",
                                              "fibers.weight_fraction"};

bool has_histogram(const SampleCase& sample) {
  return !sample.fibers.length_histogram.edges.empty();
}

LengthLaw length_law(const SampleCase& sample) {
  if (has_histogram(sample)) return sample.fibers.length_histogram;
  return SingleLength{sample.fibers.length.value_or(0)};
}

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

void validate_lengths(const SampleCase& sample, CaseChecker& checker) {
  const std::string edges = "fibers.length_histogram.edges";
  const std::string heights = "fibers.length_histogram.heights";
  if (!checker.is_given(edges) && !checker.is_given(heights)) {
    require("fibers.length", "fibers need a length", "\"2.5 mm\"", checker);
    return;
  }
  if (checker.is_given("fibers.length"))
    checker.error("fibers.length", "contradicts the histogram of lengths, " + checker.cite(edges),
                  "remove one of the two");
  if (!checker.is_given(edges))
    checker.error(edges, "not given, but heights are", "give one more edge than there are heights");
  if (!checker.is_given(heights))
    checker.error(heights, "not given, but edges are", "give one height less than there are edges");
  if (!checker.is_sound(edges) || !checker.is_sound(heights)) return;
  try {
    require_admissible(length_law(sample));
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems())
      checker.error(edges, problem.complaint, problem.remedy);
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
  const double rod = fibers.rod_length.value_or(0);
  const double length = std::max(rod, number_average(length_law(sample)));
  if (fibers.count) return static_cast<double>(*fibers.count) * length / rod;
  const double fraction =
      fibers.volume_fraction
          ? *fibers.volume_fraction
          : volume_from_weight_fraction(*fibers.weight_fraction, *fibers.density, *sample.matrix_density);
  return fraction * sample.cell_size->prod() / (pi * fibers.diameter * fibers.diameter / 4 * rod);
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
    static_cast<void>(plan_sample(sample, 1));
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems())
      checker.error(blamed, problem.complaint, problem.remedy);
  }
}

void validate_generated(const SampleCase& sample, CaseChecker& checker) {
  checker.warn_unused({"cluster.file"}, "cluster.source = \"file\"");
  checker.warn_unused({"cluster.direction"}, "cluster.source = \"fiber\"");
  validate_lengths(sample, checker);
  validate_rods(sample, checker);
  validate_concentration(checker);
  validate_densities(sample, checker);
  validate_plan(sample, checker);
}

void validate_single(const SampleCase& sample, CaseChecker& checker) {
  checker.warn_unused({"cluster.file"}, "cluster.source = \"file\"");
  checker.warn_unused({"cluster.orientation", "cluster.law", "cluster.swelling", "cluster.minimum_radius",
                       "cluster.overlap_tolerance", "cluster.orientation_tolerance", "cluster.step_limit"},
                      "cluster.source = \"generate\"");
  const std::string source = checker.cite("cluster.source");
  require("cluster.direction", "a single fiber needs one", "[0.0, 1.0, 1.0]", checker);
  if (sample.cluster.direction && !(sample.cluster.direction->norm() > 0))
    checker.error("cluster.direction", "has no length", "give components that are not all zero");
  require("fibers.length", "the fiber needs a length", "\"0.5 mm\"", checker);
  validate_rods(sample, checker);
  if (sample.fibers.count.value_or(1) != 1)
    checker.error("fibers.count", "contradicts " + source, "remove it, or give 1");
  for (const std::string key : {"fibers.volume_fraction", "fibers.weight_fraction",
                                "fibers.length_histogram.edges", "fibers.length_histogram.heights"})
    if (checker.is_given(key)) checker.error(key, "contradicts " + source, "remove one of the two");
}

void validate_from_file(const SampleCase& sample, CaseChecker& checker) {
  require("cluster.file", "cluster.source = \"file\" needs it", "\"../cluster/checkpoint.h5\"", checker);
  checker.check_file("cluster.file", sample.cluster.file);
  const std::string generate = "cluster.source = \"generate\"";
  checker.warn_unused({"cluster.direction"}, "cluster.source = \"fiber\"");
  checker.warn_unused(
      {"fibers.length", "fibers.rod_length", "fibers.count", "fibers.volume_fraction",
       "fibers.weight_fraction", "fibers.length_histogram.edges", "fibers.length_histogram.heights",
       "cluster.orientation", "cluster.law", "cluster.swelling", "cluster.minimum_radius",
       "cluster.overlap_tolerance", "cluster.orientation_tolerance", "cluster.step_limit"},
      generate);
  const bool tells_its_cell = sample.cluster.file.ends_with(".h5");
  if (!tells_its_cell && !sample.cluster.file.empty())
    require("cell.size", "the cluster's file does not tell its cell", "\"1.5 mm\"", checker);
}

FiberMaterial material(const SampleCase& sample) {
  return {sample.fibers.diameter / 2, sample.fibers.youngs_modulus, sample.fibers.density.value_or(0)};
}

}  // namespace

void validate_sample(const SampleCase& sample, CaseChecker& checker) {
  validate_cell(sample, checker);
  if (!checker.is_sound("cluster.source")) return;
  if (sample.cluster.source == ClusterSource::generate) validate_generated(sample, checker);
  if (sample.cluster.source == ClusterSource::fiber) validate_single(sample, checker);
  if (sample.cluster.source == ClusterSource::file) validate_from_file(sample, checker);
}

FiberSpecies species(const SampleCase& sample) {
  return {material(sample), length_law(sample), sample.fibers.rod_length.value_or(0), 1};
}

ConcentrationRequest concentration(const SampleCase& sample) {
  return {sample.fibers.count, sample.fibers.volume_fraction, sample.fibers.weight_fraction, sample.cell_size,
          sample.matrix_density.value_or(0)};
}

PackingRequest packing_request(const SampleCase& sample, const ContactParameters& contact,
                               std::uint64_t seed) {
  const ClusterChoices& cluster = sample.cluster;
  PackingRequest request;
  request.orientation.tensor = cluster.orientation;
  request.orientation.law = cluster.law;
  request.swelling = cluster.swelling;
  request.minimum_radius = cluster.minimum_radius;
  request.overlap_tolerance = cluster.overlap_tolerance;
  request.orientation_tolerance = cluster.orientation_tolerance;
  request.rest = {contact.force_constant, contact.decay, contact.cutoff, contact.ramp};
  request.step_limit = cluster.step_limit;
  request.seed = seed;
  return request;
}

FiberState single_fiber(const SampleCase& sample) {
  const double length = sample.fibers.length.value_or(0);
  const Vec3 size = sample.cell_size.value_or(Vec3::Constant(single_fiber_cell * length));
  const Vec3 direction = sample.cluster.direction.value_or(Vec3::UnitX()).normalized();
  const int rods = rods_for(length, sample.fibers.rod_length.value_or(length));
  FiberState state;
  state.materials = {material(sample)};
  state.cell = rectangular_cell(size);
  std::vector<Vec3> nodes;
  for (int i = 0; i <= rods; ++i) nodes.push_back(size / 2 + (i - rods / 2.0) * (length / rods) * direction);
  append_fiber(state, {nodes, 0});
  return state;
}

std::optional<SamplePlan> plan_sample(const SampleCase& sample, std::uint64_t seed) {
  if (sample.cluster.source == ClusterSource::file) return {};
  SamplePlan plan;
  if (sample.cluster.source == ClusterSource::fiber) {
    const FiberState state = single_fiber(sample);
    plan = {1, state.rod_count(), state.cell.lattice.diagonal(), volume_fraction(state), {}};
  } else {
    const Population population = plan_population({species(sample)}, concentration(sample), seed);
    plan.fibers = static_cast<std::int64_t>(population.fibers.size());
    for (const FiberBlank& fiber : population.fibers) plan.rods += fiber.rods;
    plan.cell_size = population.cell_size;
    plan.volume_fraction = population.volume_fraction;
  }
  if (sample.fibers.density && sample.matrix_density)
    plan.weight_fraction =
        weight_from_volume_fraction(plan.volume_fraction, *sample.fibers.density, *sample.matrix_density);
  return plan;
}

}  // namespace fiberfate
