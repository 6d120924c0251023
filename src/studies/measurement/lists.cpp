// Reads lists of measured fibers.
#include "studies/measurement/lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "io/delimited_table.hpp"

namespace fiberfate {
namespace {

[[noreturn]] void refuse_at(const std::string& key, std::string complaint, std::string remedy) {
  throw InputError({{"", 0, 0, key, "", std::move(complaint), std::move(remedy)}});
}

DelimitedTable read_list(const std::string& path) {
  DelimitedTable table(path);
  if (table.rows() == 0) throw InputError({{path, 1, 1, "", "", "holds no fibers", "give a row a fiber"}});
  return table;
}

/// Whether a heading speaks of lengths, in one of a few languages.
bool says_length(std::string heading) {
  std::transform(heading.begin(), heading.end(), heading.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  static constexpr std::array words = {"length", "länge", "laenge", "longueur", "lunghezza", "longitud"};
  return std::any_of(words.begin(), words.end(),
                     [&heading](const char* word) { return heading.find(word) != std::string::npos; });
}

/// Gives how many metres the unit in a heading has; nothing where it has none of length.
std::optional<double> heading_factor(const std::string& heading) {
  return factor_of_unit(unit_in_heading(heading), "m");
}

[[noreturn]] void refuse_choice(const DelimitedTable& table, const std::vector<std::size_t>& named) {
  const std::string example = named.empty() ? "Length" : table.headings()[named.front()];
  refuse_at("lengths.column",
            fmt::format("not given, and {} has several columns: {}", table.path(), table.listed_headings()),
            fmt::format("say which holds the lengths, column = \"{}\" under [lengths]", example));
}

std::size_t length_column(const DelimitedTable& table, const MeasuredLengthChoices& choices) {
  if (!choices.column.empty()) return table.column_named(choices.column);
  std::vector<std::size_t> others, named, sure;
  for (std::size_t i = 0; i < table.columns(); ++i) {
    const std::string& heading = table.headings()[i];
    if (!choices.number_column.empty() && i == table.column_named(choices.number_column)) continue;
    others.push_back(i);
    if (!says_length(heading)) continue;
    named.push_back(i);
    if (heading_factor(heading)) sure.push_back(i);
  }
  if (others.size() == 1) return others.front();
  if (sure.size() == 1 && named.size() == 1) return sure.front();
  refuse_choice(table, named);
}

/// Gives the metres of one unit of the column: as the case says, or its heading, which must not disagree.
double length_factor(const MeasuredLengthChoices& choices, const std::string& heading) {
  const std::optional<double> told = heading_factor(heading);
  if (choices.unit.empty()) {
    if (told) return *told;
    refuse_at("lengths.unit", "not given", "say in which unit the file is, unit = \"um\" under [lengths]");
  }
  const double given = unit_factor(choices.unit, "m");
  constexpr double rounding = 1e-9;
  if (told && std::abs(*told / given - 1) > rounding)
    refuse_at("lengths.unit",
              fmt::format("'{}' contradicts the heading '{}' of {}", choices.unit, heading, choices.file),
              "leave the unit out, or correct the heading");
  return given;
}

}  // namespace

std::string LeftOut::text() const {
  std::vector<std::string> parts;
  if (empty_lines > 0)
    parts.push_back(fmt::format("{} empty line{}", empty_lines, empty_lines > 1 ? "s" : ""));
  if (zero_lengths > 0)
    parts.push_back(fmt::format("{} row{} of zero length", zero_lengths, zero_lengths > 1 ? "s" : ""));
  if (parts.empty()) return "";
  return fmt::format("{} {} left out", fmt::join(parts, " and "),
                     empty_lines + zero_lengths > 1 ? "are" : "is");
}

constexpr double most_fibers = 1e15;  // in a row: more would swallow the others in round-off

LengthList read_lengths(const MeasuredLengthChoices& choices) {
  const DelimitedTable table = read_list(choices.file);
  const std::size_t column = length_column(table, choices);
  LengthList list{{}, table.headings()[column], {table.empty_lines(), 0}};
  const double factor = length_factor(choices, list.column);
  const std::vector<double> lengths = table.numbers(column);
  std::vector<double> numbers;
  if (!choices.number_column.empty()) numbers = table.numbers(table.column_named(choices.number_column));
  for (std::size_t row = 0; row < lengths.size(); ++row) {
    if (lengths[row] < 0)
      throw InputError({{choices.file, table.line_of(row), 1, "", "",
                         fmt::format("a length is {:g}", lengths[row]), "give positive lengths"}});
    if (lengths[row] == 0) {
      ++list.left_out.zero_lengths;
      continue;
    }
    list.fibers.lengths.push_back(factor * lengths[row]);
    if (numbers.empty()) continue;
    if (numbers[row] > most_fibers)
      throw InputError({{choices.file, table.line_of(row), 1, "", "",
                         fmt::format("a number of fibers is {:g}", numbers[row]),
                         fmt::format("give at most {:g}", most_fibers)}});
    list.fibers.numbers.push_back(numbers[row]);
  }
  if (list.fibers.lengths.empty())
    throw InputError(
        {{choices.file, 1, 1, "", "", "holds no fibers but of zero length", "give positive lengths"}});
  return list;
}

DirectionList read_directions(const MeasuredDirectionChoices& choices) {
  const DelimitedTable table = read_list(choices.file);
  const bool angles = choices.form == DirectionForm::angles;
  const Texts usual = angles ? Texts{"theta", "phi"} : Texts{"p1", "p2", "p3"};
  std::vector<std::vector<double>> columns;
  for (const std::string& name : choices.columns.empty() ? usual : choices.columns)
    columns.push_back(table.numbers(table.column_named(name)));
  const double angle = choices.angle_unit == AngleUnit::degrees ? pi / 180 : 1;
  DirectionList list{{}, {table.empty_lines(), 0}};
  for (std::size_t i = 0; i < table.rows(); ++i)
    list.fibers.directions.push_back(angles ? direction_of(angle * columns[0][i], angle * columns[1][i])
                                            : Vec3(columns[0][i], columns[1][i], columns[2][i]));
  if (!choices.weight_column.empty())
    list.fibers.weights = table.numbers(table.column_named(choices.weight_column));
  if (choices.cut_normal)
    list.fibers = corrected_for_cut(list.fibers, *choices.cut_normal, choices.aspect_ratio.value_or(1));
  return list;
}

}  // namespace fiberfate
