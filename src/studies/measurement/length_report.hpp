// The sections of a measurement report that are about lengths.
#pragma once

#include <vector>

#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/measurement/case.hpp"

namespace fiberfate {

/// The numbers that a reader wants first: mean lengths with their intervals, the median, what was counted.
[[nodiscard]] std::vector<Fact> length_facts(const MeasurementCase& values, const SummaryFile& summary,
                                             const ResultFolder& folder);

/// Bars by number and by length with the fitted laws over them, cumulative curves, quantiles, laws, means.
/// Folders of older versions have no laws: bars and means alone.
[[nodiscard]] std::vector<ReportSection> length_sections(const MeasurementCase& values,
                                                         const SummaryFile& summary,
                                                         const ResultFolder& folder);

}  // namespace fiberfate
