// What a filling came to.
#include "studies/molding/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

#include "continuum/length_classes.hpp"
#include "io/csv_table.hpp"
#include "microstructure/tensor.hpp"
#include "studies/molding/sweep.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t histogram_bins = 30;

CsvTable empty_table(std::vector<std::string> columns) {
  CsvTable table;
  table.columns = std::move(columns);
  table.values.resize(table.columns.size());
  return table;
}

void append_row(CsvTable& table, const std::vector<double>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) table.values[i].push_back(row[i]);
}

/// Makes a name that can be part of a key: "Loc. 1" becomes "Loc__1".
std::string key_of(const std::string& name) {
  std::string key;
  for (const char letter : name) key += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return key;
}

/// Averages a value by node over a sample, by volume.
template <class Value>
double sample_mean(const MoldingFields& fields, const std::vector<Index>& nodes, const Value& value) {
  double sum = 0, weights = 0;
  for (const Index index : nodes) {
    const auto node = static_cast<std::size_t>(index);
    if (!fields.is_wet(node)) continue;
    const double volume = fields.filling().mesh().volume(node);
    sum += volume * value(node);
    weights += volume;
  }
  return sum / weights;  // NaN where there is no melt
}

/// The mean lengths of a place: those that measurements are compared with, those of all fibers of the
/// sample, and the means over the gap.
constexpr const char* place_lengths[] = {"L_N_m",        "L_W_m",          "L_N_sample_m",
                                         "L_W_sample_m", "L_N_gap_mean_m", "L_W_gap_mean_m"};

std::array<double, std::size(place_lengths)> lengths_at(const MoldingFields& fields, std::size_t set,
                                                        const std::vector<Index>& sample) {
  std::array<double, std::size(place_lengths)> lengths;
  lengths.fill(std::nan(""));
  if (fields.set_count() == 0) return lengths;
  const MeanLengths all[] = {fields.means(set, sample), fields.sample_means(set, sample),
                             fields.gap_means(set, sample)};
  for (std::size_t i = 0; i < std::size(all); ++i) {
    lengths[2 * i] = all[i].number_average;
    lengths[2 * i + 1] = all[i].weight_average;
  }
  return lengths;
}

/// One row a place and length set: the sweep's value, fill time, temperature, mean lengths.
CsvTable places_table(const MoldingFields& fields, const std::vector<std::vector<Index>>& samples) {
  std::vector<std::string> columns = {"place", "set", "value", "fill_time_s", "temperature_K"};
  columns.insert(columns.end(), std::begin(place_lengths), std::end(place_lengths));
  CsvTable table = empty_table(std::move(columns));
  const FillingState& state = fields.filling().state();
  const std::vector<double> temperature = fields.filling().gap_average(state.temperature);
  for (std::size_t p = 0; p < samples.size(); ++p) {
    const double fill =
        sample_mean(fields, samples[p], [&](std::size_t node) { return state.fill_time[node]; });
    const double heat = sample_mean(fields, samples[p], [&](std::size_t node) { return temperature[node]; });
    for (std::size_t set = 0; set < std::max<std::size_t>(1, fields.set_count()); ++set) {
      const std::vector<double>& swept = fields.setup().sweep_values;
      const double value = set >= 1 && set <= swept.size() ? swept[set - 1] : std::nan("");
      std::vector<double> row = {static_cast<double>(p), static_cast<double>(set), value, fill, heat};
      const auto lengths = lengths_at(fields, set, samples[p]);
      row.insert(row.end(), lengths.begin(), lengths.end());
      append_row(table, row);
    }
  }
  return table;
}

/// One row a place and layer, from the mid-plane to the wall, at the node nearest to the place.
CsvTable profiles_table(const MoldingFields& fields) {
  CsvTable table = empty_table({"place", "height", "z_m", "temperature_K", "rate_per_s", "viscosity_Pa_s",
                                "a11", "a22", "a33", "a23", "a31", "a12", "L_N_m", "L_W_m"});
  const Filling& filling = fields.filling();
  const std::vector<double> viscosity = filling.viscosity();
  const std::size_t layers = filling.layers().count();
  const std::vector<NamedPlace>& places = fields.values().output.places;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const std::size_t node = filling.mesh().nearest_node(position_of(places[p], fields.setup().part));
    if (!fields.is_wet(node)) continue;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      const std::size_t point = node * layers + layer;
      const double height = filling.layers().middles()[layer];
      std::vector<double> row = {static_cast<double>(p),
                                 height,
                                 0.5 * height * filling.mesh().thickness(node),
                                 filling.state().temperature[point],
                                 filling.state().rate[point],
                                 viscosity[point]};
      const Vec6 second = fields.setup().params.fibers.orientation
                              ? to_components(filling.orientation(node, layer))
                              : Vec6::Constant(std::nan(""));
      row.insert(row.end(), second.begin(), second.end());
      const MeanLengths means =
          fields.set_count() == 0 ? MeanLengths{std::nan(""), std::nan("")} : fields.means(0, node, layer);
      row.push_back(means.number_average);
      row.push_back(means.weight_average);
      append_row(table, row);
    }
  }
  return table;
}

/// Adds the histogram of a population as shares; place -1 is the inlet.
void append_histogram(CsvTable& table, double place, double set, const LengthClasses& population,
                      const std::vector<double>& edges) {
  LengthClasses by_length = population;
  for (std::size_t i = 0; i < by_length.numbers.size(); ++i) by_length.numbers[i] *= by_length.lengths[i];
  const std::vector<double> numbers = histogram(population, edges), lengths = histogram(by_length, edges);
  const double all = std::accumulate(population.numbers.begin(), population.numbers.end(), 0.0);
  const double length = total_length(population);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    append_row(table, {place, set, edges[i], edges[i + 1], numbers[i] / all, lengths[i] / length});
}

CsvTable histogram_table(const MoldingFields& fields, const std::vector<std::vector<Index>>& samples) {
  CsvTable table =
      empty_table({"place", "set", "length_low_m", "length_high_m", "number_share", "length_share"});
  const LengthClasses inlet = fields.inlet_population();
  // Transport may lengthen a class by round-off.
  const double longest = (1 + 1e-9) * *std::max_element(inlet.lengths.begin(), inlet.lengths.end());
  std::vector<double> edges;
  for (std::size_t i = 0; i <= histogram_bins; ++i)
    edges.push_back(longest * static_cast<double>(i) / static_cast<double>(histogram_bins));
  std::vector<std::size_t> sets = {0};
  if (fields.setup().compared_set > 0) sets.push_back(static_cast<std::size_t>(fields.setup().compared_set));
  for (const std::size_t set : sets) {
    append_histogram(table, -1, static_cast<double>(set), inlet, edges);
    for (std::size_t p = 0; p < samples.size(); ++p) {
      LengthClasses all;
      for (const Index node : samples[p]) {
        const LengthClasses one = fields.population(set, static_cast<std::size_t>(node));
        all.lengths.insert(all.lengths.end(), one.lengths.begin(), one.lengths.end());
        const double volume = fields.filling().mesh().volume(static_cast<std::size_t>(node));
        for (const double number : one.numbers) all.numbers.push_back(number * volume);
        all.width = one.width;
      }
      if (!all.lengths.empty())
        append_histogram(table, static_cast<double>(p), static_cast<double>(set), all, edges);
    }
  }
  return table;
}

/// The samples of every place and mean with what the sweep predicts there.
std::vector<SweptLength> swept_lengths(const MoldingFields& fields,
                                       const std::vector<std::vector<Index>>& samples) {
  const std::vector<NamedPlace>& places = fields.values().output.places;
  std::vector<SweptLength> lengths;
  for (std::size_t place = 0; place < places.size(); ++place)
    for (const MeasuredMean mean : {MeasuredMean::number_average, MeasuredMean::weight_average}) {
      SweptLength one;
      for (const MeasuredLength& measured : fields.values().sweep.measured)
        if (measured.place == places[place].name && measured.mean == mean)
          one.measured.push_back(measured.length);
      if (one.measured.empty()) continue;
      for (std::size_t i = 0; i < fields.setup().sweep_values.size(); ++i) {
        const MeanLengths means = fields.means(i + 1, samples[place]);
        one.predicted.push_back(mean == MeasuredMean::number_average ? means.number_average
                                                                     : means.weight_average);
      }
      lengths.push_back(std::move(one));
    }
  return lengths;
}

void add_sweep(const MoldingFields& fields, const std::vector<std::vector<Index>>& samples, Outcome& out) {
  RunSummary& summary = out.summary;
  const std::vector<double>& values = fields.setup().sweep_values;
  const std::vector<SweptLength> lengths = swept_lengths(fields, samples);
  const bool all_wet = std::all_of(lengths.begin(), lengths.end(), [](const SweptLength& one) {
    return std::isfinite(one.predicted.front());
  });
  if (values.empty() || lengths.empty() || !all_wet) return;
  const SweepOutcome outcome = evaluate_sweep(values, lengths);
  CsvTable table = empty_table({"value", "average_error_percent"});
  for (std::size_t i = 0; i < values.size(); ++i) append_row(table, {values[i], outcome.errors[i]});
  out.tables.push_back({"sweep", std::move(table)});
  summary.own.emplace_back("sweep_parameter", fields.values().sweep.parameter);
  summary.own.emplace_back("sweep_best_value", outcome.best_value);
  summary.own.emplace_back("sweep_best_error_percent", outcome.best_error);
  summary.own.emplace_back("sweep_least_squares_value", outcome.least_squares_value);
  summary.own.emplace_back("sweep_least_squares_scatter", outcome.least_squares_error);
  summary.own.emplace_back("sweep_least_squares_log_error", outcome.standard_error);
}

Mat3 part_orientation(const MoldingFields& fields) {
  Mat3 sum = Mat3::Zero();
  double volume = 0;
  for (std::size_t i = 0; i < fields.filling().mesh().node_count(); ++i) {
    if (!fields.is_wet(i)) continue;
    const double filled = fields.filling().mesh().volume(i) * fields.filling().state().filled[i];
    sum += filled * fields.filling().mean_orientation(i);
    volume += filled;
  }
  return sum / volume;
}

void add_places(const MoldingFields& fields, const CsvTable& places, RunSummary& summary) {
  for (std::size_t i = 0; i < places.rows(); ++i) {
    const auto set = static_cast<int>(places.column("set")[i]);
    if (set != 0 && set != fields.setup().compared_set) continue;
    const auto place = static_cast<std::size_t>(places.column("place")[i]);
    const std::string prefix =
        key_of(fields.values().output.places[place].name) + (set == 0 ? "_" : "_compared_");
    if (set == 0) {
      summary.own.emplace_back(prefix + "fill_time_s", places.column("fill_time_s")[i]);
      summary.own.emplace_back(prefix + "temperature_K", places.column("temperature_K")[i]);
    }
    if (fields.set_count() == 0) continue;
    for (const char* length : place_lengths)
      summary.own.emplace_back(prefix + length, places.column(length)[i]);
  }
}

std::int64_t count_marks(const FillingState& state, NodeMark mark) {
  return std::count(state.mark.begin(), state.mark.end(), mark);
}

/// Adds when what happened; what happens again gets a number: G1_gate_opened_2_s.
void add_events(const Filling& filling, RunSummary& summary) {
  const FillingParams& params = filling.params();
  std::map<std::string, int> counts;
  for (const FillingEvent& event : filling.state().events) {
    std::string key = name(event.kind);
    if (event.gate >= 0) key = key_of(params.gates[static_cast<std::size_t>(event.gate)].name) + '_' + key;
    const int count = ++counts[key];
    if (count > 1) key += fmt::format("_{}", count);
    summary.own.emplace_back(key + "_s", event.time);
  }
  for (std::size_t i = 0; i < params.sensors.size(); ++i)
    summary.own.emplace_back(key_of(params.sensors[i].name) + "_arrival_s",
                             filling.state().sensor_arrivals[i]);
}

void add_filling(const MoldingFields& fields, const MoldingRecord& record, RunSummary& summary) {
  const Filling& filling = fields.filling();
  const FillingState& state = filling.state();
  auto& own = summary.own;
  own.emplace_back("filling_end", std::string(name(state.stop_reason)));
  own.emplace_back("filled_fraction", filling.filled_fraction());
  own.emplace_back("nodes", static_cast<std::int64_t>(filling.mesh().node_count()));
  own.emplace_back("triangles", static_cast<std::int64_t>(filling.mesh().triangle_count()));
  own.emplace_back("volume_m3", filling.mesh().total_volume());
  own.emplace_back("area_m2", filling.mesh().total_area());
  own.emplace_back("injected_volume_m3", state.injected_volume);
  const double excess = std::accumulate(state.excess.begin(), state.excess.end(), 0.0);
  own.emplace_back("volume_error",
                   (state.injected_volume - state.filled_volume - excess) / filling.mesh().total_volume());
  own.emplace_back("sprue_pressure_Pa", state.sprue_pressure);
  own.emplace_back("greatest_sprue_pressure_Pa", record.greatest_pressure);
  const double supplied = state.heat.brought_in + state.heat.dissipated;
  own.emplace_back("heat_error", (supplied - state.heat.to_mold - filling.stored_heat()) / supplied);
  own.emplace_back("weld_line_nodes", count_marks(state, NodeMark::weld_line));
  own.emplace_back("air_traps", count_marks(state, NodeMark::air_trap));
  const auto last = std::find(state.mark.begin(), state.mark.end(), NodeMark::last_filled);
  for (int axis = 0; axis < 3 && last != state.mark.end(); ++axis)
    own.emplace_back(fmt::format("last_filled_{}_m", "xyz"[axis]),
                     filling.mesh().shell().nodes[static_cast<std::size_t>(last - state.mark.begin())][axis]);
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
  std::vector<std::vector<Index>> samples;
  for (const NamedPlace& place : fields.values().output.places) samples.push_back(fields.sample_at(place));
  if (fields.setup().params.fibers.orientation) summary.orientation = part_orientation(fields);
  if (fields.set_count() > 0) {
    std::vector<Index> all(fields.filling().mesh().node_count());
    std::iota(all.begin(), all.end(), 0);
    const MeanLengths means = fields.means(0, all);
    summary.number_average = means.number_average;
    summary.weight_average = means.weight_average;
  }
  if (samples.empty()) return outcome;
  const CsvTable places = places_table(fields, samples);
  outcome.tables.push_back({"places", places});
  outcome.tables.push_back({"profiles", profiles_table(fields)});
  if (fields.set_count() > 0 && !fields.values().fibers.distribution.empty())
    outcome.tables.push_back({"histogram", histogram_table(fields, samples)});
  add_places(fields, places, summary);
  add_sweep(fields, samples, outcome);
  return outcome;
}

}  // namespace fiberfate
