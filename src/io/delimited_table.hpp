// Tables of numbers as instruments and spreadsheets write them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fiberfate {

/// Reads a table whose columns are separated by semicolons, tabs, commas or, where there are only numbers, by
/// blanks; the first line tells which, or "sep=;" above it. Between semicolons or tabs a number may have a
/// decimal comma. Cells may be in quotes, lines may end as on Unix, Windows or an old Macintosh, the text may
/// be UTF-8 or Latin-1. What follows a '#' at the beginning of a line is skipped. Only the columns that are
/// asked for need to be numbers. All errors are InputErrors with file, line and column.
class DelimitedTable {
 public:
  explicit DelimitedTable(const std::string& path);

  /// Gives the headings, or "1", "2", … where the first line holds numbers.
  [[nodiscard]] const std::vector<std::string>& headings() const { return headings_; }
  [[nodiscard]] std::size_t columns() const { return headings_.size(); }
  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  /// How many lines between rows hold nothing.
  [[nodiscard]] std::size_t empty_lines() const { return empty_lines_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] int line_of(std::size_t row) const { return lines_[row].number; }

  /// The columns for messages, a nameless one by its number.
  [[nodiscard]] std::string listed_headings() const;
  /// Finds a column by its heading, with or without the unit behind it; raises InputError that lists the
  /// columns when there is none, or several.
  [[nodiscard]] std::size_t column_named(const std::string& name) const;
  [[nodiscard]] bool has_column(const std::string& name) const;
  /// Reads the numbers of a column; raises InputError with the cells at fault.
  [[nodiscard]] std::vector<double> numbers(std::size_t column) const;

 private:
  struct Line {
    std::size_t begin;
    int number;
  };
  void split_lines();
  void choose_separator(std::string_view line);
  [[nodiscard]] std::vector<std::string_view> cells_of(std::string_view line, int number) const;
  void take_headings(const std::vector<std::string_view>& cells, const Line& line);
  void take_row(const std::vector<std::string_view>& cells, const Line& line);
  void refuse_split_decimals() const;
  [[nodiscard]] bool looks_split(std::size_t column) const;
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const {
    return cells_[row * columns() + column];
  }
  [[nodiscard]] int column_of(std::string_view cell, const Line& line) const;

  std::string path_;
  std::unique_ptr<const std::string> text_;  ///< that cells are views of
  char separator_ = '\0';
  std::vector<std::string> headings_;
  std::vector<Line> lines_;              ///< of each row
  std::vector<std::string_view> cells_;  ///< row after row
  std::size_t empty_lines_ = 0;
};

/// Gives the unit in a heading such as "Length [mm]" or "Length (mm)"; nothing where there is none.
[[nodiscard]] std::string unit_in_heading(const std::string& heading);
/// Gives the heading without such a unit: "Length".
[[nodiscard]] std::string heading_without_unit(const std::string& heading);
/// The factor that turns numbers in a unit into those in `si_unit`; nothing where it is none of this kind.
[[nodiscard]] std::optional<double> factor_of_unit(const std::string& unit, const std::string& si_unit);

}  // namespace fiberfate
