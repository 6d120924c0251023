// Reads lists of measured fibers and checks a case of the study measurement.
#include "studies/measurement/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "io/csv_table.hpp"

namespace fiberfate {
namespace {

bool is_number(const std::string& text) {
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() && end == text.data() + text.size();
}

/// Reads a table; one without a heading has columns 1, 2, 3.
CsvTable read_list(const std::string& path) {
  CsvTable table;
  try {
    table = read_csv(path);
  } catch (const StorageError& problem) {
    throw InputError(
        problem.what(),
        "give rows of numbers, separated by commas, with a decimal point, under a line of names");
  }
  if (!table.columns.empty() && std::all_of(table.columns.begin(), table.columns.end(), is_number)) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      table.values[i].insert(table.values[i].begin(), std::stod(table.columns[i]));
      table.columns[i] = std::to_string(i + 1);
    }
  }
  if (table.rows() == 0) throw InputError(path + " holds no fibers", "give a row a fiber");
  return table;
}

const std::vector<double>& column_named(const CsvTable& table, const std::string& path,
                                        const std::string& name) {
  if (std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end())
    return table.column(name);
  const std::string near = nearest_word(name, table.columns);
  throw InputError(
      fmt::format("{} has no column '{}'", std::filesystem::path(path).filename().string(), name),
      near.empty() ? fmt::format("its columns are {}", fmt::join(table.columns, ", "))
                   : fmt::format("did you mean '{}'?", near));
}

Texts direction_columns(const MeasuredDirectionChoices& choices) {
  if (!choices.columns.empty()) return choices.columns;
  return choices.form == DirectionForm::angles ? Texts{"theta", "phi"} : Texts{"p1", "p2", "p3"};
}

void validate_lengths(const MeasuredLengthChoices& lengths, CaseChecker& checker) {
  if (lengths.file.empty()) {
    checker.warn_unused({"lengths.column", "lengths.number_column", "lengths.unit", "lengths.sample_diameter",
                         "lengths.bins", "lengths.bin_width"},
                        "a given lengths.file");
    return;
  }
  if (lengths.bin_width) checker.warn_unused({"lengths.bins"}, "a case without lengths.bin_width");
  if (lengths.unit.empty()) {
    checker.error("lengths.unit", "not given",
                  "say in which unit the file is, unit = \"um\" under [lengths]");
    return;
  }
  try {
    static_cast<void>(unit_factor(lengths.unit, "m"));
  } catch (const std::invalid_argument& problem) {
    checker.error("lengths.unit", problem.what(), "give a unit of length such as \"um\"");
    return;
  }
  checker.check_file("lengths.file", lengths.file);
  if (checker.is_sound("lengths.file"))
    checker.report_at("lengths.file", [&] { static_cast<void>(number_average(read_lengths(lengths))); });
}

void validate_directions(const MeasuredDirectionChoices& orientation, CaseChecker& checker) {
  if (orientation.file.empty()) {
    checker.warn_unused({"orientation.form", "orientation.columns", "orientation.angle_unit",
                         "orientation.weight_column", "orientation.cut_normal", "orientation.aspect_ratio"},
                        "a given orientation.file");
    return;
  }
  if (orientation.form == DirectionForm::vectors)
    checker.warn_unused({"orientation.angle_unit"}, "orientation.form = \"angles\"");
  const std::size_t wanted = orientation.form == DirectionForm::angles ? 2 : 3;
  if (!orientation.columns.empty() && orientation.columns.size() != wanted)
    checker.error(
        "orientation.columns",
        fmt::format("{} columns where {} are needed", orientation.columns.size(), wanted),
        wanted == 2 ? "name the columns of theta and phi" : "name the columns of the three components");
  if (orientation.cut_normal && !(orientation.cut_normal->norm() > 0))
    checker.error("orientation.cut_normal", "has no direction", "give a vector across the cut");
  if (orientation.cut_normal && !orientation.aspect_ratio)
    checker.error("orientation.aspect_ratio", "not given; the correction for a cut needs it",
                  "add aspect_ratio = 20 under [orientation]");
  if (!orientation.cut_normal)
    checker.warn_unused({"orientation.aspect_ratio"}, "a given orientation.cut_normal");
  checker.check_file("orientation.file", orientation.file);
  if (checker.is_sound("orientation.file") && checker.is_sound("orientation.columns") &&
      checker.is_sound("orientation.cut_normal") && checker.is_sound("orientation.aspect_ratio"))
    checker.report_at("orientation.file",
                      [&] { static_cast<void>(second_moment(read_directions(orientation))); });
}

}  // namespace

void validate_measurement(const MeasurementCase& values, CaseChecker& checker) {
  if (values.lengths.file.empty() && values.orientation.file.empty() && checker.is_sound("lengths.file") &&
      checker.is_sound("orientation.file"))
    checker.error("lengths.file", "not given, nor is orientation.file; there is nothing to evaluate",
                  "add file = \"lengths.csv\" under [lengths], or a file under [orientation]");
  validate_lengths(values.lengths, checker);
  validate_directions(values.orientation, checker);
}

CaseEstimate estimate_measurement(const MeasurementCase& values) {
  CaseEstimate estimate;
  double rows = 0;
  if (!values.lengths.file.empty()) {
    const std::size_t lengths = read_lengths(values.lengths).lengths.size();
    estimate.facts.emplace_back("rows of lengths", std::to_string(lengths));
    rows += static_cast<double>(lengths);
  }
  if (!values.orientation.file.empty()) {
    const std::size_t directions = read_directions(values.orientation).directions.size();
    estimate.facts.emplace_back("rows of directions", std::to_string(directions));
    rows += static_cast<double>(directions);
  }
  estimate.memory_bytes = 1e7 + 100 * rows;
  estimate.wall_seconds = 5e-8 * rows * static_cast<double>(values.statistics.resamples);
  estimate.assumption = "50 ns a row and bootstrap sample";
  return estimate;
}

MeasuredLengths read_lengths(const MeasuredLengthChoices& choices) {
  const CsvTable table = read_list(choices.file);
  const double factor = unit_factor(choices.unit, "m");
  MeasuredLengths measured;
  measured.lengths =
      choices.column.empty() ? table.values.front() : column_named(table, choices.file, choices.column);
  for (double& length : measured.lengths) length *= factor;
  if (!choices.number_column.empty())
    measured.numbers = column_named(table, choices.file, choices.number_column);
  return measured;
}

MeasuredDirections read_directions(const MeasuredDirectionChoices& choices) {
  const CsvTable table = read_list(choices.file);
  std::vector<std::vector<double>> columns;
  for (const std::string& name : direction_columns(choices))
    columns.push_back(column_named(table, choices.file, name));
  const double angle = choices.angle_unit == AngleUnit::degrees ? pi / 180 : 1;
  MeasuredDirections measured;
  for (std::size_t i = 0; i < table.rows(); ++i)
    measured.directions.push_back(choices.form == DirectionForm::angles
                                      ? direction_of(angle * columns[0][i], angle * columns[1][i])
                                      : Vec3(columns[0][i], columns[1][i], columns[2][i]));
  if (!choices.weight_column.empty())
    measured.weights = column_named(table, choices.file, choices.weight_column);
  if (choices.cut_normal)
    measured = corrected_for_cut(measured, *choices.cut_normal, choices.aspect_ratio.value_or(1));
  return measured;
}

}  // namespace fiberfate
