// Compares packings with all pairs of all images: no overlap, whatever the neighbour lists found; and
// measures the contact number of fibers placed at random against theory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "fibers/closest_points.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

/// Largest overlap of all rods with all others in all images, in diameters; only neighbours in the chain are
/// left out.
double largest_overlap(const FiberState& state, int images) {
  double largest = 0;
  IntVec3 image;
  for (image[0] = -images; image[0] <= images; ++image[0])
    for (image[1] = -images; image[1] <= images; ++image[1])
      for (image[2] = -images; image[2] <= images; ++image[2]) {
        const Vec3 shift = state.cell.shift(image);
        for (const FiberIndex f : state.fibers())
          for (FiberIndex g; g <= f; ++g)
            for (const RodIndex i : state.rods(f))
              for (const RodIndex j : state.rods(g)) {
                if (f == g && image.isZero() && std::abs(i - j) <= 1) continue;
                const double reach = 0.5 * (state.rod_length[i] + state.rod_length[j]) + 2e-5;
                const Vec3 apart = state.centre(i) - state.centre(j) - shift;
                if (apart.squaredNorm() > reach * reach) continue;
                const double distance =
                    closest_points(state.segment(i), shifted(state.segment(j), shift)).distance;
                const double touching = state.material(f).radius + state.material(g).radius;
                largest = std::max(largest, 1 - distance / touching);
              }
      }
  return largest;
}

PackingRequest request_of(int count, double length, int rods, double edge) {
  PackingRequest request;
  request.materials = {{9.5e-6, 73e9, 2550}};
  request.fibers.assign(static_cast<std::size_t>(count), {length, rods, 0});
  request.cell = rectangular_cell(Vec3::Constant(edge));
  return request;
}

TEST(Packing, HasNoOverlapByBruteForce) {
  for (const Vec3& principal : {Vec3(1. / 3, 1. / 3, 1. / 3), Vec3(0.6, 0.3, 0.1)}) {
    for (const std::uint64_t seed : {1u, 2u}) {
      // 18.9 % by volume, fibers twice as long as the cell.
      PackingRequest request = request_of(50, 1e-3, 10, 0.4217e-3);
      request.orientation.tensor = principal.asDiagonal();
      request.seed = seed;
      const PackingResult result = pack(request);
      const double overlap = largest_overlap(result.state, 3);
      EXPECT_LT(overlap, 0.01);
      EXPECT_NEAR(overlap, result.report.largest_overlap, 1e-6);
      EXPECT_LT(result.report.orientation_error, 0.005);
      EXPECT_GT(result.report.minimum_radius, 0.4e-3);
    }
  }
}

TEST(Packing, OfTheDiluteThesisCaseIsStraight) {
  // Tables 1 and 2: 138 fibers of 0.25 mm at 10 % by weight (3.79 % by volume).
  const PackingResult result = pack(request_of(138, 0.25e-3, 5, 0.6371e-3));
  EXPECT_LT(largest_overlap(result.state, 1), 0.01);
  EXPECT_TRUE(std::isinf(result.report.minimum_radius));
  EXPECT_LT(result.report.orientation_error, 0.005);
}

/// Straight fibers placed at random pass one another as often as the theory in the report says.
TEST(PackingReport, CountsRandomFibersAsTheTheoryDoes) {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}};
  state.cell = rectangular_cell(Vec3::Constant(1e-3));
  const int count = 400;
  const std::vector<double> weights(count, 1.0);
  const auto directions = sample_orientations(Mat3::Identity() / 3, weights,
                                              OrientationDistribution::angular_central_gaussian, 1);
  for (int f = 0; f < count; ++f) {
    const auto u = uniform4(2, RandomStream::position, {static_cast<std::uint32_t>(f), 0, 0});
    std::vector<Vec3> nodes;
    for (int k = 0; k <= 8; ++k)
      nodes.push_back(1e-3 * Vec3(u[0], u[1], u[2]) +
                      (k - 4) * 1e-4 * directions[static_cast<std::size_t>(f)]);
    append_fiber(state, {nodes, 0});
  }
  const PackingReport report = measure_packing(state, Mat3::Identity() / 3);
  // Poisson: 400 fibers × 11 contacts / 2 = 2200 independent pairs, 2 % standard error; 4 errors.
  EXPECT_NEAR(report.contacts_per_fiber / report.contacts_random, 1, 0.09);
  double counted = 0, expected = 0;
  for (const PairDistanceBin& bin : report.pair_distances) {
    counted += bin.per_fiber;
    expected += bin.random;
  }
  // To four diameters: 8800 pairs, 1 %.
  EXPECT_NEAR(counted / expected, 1, 0.045);
}

TEST(PackingReport, DoesNotDependOnTheChoiceOfImages) {
  const PackingResult result = pack(request_of(30, 0.6e-3, 6, 0.4e-3));
  FiberState moved = result.state;
  for (const FiberIndex fiber : moved.fibers()) {
    const Index f = fiber.value();
    const Vec3 shift = moved.cell.shift(IntVec3(f % 3 - 1, f % 2, -(f % 5))) + Vec3(1e-4, -2e-4, 3e-5);
    for (const NodeIndex node : moved.nodes(fiber)) moved.position[node] += shift;
  }
  const PackingReport again = measure_packing(moved, result.report.orientation_asked);
  EXPECT_NEAR(again.largest_overlap, result.report.largest_overlap, 1e-9);
  EXPECT_DOUBLE_EQ(again.contacts_per_fiber, result.report.contacts_per_fiber);
}

}  // namespace
}  // namespace fiberfate
