// Checks a case of the study rheometer and foretells what it needs.
#include "studies/rheometer/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "studies/pace.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/shear_cell/effort.hpp"

namespace fiberfate {
namespace {

constexpr double most_runs = 1e5;  ///< more points and replicas are a slip

/// A list of the sweep and the key of the cell for which it stands.
struct SweptKey {
  const char *list, *key;
  std::optional<std::size_t> RheometerPoint::*place;
};
constexpr std::array<SweptKey, 4> swept_keys = {
    {{"sweep.flows", "flow.type", &RheometerPoint::flow},
     {"sweep.volume_fractions", "fibers.volume_fraction", &RheometerPoint::volume_fraction},
     {"sweep.lengths", "fibers.length", &RheometerPoint::length},
     {"sweep.rates", "flow.rate", &RheometerPoint::rate}}};

/// Finds lists that are empty, contradict a key of the cell, or are missing altogether.
void validate_lists(const RheometerSweep& sweep, CaseChecker& checker) {
  const bool resolved = checker.is_given("version");  // gives flow.type in any case
  bool any = false;
  for (const SweptKey& one : swept_keys) {
    if (!checker.is_given(one.list)) continue;
    any = true;
    const bool is_empty = !(points(sweep).front().*one.place).has_value();
    if (is_empty && checker.is_sound(one.list))
      checker.error(one.list, "the list is empty", "give values, or remove it");
    if (checker.is_given(one.key) && !resolved)
      checker.error(one.list, "contradicts " + checker.cite(one.key), "remove one of the two");
  }
  if (!any)
    checker.error("sweep.rates", "not given, and no other list either",
                  "add rates, flows, volume_fractions or lengths under [sweep]");
}

void validate_flows(const RheometerCase& values, CaseChecker& checker) {
  const Choices<FlowType>& types = flow_types();
  std::vector<std::string> names;
  for (const Choice<FlowType>& one : types) names.emplace_back(one.name);
  bool by_gradient = values.sweep.flows.empty() && values.cell.flow.type == FlowType::gradient;
  for (std::size_t i = 0; i < values.sweep.flows.size(); ++i) {
    const std::string& flow = values.sweep.flows[i];
    if (std::find(names.begin(), names.end(), flow) == names.end())
      checker.error_in_row("sweep.flows", i, "there is no such flow",
                           fmt::format("the flows are {}", fmt::join(names, ", ")));
    by_gradient = by_gradient || flow == "gradient";
  }
  if (by_gradient && !values.sweep.rates.empty())
    checker.error("sweep.rates", "flows of type \"gradient\" have no rate: flow.gradient says it all",
                  "leave the rates out, or take another flow");
}

/// Finds points whose end is not told, or told twice.
void validate_ends(const RheometerCase& values, CaseChecker& checker) {
  const bool by_strain = checker.is_given("sweep.strain");
  if (!by_strain) {
    checker.require("run.duration", "points need an end, this or sweep.strain", "\"2 s\"");
    return;
  }
  if (checker.is_given("run.duration"))
    checker.error("sweep.strain", "contradicts " + checker.cite("run.duration"), "remove one of the two");
  for (const char* key : {"output.interval", "output.times", "output.stationary_from"})
    if (checker.is_given(key))
      checker.error(
          key,
          "points that end at one strain, " + checker.cite("sweep.strain") + ", do not last equally long",
          "remove it: 200 rows a point are taken and the last half is averaged; or give run.duration");
  for (const double rate : values.sweep.rates)
    if (rate == 0) checker.error("sweep.rates", "a melt at rest never comes to sweep.strain", "remove the 0");
  if (values.sweep.rates.empty() && values.cell.flow.rate == 0.0)
    checker.error("flow.rate", "a melt at rest never comes to sweep.strain", "give a rate");
}

void validate_replicas(const RheometerCase& values, CaseChecker& checker) {
  const ClusterSource source = values.cell.sample.cluster.source;
  if (!checker.is_sound("cluster.source") || source == ClusterSource::generate) return;
  if (values.sweep.replicas > 1)
    checker.error("sweep.replicas",
                  "replicas are packings of their own, and these fibers come as they are, " +
                      checker.cite("cluster.source"),
                  "give replicas = 1, or generate the fibers");
  if (source != ClusterSource::file) return;
  for (const char* list : {"sweep.volume_fractions", "sweep.lengths"})
    if (checker.is_given(list))
      checker.error(list, "has no effect on fibers of a file, " + checker.cite("cluster.source"),
                    "remove it");
}

/// The entries that a point puts in place of those of the cell.
std::vector<TomlEntry> entries_of(const RheometerPoint& point, const CaseChecker& checker) {
  std::vector<TomlEntry> entries;
  for (const SweptKey& one : swept_keys) {
    const TomlEntry* list = checker.find(one.list);
    const std::optional<std::size_t> place = point.*one.place;
    if (list == nullptr || !place) continue;
    const auto* values = std::get_if<std::vector<TomlValue>>(&list->value.data);
    if (values != nullptr && *place < values->size())
      entries.push_back({one.key, list->place, (*values)[*place]});
  }
  return entries;
}

/// Checks the cell of every point; rates of one sign share what depends on the fibers.
void validate_points(const RheometerCase& values, CaseChecker& checker) {
  for (const RheometerPoint& point : points(values.sweep))
    checker.check_with(entries_of(point, checker),
                       [&](CaseChecker& inside) { validate_shear_cell(cell_at(values, point, 0), inside); });
}

/// How much longer the runs of a point take than those of another.
double work(const ShearCellCase& cell) {
  const auto plan = plan_sample(cell.sample, cell.run.seed);
  if (!plan) return 1;
  return expected_steps(cell, crowding(cell, *plan)) * static_cast<double>(plan->rods);
}

double rheometer_seconds(const RheometerCase& values) {
  const std::vector<RheometerPoint> all = points(values.sweep);
  ShearCellCase first = cell_at(values, all.front(), 0);
  first.output.frame_interval = std::numeric_limits<double>::infinity();  // none is kept
  double share = 0;
  for (const RheometerPoint& point : all) share += work(cell_at(values, point, 0)) / work(first);
  const double one = shear_cell_seconds(first, plan_sample(first.sample, first.run.seed));
  return one * share * static_cast<double>(values.sweep.replicas);
}

}  // namespace

void validate_rheometer(const RheometerCase& values, CaseChecker& checker) {
  validate_lists(values.sweep, checker);
  validate_flows(values, checker);
  validate_ends(values, checker);
  validate_replicas(values, checker);
  if (values.cell.output.stress_steps == 0)
    checker.error("output.stress_steps", "without readings of the stress there is nothing to see", "give 50");
  const auto runs =
      static_cast<double>(points(values.sweep).size()) * static_cast<double>(values.sweep.replicas);
  if (runs > most_runs)
    checker.error("sweep.replicas", fmt::format("makes {:.3g} runs in all", runs), "shorten the lists");
  else if (std::all_of(swept_keys.begin(), swept_keys.end(),
                       [&](const SweptKey& one) { return checker.is_sound(one.list); }))
    validate_points(values, checker);
}

CaseEstimate estimate_rheometer(const RheometerCase& values) {
  const std::vector<RheometerPoint> all = points(values.sweep);
  const ShearCellCase first = cell_at(values, all.front(), 0);
  CaseEstimate estimate = estimate_sample(first.sample, plan_sample(first.sample, first.run.seed));
  for (const RheometerPoint& point : all) {
    const SampleCase sample = cell_at(values, point, 0).sample;
    estimate.memory_bytes =
        std::max(estimate.memory_bytes, sample_bytes(plan_sample(sample, first.run.seed)));
  }
  estimate.facts.emplace_back("points", fmt::format("{}", all.size()));
  estimate.facts.emplace_back(
      "runs", fmt::format("{}", all.size() * static_cast<std::size_t>(values.sweep.replicas)));
  foretell(
      estimate, [&] { return rheometer_seconds(values); }, "from a trial of the first point on this machine");
  return estimate;
}

}  // namespace fiberfate
