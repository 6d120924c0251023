// A fiber that the flow compresses buckles above a threshold and stays straight below it.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "base/constants.hpp"
#include "fibers/observables.hpp"
#include "physics/record.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

// Theory. A straight fiber lies along p with p·D·p = −e; its beads resist motion alike in all directions with
// zeta = 3 pi eta per length. The flow compresses it: at s from its middle the tension is −(zeta e/2)(L²/4 −
// s²). In the frame that turns with the fiber, a small sideways displacement y(s, t) obeys
//   y' = e y − (e/2) ((L²/4 − s²) y_s)_s − (E I/zeta) y_ssss,      y_ss = y_sss = 0 at the ends
// (the first term is the flow pulling sideways: n·D·n = +e). With x = 2 s/L the growth rate in units of e
// depends on
//   beta = e zeta L⁴/(16 E I)
// alone. The uniform displacement grows with e without bending; the first even bending mode grows above
// beta_c = 7.719.
constexpr double critical_beta = 7.7190;
constexpr int polynomials = 8;  // even Legendre polynomials of the Galerkin solution; converged to 1e-8

/// The most dangerous bending mode.
struct BucklingMode {
  double growth = 0;             ///< in units of e
  Eigen::VectorXd coefficients;  ///< of P_0, P_2, P_4, …
  [[nodiscard]] double operator()(double x) const {
    double y = 0;
    for (int i = 0; i < polynomials; ++i) y += coefficients[i] * std::legendre(unsigned(2 * i), x);
    return y;
  }
};

double derivative(int degree, int order, double x) {
  if (order == 0) return std::legendre(unsigned(degree), x);
  if (degree == 0) return 0;
  // P'_n = P'_{n−2} + (2n − 1) P_{n−1}
  const double lower = degree >= 2 ? derivative(degree - 2, order, x) : 0;
  return lower + (2 * degree - 1) * derivative(degree - 1, order - 1, x);
}

BucklingMode buckling_mode(double beta) {
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(polynomials, polynomials);
  Eigen::MatrixXd force = mass;
  const int points = 4000;
  for (int k = 0; k < points; ++k) {
    const double x = -1 + (k + 0.5) * 2 / points;
    Eigen::VectorXd value(polynomials), slope(polynomials), curvature(polynomials);
    for (int i = 0; i < polynomials; ++i) {
      value[i] = derivative(2 * i, 0, x);
      slope[i] = derivative(2 * i, 1, x);
      curvature[i] = derivative(2 * i, 2, x);
    }
    const double weight = 2.0 / points;
    mass += weight * value * value.transpose();
    force += weight * (value * value.transpose() + 0.5 * (1 - x * x) * slope * slope.transpose() -
                       curvature * curvature.transpose() / beta);
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(force, mass);
  // Of the two that grow fastest one is the uniform displacement, growth 1.
  const int last = polynomials - 1;
  const int bending = std::abs(modes.eigenvalues()[last] - 1) < 1e-6 ? last - 1 : last;
  return {modes.eigenvalues()[bending], modes.eigenvectors().col(bending)};
}

constexpr double length = 2.5e-3;  // m
constexpr double rate = 10;        // 1/s
constexpr double compression = rate / 2;

double viscosity_for(double beta) {
  const double zeta = beta * 16 * scenes::glass.bending_stiffness() / (compression * std::pow(length, 4));
  return zeta / (3 * pi);
}

Vec3 along(double angle) {
  return {std::cos(angle), std::sin(angle), 0};
}

/// Describes a nearly straight fiber.
struct BentFiber {
  double angle = 0.75 * pi;  ///< to the flow direction; at 135 degrees u_x = rate · y compresses it most
  double amplitude = 1e-6;   ///< of the mode, in lengths
  int rods = 40;
};

FiberState bend_into(const BucklingMode& mode, const BentFiber& fiber) {
  const Vec3 p = along(fiber.angle);
  const Vec3 n(-p.y(), p.x(), 0);
  std::vector<Vec3> nodes;
  for (int k = 0; k <= fiber.rods; ++k) {
    const double x = -1 + 2.0 * k / fiber.rods;
    nodes.emplace_back(length * (0.5 * x * p + fiber.amplitude * mode(x) * n));
  }
  return scenes::lone_fiber(nodes);
}

/// Size of the even part of the bending. The odd part is another matter: the strain's couple on the rods'
/// thickness acts like a pair of forces at the ends and bends any fiber that turns very slightly into an S.
double bending(const FiberState& state) {
  const std::vector<Vec3>& x = state.position;
  const std::size_t last = x.size() - 1;
  const auto turn = [&](std::size_t k) -> Vec3 { return x[k + 1] - 2 * x[k] + x[k - 1]; };
  double sum = 0;
  for (std::size_t k = 1; k < last; ++k) sum += (turn(k) + turn(last - k)).squaredNorm();
  return std::sqrt(sum);
}

/// Growth rate of the bending in units of e over a strain of 0.01 about the most compressed direction.
double measured_growth(double beta) {
  Simulation simulation(scenes::lone_and_fixed_step(1e-4 / rate),
                        FlowHistory::constant(rate, viscosity_for(beta)), bend_into(buckling_mode(beta), {}));
  const double begin = bending(simulation.state());
  const double duration = 0.01 / rate;
  scenes::run_until(simulation, duration);
  return std::log(bending(simulation.state()) / begin) / (compression * duration);
}

TEST(Buckling, ThresholdIsWhereTheoryPutsIt) {
  EXPECT_LT(buckling_mode(0.999 * critical_beta).growth, 0);
  EXPECT_GT(buckling_mode(1.001 * critical_beta).growth, 0);
}

TEST(Buckling, IsBracketedFromBothSides) {
  EXPECT_LT(measured_growth(0.99 * critical_beta), 0);
  EXPECT_GT(measured_growth(1.01 * critical_beta), 0);
}

// The tolerance covers the length of 40 rods (0.8 % at the shortest waves, second order) and the fiber's
// turning.
TEST(Buckling, GrowsAsTheoryPredicts) {
  for (const double beta : {4.0, 8.0, 20.0, 60.0}) {
    const double theory = buckling_mode(beta).growth;
    record("growth of the bending in units of the compression, beta = " + std::to_string(int(beta)), theory,
           measured_growth(beta), 0.01 * std::abs(theory) + 0.006);
  }
}

/// Sharpest bend, over that at the start, that a nearly straight fiber shows while it turns from 170 to about
/// 10 degrees.
double sharpest_bend(double beta) {
  const double end = 12 / rate;
  Simulation simulation(
      scenes::lone_and_fixed_step(1e-3 / rate), FlowHistory::constant(rate, viscosity_for(beta)),
      bend_into(buckling_mode(beta), {.angle = 170 * pi / 180, .amplitude = 1e-3, .rods = 25}));
  const double start = minimum_radius(simulation.state());
  double sharpest = start;
  while (simulation.state().time < end) {
    simulation.advance(end);
    sharpest = std::min(sharpest, minimum_radius(simulation.state()));
  }
  return start / sharpest;
}

// On the way through the compressive quadrant an imperfection of R = 50 L only fades below the threshold; far
// above it the fiber folds.
TEST(Buckling, HappensOnTheWayThroughTheCompressiveQuadrant) {
  EXPECT_LT(sharpest_bend(0.95 * critical_beta), 1.001);
  EXPECT_GT(sharpest_bend(30 * critical_beta), 20);
}

}  // namespace
}  // namespace fiberfate
