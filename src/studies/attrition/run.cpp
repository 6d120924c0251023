// Runs the study attrition: follows the lengths.
#include "studies/attrition/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/memory.hpp"
#include "continuum/length_registry.hpp"
#include "microstructure/length_statistics.hpp"
#include "studies/attrition/observables.hpp"
#include "studies/law_facts.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

/// What one law predicted.
struct Followed {
  std::vector<LengthMoment> moments;
  CsvTable histogram{{"time_s", "length_low_m", "length_high_m", "number_share", "length_share"}};
  double fiber_growth = 1;   ///< fibers at the end over fibers at the start
  double length_change = 0;  ///< relative change of the total fiber length
  double rate_constant = 0;  ///< k_f at the end, 1/s; NaN for laws without
};

double sum(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

std::vector<double> histogram_times(const AttritionCase& values) {
  if (values.output.histogram_times.empty()) return {0, values.run.duration};
  return values.output.histogram_times;
}

/// Follows one law; in a trial only as far as its time reaches.
Followed follow(const AttritionCase& values, const LawChoice& choice, const Session* session,
                Pace* trial = nullptr) {
  const auto law = make_attrition_law(choice.name, law_values(attrition_menu(), choice));
  const auto melt = make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt));
  const FlowHistory history = flow_history(values.flow);
  const LengthStart start = length_start(values.fibers);
  const std::vector<double> edges = even_edges({start.initial.lengths, start.initial.numbers},
                                               static_cast<int>(values.output.histogram_bins));
  const std::vector<double> counted = histogram_times(values);
  Followed followed;
  double first_number = 1, first_length = 1;
  const auto visit = [&](const LengthSample& sample) {
    if (session != nullptr) session->end_if_stopped("stopped; resuming begins again");
    followed.moments.push_back(
        {sample.time, sample.melt, sample.viscosity, sample.unbreakable_length, sample.evolution.means()});
    const LengthClasses& population = sample.evolution.population();
    if (population.lengths.empty()) return;
    if (sample.time == 0) {
      first_number = sum(population.numbers);
      first_length = total_length(population);
    }
    followed.fiber_growth = sum(population.numbers) / first_number;
    followed.length_change = total_length(population) / first_length - 1;
    if (std::find(counted.begin(), counted.end(), sample.time) != counted.end())
      append_length_shares(followed.histogram, {sample.time}, population, edges);
  };
  const auto try_out = [&](const LengthSample& sample) {
    visit(sample);
    trial->reached(sample.time / values.run.duration);
    if (!trial->has_time()) throw TrialEnd{};
  };
  const LengthConditions conditions = {history, *melt, values.flow.compression};
  if (trial != nullptr)
    follow_lengths(*law, start, conditions, with_early_times(output_times(values)), try_out);
  else
    follow_lengths(*law, start, conditions, output_times(values), visit);
  const LengthMoment& last = followed.moments.back();
  const RelaxationLaw* relaxation = law->relaxation();
  followed.rate_constant =
      relaxation == nullptr
          ? std::nan("")
          : relaxation->at({last.melt.rate, last.viscosity, values.flow.compression}).rate_constant;
  return followed;
}

void append_values(RunSummary& summary, const std::string& prefix, const LawChoice& choice,
                   const Followed& followed) {
  append_law(summary, {prefix, "law"}, attrition_menu(), choice);
  const LengthMoment &first = followed.moments.front(), &last = followed.moments.back();
  const std::pair<const char*, double> all[] = {
      {"L_N_start_m", first.means.number_average},       {"L_W_start_m", first.means.weight_average},
      {"L_N_end_m", last.means.number_average},          {"L_W_end_m", last.means.weight_average},
      {"unbreakable_length_m", last.unbreakable_length}, {"rate_constant_per_s", followed.rate_constant},
      {"fiber_growth", followed.fiber_growth},           {"total_length_change", followed.length_change}};
  for (const auto& [name, value] : all) summary.own.emplace_back(prefix + name, value);
}

/// Sets the moments of both laws side by side; those of the second are empty where there is none.
CsvTable series_of(const AttritionCase& values, const std::vector<LengthMoment>& moments,
                   const std::vector<LengthMoment>& compared) {
  const Observables<LengthMoment> others = compared_observables(values);
  CsvTable series{columns_of(joined<LengthMoment>({length_observables(), others}))};
  for (std::size_t i = 0; i < moments.size(); ++i) {
    std::vector<double> row = measure(length_observables(), moments[i]);
    for (const Observable<LengthMoment>& other : others) row.push_back(other.measure(compared[i]));
    series.append(row);
  }
  return series;
}

void compute_lengths(const AttritionCase& values, Session& session, Outcome& outcome) {
  RunSummary& summary = outcome.summary;
  const Followed followed = follow(values, values.law, &session);
  const LengthMoment& last = followed.moments.back();
  constexpr double coarse = 0.05;  // L_ub spans fewer than ten bins
  if (needs_bins(values.law))
    if (const std::string remark = remark_on_bins(values.fibers, last.unbreakable_length, coarse);
        !remark.empty())
      session.recorder().warn(remark);
  append_values(summary, "", values.law, followed);
  summary.number_average = last.means.number_average;
  summary.weight_average = last.means.weight_average;
  summarise(length_observables(), last, summary);
  Followed other;
  if (!values.compared.name.empty()) {
    other = follow(values, values.compared, &session);
    append_values(summary, "compared_", values.compared, other);
    outcome.tables.push_back({"histogram_compared", other.histogram});
  }
  summary.steps = static_cast<std::int64_t>(followed.moments.size());
  outcome.tables.push_back({"series", series_of(values, followed.moments, other.moments)});
  outcome.tables.push_back({"histogram", followed.histogram});
}

/// Foretells the wall seconds that one law takes. The work of Phelps' law grows with the square of its bins.
double foretell(AttritionCase values, const LawChoice& choice) {
  constexpr std::int64_t most_bins = 2000;  // that a trial can afford
  double scale = 1;
  if (needs_bins(choice) && values.fibers.bins > most_bins) {
    scale = std::pow(static_cast<double>(values.fibers.bins) / most_bins, 2);
    values.fibers.bins = most_bins;
  }
  Pace trial;
  try {
    static_cast<void>(follow(values, choice, nullptr, &trial));
  } catch (const TrialEnd&) {
  }
  return scale * trial.whole();
}

}  // namespace

double attrition_seconds(const AttritionCase& values) {
  return foretell(values, values.law) +
         (values.compared.name.empty() ? 0.0 : foretell(values, values.compared));
}

Outcome compute_attrition(const AttritionCase& values, Session& session) {
  require_memory(attrition_bytes(values), "take fewer fibers.bins or rows of output");
  Outcome outcome;
  outcome.summary.simulated_s = values.run.duration;
  compute_lengths(values, session, outcome);
  outcome.headlines.push_back(fmt::format(
      "L_N {:.4g} mm, L_W {:.4g} mm after {:.4g} s", 1e3 * outcome.summary.number_average.value_or(0),
      1e3 * outcome.summary.weight_average.value_or(0), values.run.duration));
  return outcome;
}

}  // namespace fiberfate
