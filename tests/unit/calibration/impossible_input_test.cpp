// Tests that calibration refuses numbers and shapes that mean nothing, and ends where a minimum lies at zero.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/error.hpp"
#include "calibration/bootstrap.hpp"
#include "calibration/fit.hpp"
#include "calibration/natural_spline.hpp"
#include "calibration/prediction_band.hpp"
#include "calibration/student.hpp"
#include "calibration/sweep.hpp"

namespace fiberfate {
namespace {

FitProblem line() {
  FitProblem problem;
  problem.parameters = {{.name = "a", .initial = 1}};
  problem.series = {{"y", "1", {1, 2, 3}, {1, 1, 1}}};
  problem.model = [](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = p[0] * static_cast<double>(i + 1);
  };
  return problem;
}

TEST(ImpossibleCalibration, IsRefused) {
  FitProblem no_model = line();
  no_model.model = nullptr;
  EXPECT_THROW(static_cast<void>(fit(no_model)), InputError);
  FitProblem no_bound = line();
  no_bound.parameters[0].lower = std::nan("");
  EXPECT_THROW(static_cast<void>(fit(no_bound)), InputError);
  FitOptions none;
  none.starts = 0;
  EXPECT_THROW(static_cast<void>(fit(line(), none)), InputError);
  for (const double level : {0.0, 1.0, -1.0, std::nan("")})
    EXPECT_THROW(static_cast<void>(student_quantile(level, 3)), InputError);
  EXPECT_THROW(NaturalSpline({0, 0}, {1, 2}), InputError);
  EXPECT_THROW(NaturalSpline({0}, {1}), InputError);
  EXPECT_THROW(NaturalSpline({0, 1}, {1, std::nan("")}), InputError);
  const FitResult found = fit(line());
  EXPECT_THROW(static_cast<void>(bootstrap(line(), found, {.samples = 0})), InputError);
  EXPECT_THROW(static_cast<void>(predict_with_band(line(), found, {line().model, {-1, 1, 1}})), InputError);
}

TEST(ImpossibleCalibration, SweepsAreCheckedAndEnd) {
  SweepRequest request = {
      .parameter = 0, .lower = -1, .upper = 1, .count = 5, .spacing = ParameterScale::linear};
  FitProblem problem = line();
  problem.model = [](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = static_cast<double>(i + 1) * (1 + p[0] * p[0]);
  };
  // The least error lies at zero, where a bracket never becomes small beside its own ends.
  EXPECT_NEAR(sweep(problem, std::vector<double>{1}, request).best_value, 0, 1e-6);
  request.parameter = 7;
  EXPECT_THROW(static_cast<void>(sweep(problem, std::vector<double>{1}, request)), InputError);
  request.parameter = 0;
  request.upper = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(swept_values(request)), InputError);
  request.upper = 1;
  problem.series[0].observed = {0, 0, 0};
  EXPECT_THROW(static_cast<void>(sweep(problem, std::vector<double>{1}, request)), InputError);
}

}  // namespace
}  // namespace fiberfate
