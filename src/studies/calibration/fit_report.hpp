// Builds the sections of a calibration report that judge a fit: residuals, parity, correlation, and words.
#pragma once

#include <string>
#include <vector>

#include "results/report_document.hpp"
#include "results/summary.hpp"
#include "studies/calibration/fits.hpp"

namespace fiberfate {

/// Draws what is left of the data over their uncertainties: over time, over length for histograms, and over
/// names for single values and places of molds.
[[nodiscard]] std::vector<LinesSection> residual_sections(const CalibrationCase& values,
                                                          const std::vector<MeasuredSeries>& measured,
                                                          const FitTables& rows);

/// Draws predicted over measured values, one picture a quantity.
[[nodiscard]] std::vector<LinesSection> parity_sections(const std::vector<MeasuredSeries>& measured,
                                                        const FitTables& rows);

/// Shows the correlations of three free parameters and more; nothing where they are fewer or unknown.
[[nodiscard]] std::vector<HeatmapSection> correlation_sections(const std::vector<std::string>& parameters,
                                                               const SummaryFile& summary,
                                                               const FitName& name);

/// Says how well two parameters are told apart, a fact for every pair of them.
[[nodiscard]] std::vector<Fact> correlation_facts(const std::vector<std::string>& parameters,
                                                  const SummaryFile& summary, const FitName& name);

/// Says what the size of the residuals means, and whether they have a pattern.
[[nodiscard]] std::vector<Fact> misfit_facts(const CalibrationCase& values, const SummaryFile& summary,
                                             const FitName& name);

}  // namespace fiberfate
