// Shows that Jeffery's motion is exact: of a fiber, of a population, and through the exact closure.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_jeffery.hpp"
#include "microstructure/closure.hpp"
#include "physics/process/reference_table.hpp"
#include "physics/record.hpp"

namespace fiberfate {
namespace {

Vec3 vector3(const nlohmann::json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

/// Angle from the velocity gradient towards the flow in simple shear: tan phi = r tan(rate t / (r + 1/r)),
/// from 0.
double shear_angle(double aspect_ratio, double strain) {
  return std::atan(aspect_ratio * std::tan(strain / (aspect_ratio + 1 / aspect_ratio)));
}

TEST(JefferyMotion, PopulationsMatchTheReferenceTable) {
  for (const auto& row : reference_table("jeffery_exact.json")["cases"]) {
    for (std::size_t k = 0; k < row["t"].size(); ++k) {
      const Mat3 state = carried_isotropic_state(fiber_deformation(matrix3(row["L"]), 1, row["t"][k]));
      EXPECT_LT((state - matrix3(row["A"][k])).cwiseAbs().maxCoeff(), 1e-10)
          << row["flow"] << " " << row["t"][k];
    }
  }
}

TEST(JefferyMotion, TheExactClosureReproducesThePopulations) {
  OrientationModel model;
  model.closure = closure_named("exact");
  for (const auto& row : reference_table("jeffery_exact.json")["cases"]) {
    OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({matrix3(row["L"])}), {},
                                     {.absolute = 1e-12, .relative = 1e-12});
    for (std::size_t k = 0; k < row["t"].size(); ++k) {
      integrator.advance_to(row["t"][k]);
      const Mat3 error = integrator.state().second - matrix3(row["A"][k]);
      EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-10) << row["flow"] << " " << row["t"][k];
    }
  }
}

TEST(JefferyMotion, FibersMatchTheReferenceTable) {
  for (const auto& row : reference_table("jeffery_exact.json")["single_fiber"]) {
    for (std::size_t k = 0; k < row["t"].size(); ++k) {
      const Mat3 deformation = fiber_deformation(matrix3(row["L"]), row["xi"], row["t"][k]);
      const Vec3 direction = carried_direction(vector3(row["p0"]), deformation);
      const Vec3 wanted = vector3(row["p"][k]);
      EXPECT_LT(std::min((direction - wanted).norm(), (direction + wanted).norm()), 1e-10);
    }
  }
}

TEST(JefferyMotion, ShearTurnsFibersAsTheClosedFormSays) {
  for (const double r : {2.0, 5.0, 25.0}) {
    const double xi = shape_factor(r), strain = 0.3 * (r + 1 / r);
    const Mat3 deformation = fiber_deformation(simple_shear_gradient(), xi, strain);
    const Vec3 direction = carried_direction({0, 1, 0}, deformation);
    record("angle of a fiber of aspect ratio " + std::to_string(int(r)) + " in shear (rad)",
           shear_angle(r, strain), std::atan2(direction[0], direction[1]), 1e-12);
    EXPECT_NEAR(jeffery_period(r, 2.0), pi * (r + 1 / r), 1e-12);
  }
}

TEST(JefferyMotion, TheRateIsTheDerivativeOfTheMotion) {
  Mat3 gradient;
  gradient << 0.5, 1.25, 2.5, -0.75, 0.25, 1.0, 0.375, -0.5, -0.75;
  const Vec3 start = Vec3(0.3, -0.5, 0.8).normalized();
  const double h = 1e-5;
  const Vec3 ahead = carried_direction(start, fiber_deformation(gradient, 0.9, h));
  const Vec3 behind = carried_direction(start, fiber_deformation(gradient, 0.9, -h));
  EXPECT_LT(((ahead - behind) / (2 * h) - jeffery_rate(start, gradient, 0.9)).norm(),
            1e-8);  // h² and round-off/h
}

}  // namespace
}  // namespace fiberfate
