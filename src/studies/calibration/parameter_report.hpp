// Builds the sections of a calibration report that are about parameters: values, profiles, bootstrap samples.
#pragma once

#include <string>
#include <vector>

#include "keys/law_choice.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/calibration/fits.hpp"

namespace fiberfate {

/// Names the free parameters, in the law's order.
[[nodiscard]] std::vector<std::string> free_names(const CalibrationCase& values);

/// Lists the fitted parameters with every kind of interval.
[[nodiscard]] TableSection estimates(const CalibrationCase& values, const SummaryFile& summary,
                                     const FitName& name);

/// The same as facts, headlines where they are few.
[[nodiscard]] std::vector<Fact> parameter_facts(const CalibrationCase& values, const SummaryFile& summary,
                                                const FitName& name);

/// Draws the profiles of parameters on the scales on which they were searched.
void append_profiles(const CalibrationCase& values, const ResultFolder& folder, const FitName& name,
                     const SummaryFile& summary, std::vector<ReportSection>& sections);

/// Draws pairs of parameters as bootstrap samples have them: the shape of what the data leave open.
void append_samples(const CalibrationCase& values, const ResultFolder& folder, const FitName& name,
                    std::vector<ReportSection>& sections);

}  // namespace fiberfate
