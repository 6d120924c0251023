// Writes and reads tables of numbers as CSV; the names of the columns end in their units.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "base/digest.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {

/// Appends rows to a CSV file. Numbers are written with the fewest digits that read back to the same bits.
class CsvWriter {
 public:
  /// Opens a table, keeping its first `kept_rows` rows (0: a new one, over an existing one). Raises
  /// StorageError when it has fewer rows or other columns.
  CsvWriter(const std::string& path, const std::vector<std::string>& columns, std::int64_t kept_rows);
  /// Adds a row with one number a column.
  void append(std::span<const double> row);
  /// Hands the rows to the operating system; raises StorageError.
  void flush() { file_.flush(); }
  /// Waits until the rows have reached the disk; raises StorageError.
  void sync() { file_.sync(); }
  [[nodiscard]] std::int64_t rows() const { return rows_; }
  /// A number that stands for the whole text so far.
  [[nodiscard]] std::uint64_t digest() const { return digest_.value(); }

 private:
  std::size_t columns_;
  Digest digest_;
  std::int64_t rows_;
  AppendedFile file_;
};

/// A table in memory.
struct CsvTable {
  std::vector<std::string> columns = {};
  std::vector<std::vector<double>> values = std::vector<std::vector<double>>(columns.size());  ///< by column

  [[nodiscard]] std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }
  /// Adds a row with one number a column.
  void append(std::span<const double> row);
  void append(std::initializer_list<double> row) { append(std::span(row.begin(), row.size())); }
  /// Finds a column; raises StorageError when there is none of that name.
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
};

/// Reads a table; raises StorageError with the line at fault.
[[nodiscard]] CsvTable read_csv(const std::string& path);

/// Reads a table that has rows; raises StorageError for one without.
[[nodiscard]] CsvTable read_rows(const std::string& path);

/// A column that numbers so many things from 0.
struct NumberedColumn {
  std::string name;
  std::size_t count = 0;
};
/// Reads a table with such a column; raises StorageError for the number of a thing that is not there.
[[nodiscard]] CsvTable read_numbered(const std::string& path, const NumberedColumn& column);

/// Writes a whole table; raises StorageError.
void write_csv(const std::string& path, const CsvTable& table);

}  // namespace fiberfate
