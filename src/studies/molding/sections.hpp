// The charts and tables of a molding report that come of places, profiles and the sweep.
#pragma once

#include <vector>

#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "results/summary.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {

/// Lists fill time, temperature and lengths at the named places.
[[nodiscard]] TableSection places_section(const MoldingCase& values, const CsvTable& places);

/// Draws temperature, shear rate, orientation and length over the height in the gap, one curve a place.
[[nodiscard]] std::vector<LinesSection> profile_sections(const MoldingCase& values, const CsvTable& profiles);

/// Shows the length distributions at the places beside that at the gates.
[[nodiscard]] HistogramSection molding_histogram(const MoldingCase& values, const CsvTable& histogram);

/// Draws the average error over the swept parameter (thesis figures 4.2, 4.6, 4.7).
[[nodiscard]] LinesSection sweep_section(const MoldingCase& values, const CsvTable& sweep);

/// Draws measured lengths beside those of the value of the sweep nearest to the best one.
[[nodiscard]] LinesSection measured_section(const MoldingCase& values, const CsvTable& places,
                                            const SummaryFile& summary);

}  // namespace fiberfate
