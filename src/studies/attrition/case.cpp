// Checks a case of the study attrition and makes from it what the laws take.
#include "studies/attrition/case.hpp"
#include "base/timer.hpp"
#include "studies/attrition/run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "continuum/length_registry.hpp"
#include "keys/time_rows.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

void validate_flow(const AttritionFlowChoices& flow, CaseChecker& checker) {
  const std::string why = "this kind of flow needs it";
  if (flow.kind == AttritionFlow::constant)
    checker.require("flow.rate", why, "\"18.326 1/s\"");
  else
    checker.warn_unused({"flow.rate"}, "flow.kind = \"constant\"");
  if (flow.kind == AttritionFlow::couette)
    checker.require("flow.speed", why, "50");
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
  checker.require("flow.table", why, "[[time, rate, temperature, pressure], ...]");
  checker.warn_unused({"flow.temperature", "flow.pressure"}, "flow.kind = \"constant\" or \"couette\"");
  check_times_of_rows("flow.table", flow.table, checker);
}

void validate_fibers(const AttritionCase& values, CaseChecker& checker) {
  const LengthChoices& fibers = values.fibers;
  const bool means = gives_means(fibers);
  const int given = (fibers.length ? 1 : 0) + (fibers.distribution.empty() ? 0 : 1) + (means ? 1 : 0);
  if (given > 1 || (given == 0 && lengths_are_read(checker)))
    checker.error("fibers.length",
                  given == 0 ? "no lengths are given" : "lengths are given in more than one way",
                  "give length, or distribution, or number_average and weight_average");
  if (means) validate_mean_lengths(fibers, checker);
  validate_distribution(fibers.distribution, checker);
  const bool bins = needs_bins(values.law) || needs_bins(values.compared);
  if (fibers.form == LengthForm::means && bins)
    checker.error("fibers.form", laws_of_bins() + " follow distributions only",
                  "take form = \"distribution\"");
  if (!bins) checker.warn_unused({"fibers.bins", "fibers.largest_length"}, "the laws " + laws_of_bins());
  if (!checker.is_sound() || !bins || !fibers.largest_length) return;
  const std::vector<double> lengths = length_start(fibers).initial.lengths;
  if (*std::max_element(lengths.begin(), lengths.end()) > *fibers.largest_length)
    checker.error("fibers.largest_length", "shorter than the longest fiber", "raise it, or leave it out");
}

/// Simple shear of a melt whose viscosity a law gives.
Flow melt_flow(double rate, double temperature, double pressure) {
  Flow flow = simple_shear(rate);
  flow.temperature = temperature;
  flow.pressure = pressure;
  return flow;
}

}  // namespace

void validate_attrition(const AttritionCase& values, CaseChecker& checker) {
  validate_law(attrition_menu(), "law", values.law, checker);
  validate_law(attrition_menu(), "compare", values.compared, checker);
  validate_law(viscosity_menu(), "melt", values.melt, checker);
  validate_flow(values.flow, checker);
  validate_fibers(values, checker);
  validate_series(values.run, values.output, checker);
  validate_times("output.histogram_times", values.output.histogram_times, values.run, checker);
}

double attrition_bytes(const AttritionCase& values) {
  constexpr double bytes_a_row = 300;
  const bool bins = needs_bins(values.law) || needs_bins(values.compared);
  return static_cast<double>(peak_memory_bytes()) +
         bytes_a_row * static_cast<double>(output_times(values).size()) +
         (bins ? PhelpsSolver::memory_bytes(values.fibers.bins) : 0);
}

CaseEstimate estimate_attrition(const AttritionCase& values) {
  CaseEstimate estimate;
  const MeltState melt = melt_of(flow_history(values.flow).at(0));
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
  estimate.memory_bytes = attrition_bytes(values);
  foretell(
      estimate, [&] { return attrition_seconds(values); }, "from a trial of its beginning");
  return estimate;
}

FlowHistory flow_history(const AttritionFlowChoices& flow) {
  if (flow.kind == AttritionFlow::table) {
    std::vector<FlowRow> rows;
    for (const std::vector<double>& row : flow.table)
      rows.push_back({row[0], melt_flow(row[1], row[2], row[3])});
    return FlowHistory(std::move(rows), flow.form);
  }
  const bool couette = flow.kind == AttritionFlow::couette;
  const double rate = couette ? shear_rate(flow.couette, flow.speed.value_or(0)) : flow.rate.value_or(0);
  return FlowHistory::constant(melt_flow(rate, flow.temperature, flow.pressure));
}

std::vector<double> output_times(const AttritionCase& values) {
  return series_times(values.run, values.output, values.output.histogram_times);
}

}  // namespace fiberfate
