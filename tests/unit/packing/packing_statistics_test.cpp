// Tests the theory of random fibers in the report on packings of two kinds.
#include "packing/packing_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "base/random.hpp"
#include "microstructure/orientation_sampling.hpp"

namespace fiberfate {
namespace {

/// Straight fibers of two kinds anywhere in a cube of 1 mm.
FiberState random_mixture(int count) {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}, {3.5e-6, 230e9, 1800}};
  state.cell = rectangular_cell(Vec3::Constant(1e-3));
  const std::vector<double> weights(static_cast<std::size_t>(count), 1.0);
  const auto directions = sample_orientations(Mat3::Identity() / 3, weights,
                                              OrientationDistribution::angular_central_gaussian, 1);
  for (int f = 0; f < count; ++f) {
    const auto u = uniform4(3, RandomStream::position, {static_cast<std::uint32_t>(f), 0, 0});
    const double half = f % 2 == 0 ? 0.4e-3 : 0.15e-3;
    const Vec3 centre = 1e-3 * Vec3(u[0], u[1], u[2]), arm = half * directions[static_cast<std::size_t>(f)];
    const std::vector<Vec3> nodes = {centre - arm, centre + arm};
    append_fiber(state, {nodes, static_cast<std::uint16_t>(f % 2)});
  }
  return state;
}

TEST(PackingStatistics, ExpectsContactsOfMixturesPairByPair) {
  const PackingReport report = measure_packing(random_mixture(2000), Mat3::Identity() / 3);
  // The same theory as a sum over the four pairs of kinds; isotropic fibers have <|sin|> = pi / 4.
  const double length[] = {0.8e-3, 0.3e-3}, radius[] = {9.5e-6, 3.5e-6};
  double expected = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double h = 1.05 * (radius[i] + radius[j]);
      expected += 0.25 * 2000 / 1e-9 *
                  (2 * length[i] * length[j] * h * pi / 4 + pi * h * h * (length[i] + length[j]) +
                   4.0 / 3 * pi * h * h * h);
    }
  EXPECT_NEAR(report.contacts_random / expected, 1, 0.01);  // its <|sin|> is measured on 1000 rods
  // Poisson: some 3000 independent pairs, 2 % standard error; 4 errors.
  EXPECT_NEAR(report.contacts_per_fiber / expected, 1, 0.08);
}

TEST(PackingStatistics, MeasuresTheSpreadOfCurvature) {
  FiberState state;
  state.materials = {{1e-6, 73e9, 2550}};
  state.cell = rectangular_cell(Vec3::Constant(1e-3));
  // One hinge of radius 100 um (three nodes of a circle), one straight.
  const double turn = 0.1;
  std::vector<Vec3> nodes;
  for (int k = 0; k < 3; ++k) nodes.push_back(1e-4 * Vec3(std::cos(k * turn), std::sin(k * turn), 0));
  append_fiber(state, {nodes, 0});
  append_fiber(state, {std::vector<Vec3>{{5e-4, 0, 0}, {5.1e-4, 0, 0}, {5.2e-4, 0, 0}}, 0});
  const PackingReport report = measure_packing(state, Mat3::Identity() / 3);
  EXPECT_NEAR(report.minimum_radius, 1e-4, 1e-10);
  EXPECT_NEAR(report.mean_curvature, 0.5e4, 1e-2);
  EXPECT_NEAR(report.rms_curvature, 1e4 / std::sqrt(2.0), 1e-2);
  EXPECT_DOUBLE_EQ(report.sharp_hinges, 0.5);
}

}  // namespace
}  // namespace fiberfate
