// Predicts lengths measured in molded parts, for the least squares that fit a length law.
#pragma once

#include <vector>

#include "calibration/fit_problem.hpp"
#include "studies/calibration/data.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {

/// Gives the molding of a condition, with the length at the gates that the condition gives. Raises
/// InputError.
[[nodiscard]] MoldingCase molding_of(const CalibrationCase& values, std::size_t condition);

/// The mean length at the gates of the kind that was measured in a condition: L_W where nothing else
/// was, otherwise L_N; m.
[[nodiscard]] double inlet_length(const CalibrationCase& values, std::size_t condition);

/// Lists the lengths measured in molds as series: one a condition, place and mean, its values the samples,
/// their deviations the relative uncertainty of their mean.
[[nodiscard]] std::vector<MeasuredSeries> molded_series(const CalibrationCase& values);

/// Makes the function that predicts such series. Moldings are filled when they are needed first. Where a flow
/// feels the fibers, parts fill once for each value of [sweep], and between them the logarithm of every
/// length is a cubic spline over the swept parameter: the only one that may be free.
[[nodiscard]] FitModel mold_model(const CalibrationCase& values, const std::vector<MeasuredSeries>& series);

/// Whether a flow feels the fibers in any of the series' moldings.
[[nodiscard]] bool feels_fibers(const CalibrationCase& values, const std::vector<MeasuredSeries>& series);

/// Puts the samples of every series together: one observation each, their mean. Errors (4.7) are of means.
[[nodiscard]] FitProblem pooled(const FitProblem& problem);

}  // namespace fiberfate
