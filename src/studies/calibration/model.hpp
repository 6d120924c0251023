// Predicts measured series by a law, for the least squares that fit its parameters.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "calibration/fit_problem.hpp"
#include "studies/calibration/data.hpp"

namespace fiberfate {

/// Poses the fit of some series of a case.
[[nodiscard]] FitProblem pose_calibration(const CalibrationCase& values,
                                          const std::vector<MeasuredSeries>& series);

/// Makes a function that predicts other series than those that are fitted: the same ones at finer times, for
/// curves and their bands.
[[nodiscard]] FitModel calibration_model(const CalibrationCase& values,
                                         const std::vector<MeasuredSeries>& series);

/// Gives the series with `count` even times from 0 to its last one, and deviations interpolated; a series of
/// single values or a histogram is given back as it is.
[[nodiscard]] MeasuredSeries refined(const MeasuredSeries& series, std::size_t count);

/// The fibers with which a condition begins.
[[nodiscard]] LengthChoices condition_fibers(const CalibrationCase& values, std::size_t condition);

/// What the bins of a fitted law leave open of its unbreakable length; empty where that is little.
[[nodiscard]] std::string remark_on_bins(const CalibrationCase& values,
                                         const std::vector<MeasuredSeries>& series,
                                         const std::vector<double>& law_values);

/// The shear rate and viscosity of a condition.
[[nodiscard]] LengthFlow condition_flow(const CalibrationCase& values, std::size_t condition);

}  // namespace fiberfate
