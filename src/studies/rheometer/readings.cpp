// What a run of a cell is read for.
#include "studies/rheometer/readings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "calibration/block_average.hpp"

namespace fiberfate {
namespace {

constexpr std::array<ErrorColumns, 4> with_errors = {
    {{"relative_viscosity", "relative_viscosity_error"},
     {"N1_Pa", "N1_error_Pa"},
     {"N2_Pa", "N2_error_Pa"},
     {"elongational_viscosity_Pa_s", "elongational_viscosity_error_Pa_s"}}};
constexpr std::array<const char*, 6> pairs = {"11", "22", "33", "23", "31", "12"};  // of a Mat6

/// A component of a symmetric tensor of any order by its indices, whatever their order.
std::string sorted(std::string indices) {
  std::sort(indices.begin(), indices.end());
  return indices;
}

/// Whether a column of series.csv is a component of A2 or A4, weighted by length.
bool is_orientation(const std::string& column) {
  return column.front() == 'a' && (column.size() == 3 || column.size() == 5) &&
         std::all_of(column.begin() + 1, column.end(), [](char c) { return c >= '1' && c <= '3'; });
}

/// Whether a column is a component of the whole particle stress: "stress_11_Pa".
bool is_stress(const std::string& column) {
  return column.starts_with("stress_") && column.size() == std::string("stress_11_Pa").size();
}

bool is_averaged(const std::string& column) {
  const auto same = [&column](const ErrorColumns& one) { return column == one.mean; };
  return std::any_of(with_errors.begin(), with_errors.end(), same) || is_stress(column) ||
         is_orientation(column);
}

/// Values of one column of a history from a time on, where they are numbers.
std::vector<double> stationary(std::span<const double> history, std::size_t column, double from) {
  const std::size_t width = averaged_observables().size() + 1;
  std::vector<double> values;
  for (std::size_t row = 0; row + width <= history.size(); row += width)
    if (history[row] > from && std::isfinite(history[row + 1 + column]))
      values.push_back(history[row + 1 + column]);
  return values;
}

/// How much larger the mean of the last half of values is than that of the first half; NaN for fewer than
/// two.
double drift(std::span<const double> values) {
  const std::size_t half = values.size() / 2;
  if (half == 0) return std::numeric_limits<double>::quiet_NaN();
  return block_mean(values.last(half)).mean - block_mean(values.first(half)).mean;
}

double planned_length(const SampleCase& sample) {
  return sample.cluster.source == ClusterSource::file ? std::numeric_limits<double>::quiet_NaN()
                                                      : number_average(length_law(sample.fibers));
}

Mat6 fourth_tensor(const CsvTable& readings, std::size_t row) {
  Mat6 fourth;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const std::string wanted = sorted(std::string(pairs[i]) + pairs[j]);
      const auto found = std::find_if(
          readings.columns.begin(), readings.columns.end(), [&wanted](const std::string& column) {
            return column.size() == 5 && is_orientation(column) && sorted(column.substr(1)) == wanted;
          });
      fourth(i, j) = readings.values[found - readings.columns.begin()][row];
    }
  return fourth;
}

}  // namespace

std::span<const ErrorColumns> columns_with_errors() {
  return with_errors;
}

const Observables<CellMoment>& averaged_observables() {
  static const Observables<CellMoment> averaged = [] {
    Observables<CellMoment> some;
    for (const Observable<CellMoment>& one : cell_observables())
      if (is_averaged(one.column)) some.push_back(one);
    return some;
  }();
  return averaged;
}

const std::vector<std::string>& reading_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> all = {"point",          "replica",         "seed",     "flow",   "rate_per_s",
                                    "viscosity_Pa_s", "volume_fraction", "length_m", "strain", "rows"};
    for (const std::string& column : columns_of(averaged_observables())) all.push_back(column);
    for (const ErrorColumns& one : with_errors) all.emplace_back(one.error);
    all.insert(all.end(), {"relative_viscosity_drift", "L_N_m", "L_W_m", "breaks"});
    return all;
  }();
  return columns;
}

std::vector<double> reading_row(const RunPlace& place, const CellMoment& last,
                                std::span<const double> history) {
  const ShearCellCase& cell = last.values;
  const double from = stationary_from(cell);
  const Observables<CellMoment>& averaged = averaged_observables();
  std::vector<double> means, errors;
  std::size_t rows = 0;
  double viscosity_drift = 0;
  for (std::size_t i = 0; i < averaged.size(); ++i) {
    const std::vector<double> values = stationary(history, i, from);
    const BlockMean mean = block_mean(values);
    if (averaged[i].column == with_errors.front().mean) viscosity_drift = drift(values);
    const bool is_known = mean.values > 0;
    rows = std::max(rows, mean.values);
    means.push_back(is_known ? mean.mean : std::numeric_limits<double>::quiet_NaN());
    for (const ErrorColumns& one : with_errors)
      if (averaged[i].column == one.mean)
        errors.push_back(is_known ? mean.error : std::numeric_limits<double>::quiet_NaN());
  }
  std::vector<double> row = {static_cast<double>(place.point),
                             static_cast<double>(place.replica),
                             static_cast<double>(cell.run.seed),
                             static_cast<double>(cell.flow.type),
                             last.rate,
                             last.flow.viscosity,
                             volume_fraction(last.state),
                             planned_length(cell.sample),
                             last.strain,
                             static_cast<double>(rows)};
  row.insert(row.end(), means.begin(), means.end());
  row.insert(row.end(), errors.begin(), errors.end());
  row.insert(row.end(), {viscosity_drift, last.lengths.number_average, last.lengths.weight_average,
                         static_cast<double>(last.state.breaks)});
  return row;
}

StressReading stress_reading(const RheometerCase& values, const CsvTable& readings, std::size_t row) {
  const auto at = [&](const std::string& column) { return readings.column(column)[row]; };
  const RheometerPoint point = points(values.sweep).at(static_cast<std::size_t>(at("point")));
  StressReading reading;
  reading.viscosity = at("viscosity_Pa_s");
  reading.volume_fraction = at("volume_fraction");
  reading.strain_rate = flow_history(cell_at(values, point, 0).flow).at(0).rate_of_strain();
  reading.fourth = fourth_tensor(readings, row);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const std::string pair = std::to_string(std::min(i, j) + 1) + std::to_string(std::max(i, j) + 1);
      reading.stress(i, j) = at("stress_" + pair + "_Pa");
    }
  reading.relative_viscosity = at("relative_viscosity");
  return reading;
}

}  // namespace fiberfate
