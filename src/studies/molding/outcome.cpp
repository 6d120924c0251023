// What a filling came to.
#include "studies/molding/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "calibration/length_sweep.hpp"
#include "molding/filling_account.hpp"
#include "studies/length_choices.hpp"
#include "studies/molding/observables.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t histogram_bins = 30;
using Samples = std::vector<std::vector<Index>>;  ///< nodes of the sample at every place

/// Averages a value by node over a sample, by volume.
double sample_mean(const MoldingFields& fields, const std::vector<Index>& nodes,
                   const std::vector<double>& values) {
  double sum = 0, weights = 0;
  for (const Index index : nodes) {
    const std::size_t node = index;
    if (!fields.is_wet(node)) continue;
    const double volume = fields.filling().mesh().volume(node);
    sum += volume * values[node];
    weights += volume;
  }
  return sum / weights;  // NaN where there is no melt
}

/// Finds the node nearest to a place.
std::size_t nearest_to(const MoldingFields& fields, std::size_t place) {
  return fields.filling().mesh().nearest_node(
      position_of(fields.values().output.places[place], fields.setup().part));
}

/// Measures every place with every set of length laws.
std::vector<PlaceSample> place_samples(const MoldingFields& fields, const Samples& samples) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const FillingState& state = fields.filling().state();
  const std::vector<double> temperature = fields.filling().gap_average(state.temperature);
  const std::vector<double>& swept = fields.setup().sweep_values;
  std::vector<PlaceSample> all;
  for (std::size_t place = 0; place < samples.size(); ++place) {
    const std::vector<Index>& nodes = samples[place];
    PlaceSample sample = {place,
                          0,
                          nan,
                          state.fill_time[nearest_to(fields, place)],
                          sample_mean(fields, nodes, temperature),
                          {nan, nan},
                          {nan, nan},
                          {nan, nan}};
    if (fields.set_count() == 0) all.push_back(sample);
    for (std::size_t set = 0; set < fields.set_count(); ++set) {
      sample.set = set;
      sample.value = set >= 1 && set <= swept.size() ? swept[set - 1] : nan;
      sample.means = fields.means(set, nodes);
      sample.of_sample = fields.sample_means(set, nodes);
      sample.of_gap = fields.gap_means(set, nodes);
      all.push_back(sample);
    }
  }
  return all;
}

/// One row a place and layer, from the mid-plane to the wall, at the node nearest to the place.
CsvTable profiles_table(const MoldingFields& fields) {
  CsvTable table{columns_of(profile_observables())};
  const Filling& filling = fields.filling();
  const std::vector<double> viscosity = filling.viscosity();
  const std::size_t layers = filling.layers().count();
  const std::vector<NamedPlace>& places = fields.values().output.places;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const std::size_t node = nearest_to(fields, p);
    for (std::size_t layer = 0; layer < layers && fields.is_wet(node); ++layer)
      table.append(
          measure(profile_observables(), GapPoint{fields, node, layer, viscosity[node * layers + layer], p}));
  }
  return table;
}

/// Histograms of the inlet, place -1, and of every place, by the first law and the compared one.
CsvTable histogram_table(const MoldingFields& fields, const Samples& samples) {
  CsvTable table{{"place", "set", "length_low_m", "length_high_m", "number_share", "length_share"}};
  const LengthClasses inlet = fields.inlet_population();
  // Transport may lengthen a class by round-off.
  const double longest = (1 + 1e-9) * *std::max_element(inlet.lengths.begin(), inlet.lengths.end());
  std::vector<double> edges;
  for (std::size_t i = 0; i <= histogram_bins; ++i)
    edges.push_back(longest * static_cast<double>(i) / static_cast<double>(histogram_bins));
  std::vector<int> sets = {0};
  if (fields.setup().compared_set > 0) sets.push_back(fields.setup().compared_set);
  for (const double set : sets) {
    append_length_shares(table, {-1, set}, inlet, edges);
    for (std::size_t p = 0; p < samples.size(); ++p) {
      const LengthClasses all = fields.population(set, samples[p]);
      if (!all.lengths.empty()) append_length_shares(table, {static_cast<double>(p), set}, all, edges);
    }
  }
  return table;
}

/// The measured samples of every place and mean with what the sweep predicts there.
std::vector<SweptLength> swept_lengths(const MoldingFields& fields, const std::vector<PlaceSample>& samples) {
  const std::vector<NamedPlace>& places = fields.values().output.places;
  std::vector<SweptLength> lengths;
  for (std::size_t place = 0; place < places.size(); ++place)
    for (const LengthMean mean : length_means) {
      SweptLength one;
      for (const MeasuredLength& measured : fields.values().sweep.measured)
        if (measured.place == places[place].name && measured.mean == mean)
          one.measured.push_back(measured.length);
      if (one.measured.empty()) continue;
      for (const PlaceSample& sample : samples)
        if (sample.place == place && std::isfinite(sample.value))
          one.predicted.push_back(sample.means.at(mean));
      lengths.push_back(std::move(one));
    }
  return lengths;
}

void add_sweep(const MoldingFields& fields, const std::vector<PlaceSample>& samples, Outcome& out) {
  const std::vector<double>& values = fields.setup().sweep_values;
  if (values.empty()) return;
  const std::vector<SweptLength> lengths = swept_lengths(fields, samples);
  const bool all_wet = std::ranges::all_of(
      lengths, [](const SweptLength& one) { return std::isfinite(one.predicted.front()); });
  if (lengths.empty() || !all_wet) return;
  const SweepOutcome outcome = evaluate_sweep(values, lengths);
  out.tables.push_back({"sweep", {{"value", "average_error_percent"}, {values, outcome.errors}}});
  auto& own = out.summary.own;
  own.emplace_back("sweep_parameter", fields.values().sweep.parameter);
  own.emplace_back("sweep_best_value", outcome.best_value);
  own.emplace_back("sweep_best_error_percent", outcome.best_error);
  own.emplace_back("sweep_least_squares_value", outcome.least_squares_value);
  own.emplace_back("sweep_least_squares_scatter", outcome.least_squares_error);
  own.emplace_back("sweep_least_squares_log_error", outcome.standard_error);
}

/// Adds what the places have, each key after the place's name: Loc_1_fill_time_s, Loc_1_compared_L_N_m.
void add_places(const MoldingFields& fields, const std::vector<PlaceSample>& samples, RunSummary& summary) {
  for (const PlaceSample& sample : samples) {
    const bool first = sample.set == 0;
    if (!first && static_cast<int>(sample.set) != fields.setup().compared_set) continue;
    const std::string prefix =
        key_part(fields.values().output.places[sample.place].name) + (first ? "_" : "_compared_");
    RunSummary of_place;
    summarise(place_observables(), sample, of_place);
    for (const auto& [key, value] : of_place.own)
      if (key.starts_with("L_") ? fields.set_count() > 0 : first)
        summary.own.emplace_back(prefix + key, value);
  }
}

/// Adds when what happened; what happens again gets a number: G1_gate_opened_2_s.
void add_events(const Filling& filling, RunSummary& summary) {
  const FillingParams& params = filling.params();
  std::map<std::string, int> counts;
  for (const FillingEvent& event : filling.state().events) {
    std::string key = name(event.kind);
    if (event.gate >= 0) key = key_part(params.gates[event.gate].name) + '_' + key;
    const int count = ++counts[key];
    if (count > 1) key += fmt::format("_{}", count);
    summary.own.emplace_back(key + "_s", event.time);
  }
  for (std::size_t i = 0; i < params.sensors.size(); ++i)
    summary.own.emplace_back(key_part(params.sensors[i].name) + "_arrival_s",
                             filling.state().sensor_arrivals[i]);
}

void add_filling(const MoldingFields& fields, const MoldingRecord& record, RunSummary& summary) {
  const Filling& filling = fields.filling();
  const FillingState& state = filling.state();
  auto& own = summary.own;
  own.emplace_back("filling_end", std::string(name(state.stop_reason)));
  summarise(part_observables(), moment_of(filling, record.greatest_pressure), summary);
  const auto last = std::find(state.mark.begin(), state.mark.end(), NodeMark::last_filled);
  for (int axis = 0; axis < 3 && last != state.mark.end(); ++axis)
    own.emplace_back(fmt::format("last_filled_{}_m", "xyz"[axis]),
                     filling.mesh().shell().nodes[last - state.mark.begin()][axis]);
  add_events(filling, summary);
  for (std::size_t phase = 0; phase < filling_phase_count; ++phase)
    own.emplace_back(std::string("filling_") + filling_phase_names[phase] + "_s",
                     filling.seconds(static_cast<FillingPhase>(phase)));
}

}  // namespace

Outcome gather_outcome(const MoldingFields& fields, const MoldingRecord& record) {
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  add_filling(fields, record, summary);
  if (fields.setup().params.fibers.orientation) summary.orientation = part_orientation(fields.filling());
  if (fields.set_count() > 0) {
    std::vector<Index> all(fields.filling().mesh().node_count());
    std::iota(all.begin(), all.end(), 0);
    const MeanLengths means = fields.means(0, all);
    summary.number_average = means.number_average;
    summary.weight_average = means.weight_average;
  }
  Samples samples;
  for (const NamedPlace& place : fields.values().output.places) samples.push_back(fields.sample_at(place));
  if (samples.empty()) return outcome;
  const std::vector<PlaceSample> places = place_samples(fields, samples);
  CsvTable table{columns_of(place_observables())};
  for (const PlaceSample& place : places) table.append(measure(place_observables(), place));
  outcome.tables.push_back({"places", std::move(table)});
  outcome.tables.push_back({"profiles", profiles_table(fields)});
  if (fields.set_count() > 0 && !fields.values().fibers.distribution.empty())
    outcome.tables.push_back({"histogram", histogram_table(fields, samples)});
  add_places(fields, places, summary);
  add_sweep(fields, places, outcome);
  return outcome;
}

}  // namespace fiberfate
