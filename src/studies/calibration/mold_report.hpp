// Builds the sections of a calibration report that are about molded parts.
#pragma once

#include <string>
#include <vector>

#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "studies/calibration/fits.hpp"

namespace fiberfate {

/// Draws measured and predicted lengths along the places, one picture a molding (thesis figures 4.2, 4.5).
[[nodiscard]] std::vector<LinesSection> molded_lengths_sections(const CalibrationCase& values,
                                                                const std::vector<MeasuredSeries>& measured,
                                                                const FitTables& rows);

/// Lists the optimum of every molding.
[[nodiscard]] TableSection optimum_table(const CalibrationCase& values, const CsvTable& optimum);

/// Draws the optimum over the aspect ratio of the fibers at the gates, with and without coupling (thesis
/// figures 4.8, 4.9).
[[nodiscard]] LinesSection optimum_section(const CalibrationCase& values, const CsvTable& optimum);

}  // namespace fiberfate
