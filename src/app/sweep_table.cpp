// The table of a sweep.
#include "app/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fiberfate {
namespace {

std::string cell_of(double number) {
  return fmt::format("{}", number);
}

std::string in_quotes_where_needed(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string line_of(std::vector<std::string> cells) {
  std::ranges::transform(cells, cells.begin(), in_quotes_where_needed);
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

void SweepTable::set(std::vector<std::string>& row, const std::string& column, std::string cell) {
  const auto found = std::ranges::find(columns_, column);
  const std::size_t place = found - columns_.begin();
  if (found == columns_.end()) columns_.push_back(column);
  row.resize(std::max(row.size(), place + 1));
  row[place] = std::move(cell);
}

void SweepTable::add(std::vector<std::string> leading_cells,
                     const std::vector<std::pair<std::string, SummaryValue>>& values) {
  std::vector<std::string> row = std::move(leading_cells);
  for (const auto& [key, value] : values) {
    if (const auto* number = std::get_if<double>(&value)) set(row, key, cell_of(*number));
    if (const auto* count = std::get_if<std::int64_t>(&value)) set(row, key, fmt::format("{}", *count));
    if (const auto* text = std::get_if<std::string>(&value)) set(row, key, *text);
    if (const auto* tensor = std::get_if<Mat3>(&value))
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          set(row, fmt::format("{}_{}{}", key, i + 1, j + 1), cell_of((*tensor)(i, j)));
  }
  rows_.push_back(std::move(row));
}

std::string SweepTable::text() const {
  std::string all = line_of(columns_);
  for (std::vector<std::string> row : rows_) {
    row.resize(columns_.size());
    all += line_of(std::move(row));
  }
  return all;
}

}  // namespace fiberfate
