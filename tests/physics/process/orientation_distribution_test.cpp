// Shows that the distribution function is solved exactly, and that it is what the tensor equations close.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "continuum/fokker_planck.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_jeffery.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/closure.hpp"
#include "physics/record.hpp"

namespace fiberfate {
namespace {

OrientationModel folgar_tucker(double c_i) {
  OrientationModel model{
      rotary_diffusion_named("folgar_tucker"), retardation_named("none"), closure_named("ibof"), {}};
  model.constants.c_i = c_i;
  return model;
}

/// DA/Dt with the true A4 of a distribution, by the tensor equation.
Mat3 moment_equation(const Mat3& a, const Mat6& a4, const Mat3& gradient, double xi, const Mat3& c) {
  const Mat3 d = 0.5 * (gradient + gradient.transpose()), w = 0.5 * (gradient - gradient.transpose());
  const double rate = std::sqrt(2 * double_dot(d, d));
  return w * a - a * w + xi * (d * a + a * d - 2 * contracted(a4, d)) +
         rate * (2 * c - 2 * c.trace() * a - 5 * (c * a + a * c) + 10 * contracted(a4, c));
}

TEST(OrientationDistribution, SteadyShearAtOnePercentInteraction) {
  const FokkerPlanck equation(folgar_tucker(0.01), 40);
  const Eigen::VectorXd psi = equation.steady(simple_shear_gradient());
  record("a11 in steady shear, C_I = 0.01", 0.7271243, equation.second_moment(psi)(0, 0), 1e-7);
  EXPECT_EQ(fault_of(equation.fourth_moment(psi), equation.second_moment(psi), 1e-10), "");
}

TEST(OrientationDistribution, TransientShearReachesTheSteadyState) {
  const FokkerPlanck equation(folgar_tucker(0.05), 20);
  Eigen::VectorXd psi = equation.isotropic();
  equation.advance(psi, simple_shear_gradient(), 60, {.absolute = 1e-10, .relative = 1e-10});
  EXPECT_LT((psi - equation.steady(simple_shear_gradient())).norm(), 1e-8);
}

TEST(OrientationDistribution, WithoutDiffusionItIsJefferysDeformedPopulation) {
  const FokkerPlanck equation(
      {rotary_diffusion_named("jeffery"), retardation_named("none"), closure_named("ibof"), {}}, 40);
  Mat3 gradient;
  gradient << 0.5, 1.25, 2.5, -0.75, 0.25, 1.0, 0.375, -0.5, -0.75;
  Eigen::VectorXd psi = equation.isotropic();
  equation.advance(psi, gradient, 0.3, {.absolute = 1e-12, .relative = 1e-12});
  const Mat3 exact = carried_isotropic_state(fiber_deformation(gradient, 1, 0.3));
  record("error of A2 (norm)", 0, (equation.second_moment(psi) - exact).norm(), 1e-9);
  // psi(p) = |F⁻¹ p|⁻³/(4 pi) of the deformed population, det F = 1.
  const Vec3 p = Vec3(0.4, 0.2, -0.9).normalized();
  const Vec3 back = fiber_deformation(gradient, 1, -0.3) * p;
  EXPECT_NEAR(equation.density(psi, p), std::pow(back.norm(), -3) / (4 * pi), 1e-8);
}

TEST(OrientationDistribution, ItsMomentsObeyTheTensorEquation) {
  // An anisotropic diffusion tensor and a general flow exercise every operator.
  OrientationModel model{rotary_diffusion_named("ard"), retardation_named("none"), closure_named("ibof"), {}};
  model.constants.xi = 0.9;
  model.constants.b1 = 0.05;
  model.constants.b3 = 0.1;
  model.constants.b4 = -0.02;
  model.constants.b5 = 0.03;
  Mat3 gradient;
  gradient << 0.5, 1.25, 2.5, -0.75, 0.25, 1.0, 0.375, -0.5, -0.75;
  const FokkerPlanck equation(model, 14);
  Eigen::VectorXd psi = equation.isotropic();
  const IntegrationTolerance fine{.absolute = 1e-13, .relative = 1e-13};
  equation.advance(psi, gradient, 0.2, fine);
  const double h = 1e-4;
  Eigen::VectorXd ahead = psi, twice = psi;
  equation.advance(ahead, gradient, h, fine);
  equation.advance(twice, gradient, 2 * h, fine);
  const Mat3 here = equation.second_moment(psi);
  const Mat3 measured =
      (4 * equation.second_moment(ahead) - equation.second_moment(twice) - 3 * here) / (2 * h);  // error h²
  const Mat3 diffusion = rotary_diffusion(model, here, gradient);
  const Mat3 predicted = moment_equation(here, equation.fourth_moment(psi), gradient, 0.9, diffusion);
  EXPECT_LT((measured - predicted).norm(), 2e-6);
}

/// The error falls exponentially with the degree: at C_I = 0.1 ten- to a hundredfold for every two degrees.
/// Of degree 8, whose last coefficients are 0.085 of the first, nothing is given.
TEST(OrientationDistribution, EnoughDegreesConverge) {
  const auto a11 = [](int degree) {
    const FokkerPlanck equation(folgar_tucker(0.1), degree);
    return equation.second_moment(equation.steady(simple_shear_gradient()))(0, 0);
  };
  EXPECT_THROW((void)a11(8), SimulationFailure);
  const double coarse = a11(10), better = a11(16), best = a11(24);
  EXPECT_LT(std::abs(better - best), 1e-3 * std::abs(coarse - best));
}

TEST(OrientationDistribution, StartsFromAnyOrientationWithTheFourthMomentOfTheExactClosure) {
  OrientationModel model{
      rotary_diffusion_named("folgar_tucker"), retardation_named("none"), closure_named("exact"), {}};
  model.constants.c_i = 0.01;
  model.constants.xi = 0.9;  // not read: the start is that of slender fibers
  const FokkerPlanck equation(model, 40);
  Mat3 turn;
  turn << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
  const Mat3 second = rotated(Mat3(Vec3(0.55, 0.3, 0.15).asDiagonal()), turn);
  const Eigen::VectorXd psi = equation.with_second_moment(second);
  EXPECT_LT((equation.second_moment(psi) - second).norm(), 1e-9);
  EXPECT_LT((equation.fourth_moment(psi) - close(second, closure_named("exact"))).norm(), 1e-9);
  EXPECT_LT((equation.with_second_moment(Mat3::Identity() / 3) - equation.isotropic()).norm(), 1e-12);
  EXPECT_THROW((void)equation.with_second_moment(Vec3(0.6, 0.4, 0).asDiagonal()), InputError);
  EXPECT_THROW((void)FokkerPlanck(model, 4).with_second_moment(Vec3(0.9, 0.06, 0.04).asDiagonal()),
               InputError);
}

TEST(OrientationDistribution, WhatHasNoDistributionIsRefused) {
  OrientationModel retarded = folgar_tucker(0.01);
  retarded.retardation = retardation_named("rsc");
  EXPECT_THROW(FokkerPlanck(retarded, 10), InputError);
  EXPECT_THROW(FokkerPlanck(folgar_tucker(0.01), 7), InputError);
  OrientationModel indefinite{
      rotary_diffusion_named("iard"), retardation_named("none"), closure_named("ibof"), {}};
  indefinite.constants.c_i = 0.05;
  indefinite.constants.c_m = 0.9;
  const FokkerPlanck equation(indefinite, 10);
  EXPECT_THROW((void)equation.steady(uniaxial_elongation_gradient()), InputError);
}

}  // namespace
}  // namespace fiberfate
