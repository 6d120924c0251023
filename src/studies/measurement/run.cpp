// Runs the study measurement: averages, intervals, histogram and orientation tensors of lists of fibers.
#include "studies/measurement/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/csv_table.hpp"
#include "microstructure/eigenframe.hpp"
#include "studies/measurement/length_tables.hpp"
#include "studies/measurement/lists.hpp"
#include "studies/summary_tensors.hpp"

namespace fiberfate {
namespace {

/// Pole figure: bins of equal solid angle on the upper half of the sphere.
constexpr int azimuth_bins = 24, height_bins = 6;

std::vector<double> histogram_edges(const MeasuredLengthChoices& choices, const MeasuredLengths& fibers) {
  if (!choices.bin_width) return even_edges(fibers, static_cast<int>(choices.bins));
  const double longest = *std::max_element(fibers.lengths.begin(), fibers.lengths.end());
  const double count = std::ceil(longest / *choices.bin_width - 1e-9);
  std::vector<double> edges;
  for (double k = 0; k <= count; ++k) edges.push_back(k * *choices.bin_width);
  return edges;
}

/// Draws samples until the run is stopped.
Resampling resampling(const StatisticsChoices& choices, const Session& session) {
  return {choices.level, static_cast<int>(choices.resamples), static_cast<std::uint64_t>(choices.seed),
          [&session] { session.end_if_stopped("stopped; resuming begins again"); }};
}

void append_interval(RunSummary& summary, const std::string& name, const Interval& interval) {
  summary.own.emplace_back(name + "_lower_m", interval.lower);
  summary.own.emplace_back(name + "_upper_m", interval.upper);
}

CsvTable histogram_table(const MeasuredLengthChoices& choices, const MeasuredLengths& measured,
                         const MeasuredLengths& fibers) {
  const LengthShares shares = length_shares(fibers, histogram_edges(choices, fibers));
  const LengthShares raw = length_shares(measured, shares.edges);
  const std::vector<double> deviations = share_deviations(fibers, shares);
  CsvTable table{{"length_low_m", "length_high_m", "number_share", "number_share_sd", "length_share",
                  "uncorrected_number_share"}};
  for (std::size_t k = 0; k + 1 < shares.edges.size(); ++k)
    table.append({shares.edges[k], shares.edges[k + 1], shares.by_number[k], deviations[k],
                  shares.by_length[k], raw.by_number[k]});
  return table;
}

/// Lists every length with the number of fibers it stands for, as fibers.distribution of other cases takes
/// it.
CsvTable distribution_table(const MeasuredLengths& fibers) {
  CsvTable table{{"length_m", "number"}, {fibers.lengths, fibers.numbers}};
  if (fibers.numbers.empty()) table.values[1].assign(fibers.lengths.size(), 1.0);
  return table;
}

void evaluate_lengths(const MeasurementCase& values, Outcome& outcome, Session& session) {
  RunSummary& summary = outcome.summary;
  const LengthList list = read_lengths(values.lengths);
  const MeasuredLengths& measured = list.fibers;
  session.recorder().note(fmt::format("{} lengths in column '{}'", measured.lengths.size(), list.column));
  if (const std::string text = list.left_out.text(); !text.empty()) session.recorder().note(text);
  const MeasuredLengths fibers = values.lengths.sample_diameter
                                     ? corrected_for_sampling(measured, *values.lengths.sample_diameter)
                                     : measured;
  const LengthIntervals intervals = bootstrap_mean_lengths(fibers, resampling(values.statistics, session));
  summary.number_average = intervals.number_average.estimate;
  summary.weight_average = intervals.weight_average.estimate;
  summary.own.emplace_back("measured_lengths", static_cast<std::int64_t>(measured.lengths.size()));
  summary.own.emplace_back("lengths_column", list.column);
  summary.own.emplace_back("left_out_empty_lines", static_cast<std::int64_t>(list.left_out.empty_lines));
  summary.own.emplace_back("left_out_zero_lengths", static_cast<std::int64_t>(list.left_out.zero_lengths));
  append_interval(summary, "L_N", intervals.number_average);
  append_interval(summary, "L_W", intervals.weight_average);
  summary.own.emplace_back("L_N_uncorrected_m", number_average(measured));
  summary.own.emplace_back("L_W_uncorrected_m", weight_average(measured));
  const auto [shortest, longest] = std::minmax_element(measured.lengths.begin(), measured.lengths.end());
  summary.own.emplace_back("shortest_m", *shortest);
  summary.own.emplace_back("longest_m", *longest);
  outcome.tables.push_back({"histogram", histogram_table(values.lengths, measured, fibers)});
  outcome.tables.push_back({"distribution", distribution_table(fibers)});
  append_distributions(fibers, histogram_edges(values.lengths, fibers), outcome);
}

/// How densely directions lie, over the mean; a direction and its opposite are one.
CsvTable pole_figure(const MeasuredDirections& fibers) {
  std::vector<double> density(azimuth_bins * height_bins, 0.0);
  double sum = 0;
  for (std::size_t i = 0; i < fibers.directions.size(); ++i) {
    Vec3 p = fibers.directions[i].normalized();
    if (p[2] < 0) p = -p;
    const double turn = std::atan2(p[1], p[0]) / (2 * std::acos(-1.0));
    const int azimuth =
        std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * azimuth_bins), azimuth_bins - 1);
    const int height = std::min(static_cast<int>(p[2] * height_bins), height_bins - 1);
    const double weight = fibers.weights.empty() ? 1 : fibers.weights[i];
    density[static_cast<std::size_t>(height * azimuth_bins + azimuth)] += weight;
    sum += weight;
  }
  CsvTable table{{"phi_deg", "cos_theta", "density"}};
  for (int k = 0; k < azimuth_bins * height_bins; ++k)
    table.append({(k % azimuth_bins + 0.5) * 360.0 / azimuth_bins, (k / azimuth_bins + 0.5) / height_bins,
                  density[k] * azimuth_bins * height_bins / sum});
  return table;
}

void evaluate_directions(const MeasurementCase& values, Outcome& outcome, Session& session) {
  RunSummary& summary = outcome.summary;
  const DirectionList list = read_directions(values.orientation);
  const MeasuredDirections& fibers = list.fibers;
  if (const std::string text = list.left_out.text(); !text.empty()) session.recorder().note(text);
  const OrientationInterval interval =
      bootstrap_second_moment(fibers, resampling(values.statistics, session));
  summary.orientation = interval.estimate;
  summary.own.emplace_back("measured_directions", static_cast<std::int64_t>(fibers.directions.size()));
  summary.own.emplace_back("A2_lower", interval.lower);
  summary.own.emplace_back("A2_upper", interval.upper);
  const Vec3 principal = eigenframe(interval.estimate).values;
  summary.own.emplace_back("principal_values", std::vector<double>(principal.begin(), principal.end()));
  summary.own.emplace_back("A4", components(fourth_moment(fibers)));
  outcome.tables.push_back({"directions", pole_figure(fibers)});
}

}  // namespace

Outcome compute_measurement(const MeasurementCase& values, Session& session) {
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  summary.seed = static_cast<std::uint64_t>(values.statistics.seed);
  if (!values.lengths.file.empty()) {
    evaluate_lengths(values, outcome, session);
    outcome.headlines.push_back(fmt::format("L_N {:.4g} mm, L_W {:.4g} mm", 1e3 * *summary.number_average,
                                            1e3 * *summary.weight_average));
  }
  if (!values.orientation.file.empty()) {
    evaluate_directions(values, outcome, session);
    const Vec3 diagonal = summary.orientation->diagonal();
    outcome.headlines.push_back(
        fmt::format("a_11 {:.4f}, a_22 {:.4f}, a_33 {:.4f}", diagonal[0], diagonal[1], diagonal[2]));
  }
  return outcome;
}

}  // namespace fiberfate
