// The table of a sweep: a row a run, with the values of its summary.
#pragma once

#include <string>
#include <vector>

#include "results/summary.hpp"

namespace fiberfate {

/// Collects the rows of sweep.csv. Its columns are the run's folder, the swept keys, and every number, text
/// and 3×3 tensor of any run's summary.json by name; a cell is empty where a run does not have it.
class SweepTable {
 public:
  explicit SweepTable(std::vector<std::string> leading_columns) : columns_(std::move(leading_columns)) {}

  /// Adds a row that begins with these cells.
  void add(std::vector<std::string> leading_cells,
           const std::vector<std::pair<std::string, SummaryValue>>& values);
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  /// The whole table as CSV.
  [[nodiscard]] std::string text() const;

 private:
  void set(std::vector<std::string>& row, const std::string& column, std::string cell);
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace fiberfate
