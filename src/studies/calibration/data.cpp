// Reads measured series from CSV files and single values from the case.
#include "studies/calibration/data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/error.hpp"
#include "base/units.hpp"
#include "io/delimited_table.hpp"
#include "io/input_file.hpp"
#include "studies/calibration/molds.hpp"

namespace fiberfate {
namespace {

struct Quantity {
  const char* name;
  const char* column;  ///< of a CSV file; empty: a single value
  const char* unit;
  Observed observed;
  int row = 0, column_of_tensor = 0;
};

constexpr Quantity quantities[] = {{"L_N", "L_N_m", "m", Observed::number_average},
                                   {"L_W", "L_W_m", "m", Observed::weight_average},
                                   {"L_inf", "", "m", Observed::final_length},
                                   {"k_f", "", "1/s", Observed::rate_constant},
                                   {"histogram", "number_share", "1", Observed::histogram},
                                   {"a11", "a11", "1", Observed::orientation, 0, 0},
                                   {"a22", "a22", "1", Observed::orientation, 1, 1},
                                   {"a33", "a33", "1", Observed::orientation, 2, 2},
                                   {"a12", "a12", "1", Observed::orientation, 0, 1},
                                   {"a13", "a13", "1", Observed::orientation, 0, 2},
                                   {"a23", "a23", "1", Observed::orientation, 1, 2}};

const Quantity& quantity_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Quantity& one : quantities) {
    if (one.name == name) return one;
    names.emplace_back(one.name);
  }
  throw InputError(fmt::format("there is no quantity '{}'", name),
                   fmt::format("give one of {}", fmt::join(names, ", ")));
}

double value_in(const std::string& text, const std::string& unit) {
  try {
    return quantity_in_si(text, unit);
  } catch (const std::invalid_argument& problem) {
    throw InputError(problem.what(), fmt::format("give a value in {}", unit));
  }
}

/// What a column's heading says: the quantity and its unit, of "L_N_mm", "L_N [mm]" or "L_N (mm)".
struct Heading {
  std::string quantity, unit;
};
Heading parts_of(const std::string& heading) {
  if (std::string unit = unit_in_heading(heading); !unit.empty())
    return {heading_without_unit(heading), std::move(unit)};
  const std::size_t end = heading.rfind('_');
  return end == std::string::npos ? Heading{heading, ""}
                                  : Heading{heading.substr(0, end), heading.substr(end + 1)};
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Reads the numbers of a quantity in SI; nothing where no heading names it in a unit of this kind.
std::optional<std::vector<double>> numbers_of(const DelimitedTable& table, const std::string& quantity,
                                              const std::string& si_unit) {
  for (std::size_t column = 0; column < table.columns(); ++column) {
    const Heading heading = parts_of(table.headings()[column]);
    if (lower(heading.quantity) != lower(quantity)) continue;
    const std::optional<double> factor = factor_of_unit(heading.unit, si_unit);
    if (!factor) continue;
    std::vector<double> numbers = table.numbers(column);
    for (double& number : numbers) number *= *factor;
    return numbers;
  }
  return std::nullopt;
}

/// Reads the numbers of a quantity in SI; raises InputError that lists the columns when there is none.
std::vector<double> required_numbers(const DelimitedTable& table, const std::string& quantity,
                                     const std::string& si_unit) {
  if (std::optional<std::vector<double>> found = numbers_of(table, quantity, si_unit))
    return *std::move(found);
  throw InputError(
      {{table.path(), 1, 1, "", "", fmt::format("no column is {} in a unit of '{}'", quantity, si_unit),
        fmt::format("name one '{0}_{1}' or '{0} [{1}]'; its columns are {2}", quantity, si_unit,
                    table.listed_headings())}});
}

void read_histogram(const DelimitedTable& table, const std::string& time, MeasuredSeries& series) {
  const std::vector<double> low = required_numbers(table, "length_low", "m");
  const std::vector<double> high = required_numbers(table, "length_high", "m");
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (!(low[i] < high[i]) || (i > 0 && low[i] != high[i - 1]))
      throw InputError("the bins of a histogram do not join",
                       "let every bin begin where the one before ends");
    series.edges.push_back(low[i]);
  }
  if (!high.empty()) series.edges.push_back(high.back());
  series.times.assign(low.size(), value_in(time, "s"));
}

void read_file(const std::vector<std::string>& row, const Quantity& quantity, MeasuredSeries& series) {
  const DelimitedTable table(row[2]);
  const bool has_unit =
      quantity.observed == Observed::number_average || quantity.observed == Observed::weight_average;
  series.values = has_unit ? required_numbers(table, quantity.name, quantity.unit)
                           : table.numbers(table.column_named(quantity.column));
  if (quantity.observed == Observed::histogram) {
    if (row.size() < 4)
      throw InputError("a histogram has no time", "give rows [condition, \"histogram\", file, time]");
    read_histogram(table, row[3], series);
  } else {
    series.times = required_numbers(table, "time", "s");
  }
  const std::string deviations = std::string(quantity.column) + "_sd";
  if (table.has_column(deviations))
    series.deviations = table.numbers(table.column_named(deviations));
  else if (has_unit)
    series.deviations =
        numbers_of(table, std::string(quantity.name) + "_sd", quantity.unit).value_or(series.deviations);
  for (const double time : series.times)
    if (!(time >= 0)) throw InputError("a time is negative", "count times from the start of the condition");
}

/// Lengths and rate constants are positive, shares of a histogram not negative, components of A2 at most 1.
void require_possible(const MeasuredSeries& series) {
  const auto is_possible = [&series](double value) {
    if (series.observed == Observed::orientation) return std::abs(value) <= 1;
    return series.observed == Observed::histogram ? value >= 0 : value > 0;
  };
  for (const double value : series.values)
    if (!is_possible(value))
      throw InputError(fmt::format("{:g} is no possible value of {}", value, series.name),
                       "leave out what could not be measured");
}

void fill_deviations(const CalibrationData& data, MeasuredSeries& series) {
  if (!series.deviations.empty()) return;
  const bool absolute = series.observed == Observed::orientation || series.observed == Observed::histogram;
  for (const double value : series.values)
    series.deviations.push_back(absolute ? data.absolute_uncertainty
                                         : data.relative_uncertainty * std::abs(value));
}

MeasuredSeries read_series(const CalibrationCase& values, const std::vector<std::string>& row) {
  const std::vector<std::string>& names = values.conditions.names;
  const auto condition = std::find(names.begin(), names.end(), row[0]);
  if (condition == names.end())
    throw InputError(fmt::format("there is no condition '{}'", row[0]),
                     fmt::format("conditions.names are {}", fmt::join(names, ", ")));
  const Quantity& quantity = quantity_named(row[1]);
  const bool orientation = quantity.observed == Observed::orientation;
  if (orientation != calibrates_orientation(values))
    throw InputError(
        fmt::format("{} does not belong to an {} law", row[1], orientation ? "attrition" : "orientation"),
        "give the other kind of law, or other data");
  MeasuredSeries series;
  series.name = fmt::format("{}: {}", row[0], row[1]);
  series.unit = quantity.unit;
  series.condition = condition - names.begin();
  series.observed = quantity.observed;
  series.row = quantity.row;
  series.column = quantity.column_of_tensor;
  if (*quantity.column == '\0') {
    series.times = {0};
    series.values = {value_in(row[2], quantity.unit)};
  } else {
    read_file(row, quantity, series);
  }
  require_possible(series);
  fill_deviations(values.data, series);
  return series;
}

}  // namespace

std::vector<MeasuredSeries> read_measurements(const CalibrationCase& values) {
  if (calibrates_in_molds(values)) return molded_series(values);
  std::vector<MeasuredSeries> all;
  for (std::size_t i = 0; i < values.data.series.size(); ++i) {
    const auto refuse = [i](const std::string& complaint, const std::string& remedy) {
      throw InputError({{"", static_cast<int>(i) + 1, 0, "data.series", "", complaint, remedy}});
    };
    try {
      all.push_back(read_series(values, values.data.series[i]));
    } catch (const StorageError& error) {
      refuse(error.what(), "give the path of a CSV file, relative to the case file");
    } catch (const InputError& error) {
      refuse(complaint_with_place(error.problems().front()), error.problems().front().remedy);
    }
  }
  return all;
}

}  // namespace fiberfate
