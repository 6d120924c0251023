// Writes and reads tables of numbers as CSV.
#include "io/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

namespace fiberfate {
namespace {

std::string header_of(const std::vector<std::string>& columns) {
  return fmt::format("{}\n", fmt::join(columns, ","));
}

/// Cuts a table after its first rows, digests what it keeps and tells how many rows that are.
std::int64_t keep_rows(const std::string& path, const std::string& header, std::int64_t kept,
                       Digest& digest) {
  if (kept == 0) {
    replace_file(path, header);
    digest.add(header);
    return 0;
  }
  const std::string text = read_file(path);
  if (!text.starts_with(header)) throw StorageError("cannot continue " + path + ": its columns are others");
  std::size_t end = header.size();
  for (std::int64_t row = 0; row < kept; ++row) {
    const std::size_t line_end = text.find('\n', end);
    if (line_end == std::string::npos)
      throw StorageError(
          fmt::format("cannot continue {}: it has {} rows where the checkpoint counts {}", path, row, kept));
    end = line_end + 1;
  }
  digest.add(std::string_view(text).substr(0, end));
  if (end != text.size()) cut_file(path, end);
  return kept;
}

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  if (line.ends_with('\r')) line.remove_suffix(1);
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    cells.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(line);
  return cells;
}

void add_row(CsvTable& table, std::string_view line, const std::string& place) {
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != table.columns.size())
    throw StorageError(
        fmt::format("{}: {} values for {} columns", place, cells.size(), table.columns.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::optional<double> value = number_in(cells[i]);
    if (!value) throw StorageError(fmt::format("{}: '{}' is not a number", place, cells[i]));
    table.values[i].push_back(*value);
  }
}

}  // namespace

CsvWriter::CsvWriter(const std::string& path, const std::vector<std::string>& columns, std::int64_t kept_rows)
    : columns_(columns.size()), rows_(keep_rows(path, header_of(columns), kept_rows, digest_)), file_(path) {}

void CsvWriter::append(std::span<const double> row) {
  assert(row.size() == columns_);
  const std::string line = fmt::format("{}\n", fmt::join(row, ","));
  digest_.add(line);
  file_.append(line);
  ++rows_;
}

void CsvTable::append(std::span<const double> row) {
  assert(row.size() == columns.size());
  values.resize(columns.size());
  for (std::size_t i = 0; i < row.size(); ++i) values[i].push_back(row[i]);
}

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw StorageError("a table has no column " + name);
  return values[found - columns.begin()];
}

CsvTable read_csv(const std::string& path) {
  const std::string text = read_file(path);
  // A row without an end is one that a killed run or a full disk left half written.
  std::string_view rest = std::string_view(text).substr(0, text.rfind('\n') + 1);
  CsvTable table;
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view row = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(row.size() + 1, rest.size()));
    if (row.empty() || row.starts_with('#')) continue;
    if (table.columns.empty()) {
      for (const std::string_view name : cells_of(row)) table.columns.emplace_back(name);
      table.values.resize(table.columns.size());
    } else {
      add_row(table, row, fmt::format("{}:{}", path, line));
    }
  }
  return table;
}

CsvTable read_rows(const std::string& path) {
  CsvTable table = read_csv(path);
  if (table.rows() == 0) throw StorageError(path + " has no rows");
  return table;
}

CsvTable read_numbered(const std::string& path, const NumberedColumn& column) {
  CsvTable table = read_csv(path);
  for (const double number : table.column(column.name))
    if (!(number >= 0) || number >= static_cast<double>(column.count) || number != std::floor(number))
      throw StorageError(fmt::format("{}: there is no {} {:g}; the case has {}, counted from 0", path,
                                     column.name, number, column.count));
  return table;
}

void write_csv(const std::string& path, const CsvTable& table) {
  std::string text = header_of(table.columns);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      text += fmt::format("{}{}", table.values[i][row], i + 1 == table.columns.size() ? '\n' : ',');
  }
  replace_file(path, text);
}

}  // namespace fiberfate
