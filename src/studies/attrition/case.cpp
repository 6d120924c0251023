// Checks a case of the study attrition and makes from it what the laws take.
#include "studies/attrition/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuum/length_registry.hpp"
#include "keys/time_rows.hpp"
#include "microstructure/length_distribution.hpp"

namespace fiberfate {
namespace {

constexpr double default_rows = 200;
constexpr double most_rows = 1e6;
/// Classes of equal number that stand for a Weibull distribution.
constexpr std::size_t weibull_classes = 1000;

bool needs_bins(const LawChoice& law) {
  return law.name == "phelps" || law.name == "durin";
}

void validate_flow(const AttritionFlowChoices& flow, CaseChecker& checker) {
  const auto require = [&checker](const std::string& key, const std::string& remedy) {
    if (!checker.is_given(key)) checker.error(key, "not given; this kind of flow needs it", remedy);
  };
  if (flow.kind == AttritionFlow::constant)
    require("flow.rate", "add rate = \"18.326 1/s\" under [flow]");
  else
    checker.warn_unused({"flow.rate"}, "flow.kind = \"constant\"");
  if (flow.kind == AttritionFlow::couette)
    require("flow.speed", "add speed = 50 under [flow]");
  else
    checker.warn_unused(
        {"flow.speed", "flow.inner_radius", "flow.outer_radius", "flow.rate_at", "flow.power_law_index"},
        "flow.kind = \"couette\"");
  if (!(flow.couette.inner_radius < flow.couette.outer_radius))
    checker.error("flow.inner_radius", "not less than " + checker.cite("flow.outer_radius"),
                  "give the smaller one");
  if (flow.kind != AttritionFlow::table) {
    checker.warn_unused({"flow.table", "flow.form"}, "flow.kind = \"table\"");
    return;
  }
  require("flow.table", "add rows [time, rate, temperature, pressure] under [flow]");
  checker.warn_unused({"flow.temperature", "flow.pressure"}, "flow.kind = \"constant\" or \"couette\"");
  check_times_of_rows("flow.table", flow.table, checker);
}

void validate_fibers(const AttritionCase& values, CaseChecker& checker) {
  const AttritionFiberChoices& fibers = values.fibers;
  const bool means = fibers.number_average || fibers.weight_average;
  const int given = (fibers.length ? 1 : 0) + (fibers.distribution.empty() ? 0 : 1) + (means ? 1 : 0);
  if (given != 1)
    checker.error("fibers.length",
                  given == 0 ? "no lengths are given" : "lengths are given in more than one way",
                  "give length, or distribution, or number_average and weight_average");
  if (means) validate_mean_lengths(fibers, checker);
  if (!fibers.distribution.empty() && std::all_of(fibers.distribution.begin(), fibers.distribution.end(),
                                                  [](const auto& row) { return row[1] == 0; }))
    checker.error("fibers.distribution", "there are no fibers", "give at least one number above zero");
  const bool bins = needs_bins(values.law) || needs_bins(values.compared);
  if (fibers.form == LengthForm::means && bins)
    checker.error("fibers.form", "phelps and durin follow distributions only",
                  "take form = \"distribution\"");
  if (!bins) checker.warn_unused({"fibers.bins", "fibers.largest_length"}, "the laws phelps and durin");
  if (!checker.is_sound() || !bins || !fibers.largest_length) return;
  const std::vector<double> lengths = length_start(fibers).initial.lengths;
  if (*std::max_element(lengths.begin(), lengths.end()) > *fibers.largest_length)
    checker.error("fibers.largest_length", "shorter than the longest fiber", "raise it, or leave it out");
}

void validate_output(const AttritionCase& values, CaseChecker& checker) {
  if (values.duration <= 0) return;
  const double interval = values.output.interval.value_or(values.duration / default_rows);
  if (values.duration / interval > most_rows)
    checker.error("output.interval", fmt::format("makes {:.3g} rows", values.duration / interval),
                  fmt::format("give at least {:.3g} s", values.duration / most_rows));
  for (const double time : values.output.histogram_times)
    if (time > values.duration)
      checker.error("output.histogram_times",
                    fmt::format("{:.6g} s comes after the end, {}", time, checker.cite("run.duration")),
                    "give times up to run.duration");
}

}  // namespace

void validate_mean_lengths(const AttritionFiberChoices& fibers, CaseChecker& checker) {
  if (!(fibers.number_average && fibers.weight_average))
    checker.error(fibers.number_average ? "fibers.weight_average" : "fibers.number_average", "not given",
                  "give both mean lengths");
  else if (!(*fibers.number_average < *fibers.weight_average))
    checker.error("fibers.number_average", "not less than " + checker.cite("fibers.weight_average"),
                  "L_N is less than L_W; for equal lengths give fibers.length");
}

void validate_attrition(const AttritionCase& values, CaseChecker& checker) {
  validate_law(attrition_menu(), "law", values.law, checker);
  validate_law(attrition_menu(), "compare", values.compared, checker);
  validate_law(viscosity_menu(), "melt", values.melt, checker);
  validate_flow(values.flow, checker);
  validate_fibers(values, checker);
  validate_output(values, checker);
}

CaseEstimate estimate_attrition(const AttritionCase& values) {
  CaseEstimate estimate;
  const MeltState melt = length_history(values.flow).at(0);
  const double viscosity =
      make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt))->at(melt);
  const auto law = make_attrition_law(values.law.name, law_values(attrition_menu(), values.law));
  const LengthFlow flow = {melt.rate, viscosity, values.flow.compression};
  estimate.facts = {
      {"shear rate at the start", fmt::format("{:.6g} 1/s", flow.rate)},
      {"viscosity at the start", fmt::format("{:.6g} Pa s", viscosity)},
      {"shear stress at the start", fmt::format("{:.6g} Pa", viscosity * flow.rate)},
      {"unbreakable length at the start", fmt::format("{:.6g} mm", 1e3 * law->unbreakable_length(flow))}};
  if (const RelaxationLaw* relaxation = law->relaxation())
    estimate.facts.emplace_back("k_f at the start",
                                fmt::format("{:.6g} 1/s", relaxation->at(flow).rate_constant));
  estimate.facts.emplace_back("rows of series.csv", fmt::format("{}", output_times(values).size()));
  estimate.memory_bytes = 1e7;
  if (needs_bins(values.law) || needs_bins(values.compared))
    estimate.memory_bytes += PhelpsSolver::memory_bytes(static_cast<std::size_t>(values.fibers.bins));
  estimate.wall_seconds = 1e-4 * static_cast<double>(output_times(values).size());
  estimate.assumption = "0.1 ms an output";
  return estimate;
}

LengthHistory length_history(const AttritionFlowChoices& flow) {
  if (flow.kind == AttritionFlow::table) {
    std::vector<LengthHistoryRow> rows;
    for (const std::vector<double>& row : flow.table) rows.push_back({row[0], row[1], row[2], row[3]});
    return LengthHistory(std::move(rows), flow.form);
  }
  const bool couette = flow.kind == AttritionFlow::couette;
  const double rate = couette ? shear_rate(flow.couette, flow.speed.value_or(0)) : flow.rate.value_or(0);
  return LengthHistory::constant({rate, flow.temperature, flow.pressure});
}

LengthStart length_start(const AttritionFiberChoices& fibers) {
  LengthStart start;
  start.form = fibers.form;
  start.weight = fibers.weight;
  start.bins = {static_cast<std::size_t>(fibers.bins), fibers.largest_length.value_or(0)};
  if (fibers.length) {
    start.initial = {{*fibers.length}, {1}};
  } else if (fibers.number_average) {
    start.means = MeanLengths{*fibers.number_average, *fibers.weight_average};
    start.initial.lengths =
        sample_lengths(WeibullLengths{*fibers.number_average, *fibers.weight_average}, {weibull_classes});
    start.initial.numbers.assign(weibull_classes, 1.0);
  }
  for (const std::vector<double>& row : fibers.distribution) {
    start.initial.lengths.push_back(row[0]);
    start.initial.numbers.push_back(row[1]);
  }
  return start;
}

std::vector<double> output_times(const AttritionCase& values) {
  const double interval = values.output.interval.value_or(values.duration / default_rows);
  std::vector<double> times = values.output.histogram_times;
  const double count = std::floor(values.duration / interval * (1 + 1e-12));
  for (double i = 0; i <= count; ++i) times.push_back(std::min(i * interval, values.duration));
  times.push_back(values.duration);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(),
                          [interval](double a, double b) { return b - a < 1e-9 * interval; }),
              times.end());
  return times;
}

}  // namespace fiberfate
