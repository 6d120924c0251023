// Tests packings of tens of fibers: what was asked for, threads, walls, several materials, errors.
#include "packing/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "fibers/observables.hpp"
#include "microstructure/exact_closure.hpp"

namespace fiberfate {
namespace {

/// 40 fibers of 1 mm at 15 % by volume: straight ones do not fit (5 D / L = 9.5 %), and the cell is shorter
/// than they.
PackingRequest crowded_request() {
  PackingRequest request;
  request.materials = {{9.5e-6, 73e9, 2550}};
  request.fibers.assign(40, {1e-3, 10, 0});
  request.cell = rectangular_cell(Vec3::Constant(0.4228e-3));
  return request;
}

TEST(Pack, IsBitwiseTheSameForAnyNumberOfThreads) {
  const int before = thread_count();
  PackingRequest request = crowded_request();
  request.fibers.assign(50, {1e-3, 40, 0});  // enough rods for three threads
  request.cell = rectangular_cell(Vec3::Constant(0.45e-3));
  use_threads(1);
  const PackingResult one = pack(request);
  use_threads(3);
  const PackingResult three = pack(request);
  use_threads(before);
  EXPECT_EQ(one.state.position, three.state.position);
  EXPECT_EQ(one.report.steps, three.report.steps);
}

TEST(Pack, KeepsLengthsOrderAndOrientation) {
  PackingRequest request = crowded_request();
  for (std::size_t f = 0; f < 20; ++f) request.fibers[f] = {0.7e-3, 7, 0};
  request.orientation.tensor = Vec3(0.6, 0.3, 0.1).asDiagonal();
  const PackingResult result = pack(request);
  for (const FiberIndex f : result.state.fibers()) {
    const bool is_short = f < FiberIndex(20);
    EXPECT_EQ(result.state.rod_count(f), is_short ? 7 : 10);
    EXPECT_NEAR(fiber_length(result.state, f), is_short ? 0.7e-3 : 1e-3, 1e-15);
    for (const RodIndex rod : result.state.rods(f)) EXPECT_NEAR(result.state.axis(rod).norm(), 1e-4, 1e-16);
  }
  EXPECT_LT(result.report.orientation_error, 0.005);
  EXPECT_LT((orientation_tensor(result.state, Weighting::length) - request.orientation.tensor)
                .cwiseAbs()
                .maxCoeff(),
            0.005);
  EXPECT_LT(result.report.largest_overlap, 0.01);
}

TEST(Pack, LeavesDiluteFibersExactlyStraight) {
  PackingRequest request = crowded_request();
  request.cell = rectangular_cell(Vec3::Constant(0.8e-3));
  const PackingResult result = pack(request);
  EXPECT_TRUE(std::isinf(result.report.minimum_radius));
  EXPECT_EQ(result.report.mean_curvature, 0);
  EXPECT_LT(result.report.largest_overlap, 0.01);
}

// The overlap at rest follows from the balance of bending and contact: softer fibers sink in less.
TEST(Pack, ReportsTheEquilibriumUnderTheContactLaw) {
  PackingRequest request = crowded_request();
  request.rest.force_constant = 50;
  const PackingReport stiff = pack(request).report;
  request.materials[0].youngs_modulus = 1e9;
  const PackingResult soft = pack(request);
  EXPECT_GT(stiff.overlap_at_rest, soft.report.overlap_at_rest);
  EXPECT_EQ(soft.report.end, PackingEnd::at_rest);
  EXPECT_EQ(soft.report.largest_overlap, soft.report.overlap_at_rest);
  EXPECT_LT(soft.report.overlap_at_rest, 0.01);
  EXPECT_EQ(soft.report.minimum_radius, minimum_radius(soft.state));
}

TEST(Pack, MeetsTheRadiusWanted) {
  PackingRequest request = crowded_request();
  request.minimum_radius = 0.4e-3;
  EXPECT_GE(pack(request).report.minimum_radius, 0.4e-3);
}

TEST(Pack, StaysBetweenWalls) {
  PackingRequest request = crowded_request();
  request.cell = rectangular_cell(Vec3(0.5e-3, 0.8e-3, 0.5e-3));
  request.cell.boundary[1] = Boundary::walls;
  request.orientation.tensor = Vec3(0.6, 0.05, 0.35).asDiagonal();
  const PackingResult result = pack(request);
  const double allowed = 9.5e-6 * (1 - 2 * request.overlap_tolerance);
  for (const Vec3& x : result.state.position) {
    EXPECT_GE(x[1], allowed);
    EXPECT_LE(x[1], 0.8e-3 - allowed);
  }
}

TEST(Pack, MixesMaterials) {
  PackingRequest request = crowded_request();
  request.materials.push_back({3.5e-6, 230e9, 1800});
  for (std::size_t f = 0; f < 30; ++f) request.fibers.push_back({0.5e-3, 5, 1});
  const PackingResult result = pack(request);
  EXPECT_LT(result.report.largest_overlap, 0.01);
  EXPECT_EQ(result.state.material(FiberIndex(45)).radius, 3.5e-6);
}

TEST(Pack, TakesMeasuredDirections) {
  PackingRequest request = crowded_request();
  request.cell = rectangular_cell(Vec3::Constant(0.8e-3));
  request.orientation.directions = {Vec3::UnitX(), Vec3::UnitY()};
  const PackingResult result = pack(request);
  EXPECT_NEAR(result.report.orientation_reached(0, 0), 0.5, 0.005);
  EXPECT_NEAR(result.report.orientation_reached(2, 2), 0, 0.005);
}

// Three directions in four of a list of 200, for fibers of two lengths: the moment is that of the whole list.
TEST(Pack, HasTheMomentOfAllMeasuredDirections) {
  PackingRequest request = crowded_request();
  request.cell = rectangular_cell(Vec3::Constant(1.4e-3));
  request.fibers.assign(150, {1e-3, 10, 0});
  for (std::size_t f = 0; f < 150; f += 3) request.fibers[f] = {0.4e-3, 4, 0};
  const std::vector<double> alike(200, 1.0);
  request.orientation.directions = sample_orientations(Vec3(0.6, 0.3, 0.1).asDiagonal(), alike,
                                                       OrientationDistribution::angular_central_gaussian, 7);
  const PackingReport report = pack(request).report;
  EXPECT_NEAR(report.orientation_asked(0, 0), 0.6, 1e-6);
  EXPECT_NEAR(report.orientation_asked(1, 1), 0.3, 1e-6);
  EXPECT_LT(report.orientation_error, 0.005);
}

// What is reported as A4 of the law is that of psi = (p·B·p)^(-3/2) / 4 pi, of which the exact closure is the
// integral (orientation_sampling_test.cpp compares both with quadrature).
TEST(Pack, ReportsTheFourthMomentOfTheSmoothLaw) {
  PackingRequest request = crowded_request();
  request.fibers.assign(1000, {0.2e-3, 2, 0});
  request.cell = rectangular_cell(Vec3::Constant(1.6e-3));
  request.orientation.tensor = Vec3(0.6, 0.3, 0.1).asDiagonal();
  const PackingReport report = pack(request).report;
  const double values[] = {0.6, 0.3, 0.1};
  double law[6];
  close_exactly(values, law);
  const int places[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(report.orientation4_drawn(places[i][0], places[i][1]), law[i], 0.002);
    EXPECT_NEAR(report.orientation4_reached(places[i][0], places[i][1]), law[i], 0.005);
  }
}

// As figure 3.6 makes it, but exact: shares of 3D-random, planar-random and aligned fibers.
TEST(Pack, MixesSubclusters) {
  PackingRequest request = crowded_request();
  request.orientation.tensor = Vec3(0.6, 0.3, 0.1).asDiagonal();
  request.orientation.law = OrientationDistribution::subclusters;
  const PackingReport report = pack(request).report;
  EXPECT_LT(report.orientation_error, 0.005);
  // 0.3 of 3D-random (1/5), 0.4 of planar-random (3/8) and 0.3 aligned have a1111 = 0.51; 40 fibers are
  // coarse.
  EXPECT_NEAR(report.orientation4_drawn(0, 0), 0.51, 0.03);
}

TEST(Pack, BundlesHoldTheirFibersApartAndParallel) {
  PackingRequest request = crowded_request();
  request.fibers.assign(70, {0.5e-3, 5, 0});
  request.start = PackingStart::bundles;
  request.bundle = {7, 0.5};
  const PackingResult result = pack(request);
  EXPECT_LT(result.report.largest_overlap, 0.01);
  EXPECT_LT(result.report.orientation_error, 0.005);
  // 19 um sqrt(pi / (2 sqrt(3) 0.5)) = 25.6 um apart, the six around the first.
  const Vec3 first = fiber_centroid(result.state, FiberIndex(0));
  int near = 0;
  for (int f = 1; f < 7; ++f) {
    const Vec3 apart = fiber_centroid(result.state, FiberIndex(f)) - first;
    const Vec3 whole =
        apart - result.state.cell.shift(
                    image_of(result.state.cell, apart + result.state.cell.lattice * Vec3(0.5, 0.5, 0.5)));
    near += std::abs(whole.norm() - 25.6e-6) < 5e-6;
  }
  EXPECT_EQ(near, 6);
}

// At a fifth by volume single fibers sink into each other under the contact law; the smallest bundles that
// fill a hexagon do not.
TEST(Pack, BundlesOfSevenRestWhereSingleFibersSinkIn) {
  PackingRequest request = crowded_request();
  request.fibers.assign(70, {2.5e-3, 25, 0});
  request.cell = rectangular_cell(Vec3::Constant(0.618e-3));
  request.rest.force_constant = 500;
  EXPECT_GT(pack(request).report.overlap_at_rest, 0.1);
  request.start = PackingStart::bundles;
  request.bundle = {7, 0.6};
  const PackingReport report = pack(request).report;
  EXPECT_LT(report.overlap_at_rest, 0.02);
  EXPECT_LT(report.largest_overlap, 0.01);
  EXPECT_LT(report.orientation_error, 0.005);
  EXPECT_GT(report.minimum_radius, 700e-6);
}

std::string refusal(const PackingRequest& request) {
  try {
    (void)pack(request);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "accepted";
}

TEST(Pack, RefusesBundlesThatDoNotFit) {
  PackingRequest request = crowded_request();
  request.start = PackingStart::bundles;
  request.bundle = {19, 0.95};
  EXPECT_EQ(refusal(request),
            "fibers fill 0.95 of a bundle: give a fraction above 0 and at most 0.9069 (pi / sqrt 12)");
  request.bundle = {19, 0.1};
  EXPECT_EQ(refusal(request).substr(0, 13), "the bundles f");
}

// The thesis' complaint: compression of planar fibers does not give the orientation that was asked for.
TEST(Pack, ThePublishedRouteStaysNearlyPlanar) {
  PackingRequest request = crowded_request();
  request.start = PackingStart::compressed;
  const PackingResult result = pack(request);
  EXPECT_LT(result.report.largest_overlap, 0.01);
  EXPECT_LT(result.report.orientation_reached(2, 2), 0.1);
  EXPECT_GT(result.report.orientation_error, 0.2);
}

TEST(Pack, ReportsProgress) {
  int calls = 0;
  PackingProgress last;
  (void)pack(crowded_request(), [&](const PackingProgress& progress) {
    ++calls;
    last = progress;
  });
  EXPECT_GT(calls, 5);
  EXPECT_GT(last.step, 200);
}

TEST(Pack, RefusesWhatCannotBe) {
  PackingRequest request = crowded_request();
  request.fibers.clear();
  EXPECT_EQ(refusal(request), "there are no fibers to pack: ask for at least one");
  request = crowded_request();
  request.cell = rectangular_cell(Vec3::Constant(0.2e-3));
  EXPECT_EQ(
      refusal(request),
      "the fibers fill 1.418 of the cell: fibers with this orientation fill at most 0.589, parallel ones "
      "0.9069: lower the concentration, or align them");
  request.cell = rectangular_cell(Vec3(10e-3, 10e-3, 30e-6));
  EXPECT_EQ(refusal(request), "the cell is 3e-05 m high: give at least two fiber diameters, 3.8e-05 m");
  request = crowded_request();
  request.overlap_tolerance = 0;
  EXPECT_EQ(refusal(request), "the overlap tolerance is 0 diameters: give a number between 0 and 1");
  request = crowded_request();
  request.swelling = 0.5;
  EXPECT_EQ(refusal(request), "the swelling is 0.5 diameters: give a number from 1 to 10");
  request = crowded_request();
  request = crowded_request();
  request.fibers.resize(2);
  EXPECT_EQ(refusal(request),
            "2 fibers cannot have this orientation: the nearest that they have is off by 0.18: "
            "ask for more fibers, or for an orientation tolerance above that");
  request = crowded_request();
  request.orientation.tensor = Vec3(0.8, 0.3, -0.1).asDiagonal();
  EXPECT_EQ(refusal(request),
            "the orientation tensor has the eigenvalue -0.1, and no fibers have a negative one: "
            "the nearest possible tensor is [0.75, 0.25, 0]");
}

// 171 images in each direction took gigabytes, and in dynamics wrapped.
TEST(Pack, RefusesFibersOfHundredsOfCells) {
  PackingRequest request;
  request.materials = {{0.5e-6, 73e9, 2550}};
  request.fibers = {{13e-3, 100, 0}};
  request.cell = rectangular_cell(Vec3::Constant(76e-6));
  EXPECT_EQ(
      refusal(request),
      "a fiber is 171.1 times as long as the cell is high: make the cell larger or the fibers shorter: at "
      "most 100 times");
}

TEST(Pack, SaysWhatWasReachedWhenItGivesUp) {
  PackingRequest request = crowded_request();
  request.minimum_radius = 0.1;  // ten centimetres: as good as straight
  request.step_limit = 900;
  try {
    (void)pack(request);
    FAIL() << "packed";
  } catch (const SimulationFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("no packing was found in 900 steps: overlap 0"),
              std::string::npos)
        << failure.what();
    EXPECT_NE(std::string(failure.what()).find("at a smallest radius of 0.00"), std::string::npos)
        << failure.what();
  }
}

}  // namespace
}  // namespace fiberfate
