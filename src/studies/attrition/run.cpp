// Runs the study attrition: follows the lengths and writes them over time.
#include "studies/attrition/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuum/length_prediction.hpp"
#include "continuum/length_registry.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "microstructure/length_statistics.hpp"

namespace fiberfate {
namespace {

/// Holds what one law predicted.
struct Followed {
  CsvTable series;
  CsvTable histogram;
  MeanLengths start, end;
  double fiber_growth = 1;        ///< fibers at the end over fibers at the start
  double length_change = 0;       ///< relative change of the total fiber length
  double unbreakable_length = 0;  ///< at the end, m
  double rate_constant = 0;       ///< k_f at the end, 1/s; NaN for laws without
};

double sum(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

void append_histogram(const LengthClasses& population, double time, const std::vector<double>& edges,
                      CsvTable& table) {
  const std::vector<double> counts = histogram(population, edges);
  const double all = sum(population.numbers), length = total_length(population);
  LengthClasses by_length = population;
  for (std::size_t i = 0; i < by_length.numbers.size(); ++i) by_length.numbers[i] *= by_length.lengths[i];
  const std::vector<double> lengths = histogram(by_length, edges);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double row[] = {time, edges[i], edges[i + 1], counts[i] / all, lengths[i] / length};
    for (std::size_t column = 0; column < 5; ++column) table.values[column].push_back(row[column]);
  }
}

Followed follow(const AttritionCase& values, const LawChoice& choice) {
  const auto law = make_attrition_law(choice.name, law_values(attrition_menu(), choice));
  const auto melt = make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt));
  const LengthHistory history = length_history(values.flow);
  const LengthStart start = length_start(values.fibers);
  const std::vector<double> edges = even_edges({start.initial.lengths, start.initial.numbers},
                                               static_cast<int>(values.output.histogram_bins));
  std::vector<double> histogram_times = values.output.histogram_times;
  if (histogram_times.empty()) histogram_times = {0, values.duration};

  Followed followed;
  followed.series.columns = {"time_s",        "L_N_m",          "L_W_m",           "rate_per_s",
                             "temperature_K", "viscosity_Pa_s", "shear_stress_Pa", "unbreakable_length_m"};
  followed.series.values.resize(followed.series.columns.size());
  followed.histogram.columns = {"time_s", "length_low_m", "length_high_m", "number_share", "length_share"};
  followed.histogram.values.resize(followed.histogram.columns.size());
  double first_number = 1, first_length = 1;
  follow_lengths(
      *law, start, {history, *melt, values.flow.compression}, output_times(values),
      [&](const LengthSample& sample) {
        const MeanLengths means = sample.evolution.means();
        const LengthClasses& population = sample.evolution.population();
        const double row[] = {sample.time,
                              means.number_average,
                              means.weight_average,
                              sample.melt.rate,
                              sample.melt.temperature,
                              sample.viscosity,
                              sample.viscosity * sample.melt.rate,
                              sample.unbreakable_length};
        for (std::size_t i = 0; i < std::size(row); ++i) followed.series.values[i].push_back(row[i]);
        followed.end = means;
        followed.unbreakable_length = sample.unbreakable_length;
        const RelaxationLaw* relaxation = law->relaxation();
        followed.rate_constant =
            relaxation == nullptr
                ? std::nan("")
                : relaxation->at({sample.melt.rate, sample.viscosity, values.flow.compression}).rate_constant;
        if (sample.time == 0) followed.start = means;
        if (population.lengths.empty()) return;
        if (sample.time == 0) {
          first_number = sum(population.numbers);
          first_length = total_length(population);
        }
        followed.fiber_growth = sum(population.numbers) / first_number;
        followed.length_change = total_length(population) / first_length - 1;
        if (std::find(histogram_times.begin(), histogram_times.end(), sample.time) != histogram_times.end())
          append_histogram(population, sample.time, edges, followed.histogram);
      });
  return followed;
}

void append_values(RunSummary& summary, const std::string& prefix, const LawChoice& choice,
                   const Followed& followed) {
  auto& own = summary.own;
  own.emplace_back(prefix + "law", choice.name);
  const LawMenuItem& law = *chosen_law(attrition_menu(), choice);
  const std::vector<double> parameters = law_values(attrition_menu(), choice);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    own.emplace_back(prefix + law.parameters[i].name, parameters[i]);
  own.emplace_back(prefix + "L_N_start_m", followed.start.number_average);
  own.emplace_back(prefix + "L_W_start_m", followed.start.weight_average);
  own.emplace_back(prefix + "L_N_end_m", followed.end.number_average);
  own.emplace_back(prefix + "L_W_end_m", followed.end.weight_average);
  own.emplace_back(prefix + "unbreakable_length_m", followed.unbreakable_length);
  own.emplace_back(prefix + "rate_constant_per_s", followed.rate_constant);
  own.emplace_back(prefix + "fiber_growth", followed.fiber_growth);
  own.emplace_back(prefix + "total_length_change", followed.length_change);
}

void compute_lengths(const AttritionCase& values, Outcome& outcome) {
  RunSummary& summary = outcome.summary;
  Followed followed = follow(values, values.law);
  append_values(summary, "", values.law, followed);
  summary.number_average = followed.end.number_average;
  summary.weight_average = followed.end.weight_average;
  summary.own.emplace_back("rate_per_s", followed.series.column("rate_per_s").back());
  summary.own.emplace_back("viscosity_Pa_s", followed.series.column("viscosity_Pa_s").back());
  summary.own.emplace_back("shear_stress_Pa", followed.series.column("shear_stress_Pa").back());
  if (!values.compared.name.empty()) {
    const Followed other = follow(values, values.compared);
    append_values(summary, "compared_", values.compared, other);
    for (const char* column : {"L_N_m", "L_W_m", "unbreakable_length_m"}) {
      followed.series.columns.push_back(std::string("compared_") + column);
      followed.series.values.push_back(other.series.column(column));
    }
    outcome.tables.push_back({"histogram_compared", other.histogram});
  }
  summary.steps = static_cast<std::int64_t>(followed.series.rows());
  outcome.tables.push_back({"series", std::move(followed.series)});
  outcome.tables.push_back({"histogram", std::move(followed.histogram)});
}

}  // namespace

Outcome compute_attrition(const AttritionCase& values, Session& session) {
  Outcome outcome;
  outcome.summary.simulated_s = values.duration;
  compute_lengths(values, outcome);
  session.recorder().note(fmt::format("L_N {:.4g} mm, L_W {:.4g} mm after {:.4g} s",
                                      1e3 * outcome.summary.number_average.value_or(0),
                                      1e3 * outcome.summary.weight_average.value_or(0), values.duration));
  return outcome;
}

}  // namespace fiberfate
