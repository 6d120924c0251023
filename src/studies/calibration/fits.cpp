// The fits of a calibration and their rows in its tables.
#include "studies/calibration/fits.hpp"

#include "results/summary.hpp"

#include "base/error.hpp"

namespace fiberfate {
std::vector<FitName> fit_names(const CalibrationCase& values) {
  if (values.search.scope == FitScope::together) return {FitName{}};
  std::vector<FitName> names;
  for (const std::string& name : values.conditions.names)
    names.push_back({static_cast<double>(names.size()), key_part(name) + "_", ", " + name});
  return names;
}

std::vector<MeasuredSeries> series_of(const FitName& fit, const std::vector<MeasuredSeries>& all) {
  std::vector<MeasuredSeries> some;
  for (const MeasuredSeries& one : all)
    if (fit.prefix.empty() || static_cast<double>(one.condition) == fit.number) some.push_back(one);
  return some;
}

std::vector<double> pick(const CsvTable& table, double fit, double second, const std::string& column) {
  const std::vector<double>& values = table.column(column);
  if (table.columns.size() < 2) throw StorageError("a table of fits lacks its second column");
  std::vector<double> picked;
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (table.values[0][i] == fit && table.values[1][i] == second) picked.push_back(values[i]);
  return picked;
}

}  // namespace fiberfate
