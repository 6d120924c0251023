// Tests that tensors, lengths and bins that mean nothing are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/bootstrap.hpp"
#include "microstructure/length_distribution.hpp"
#include "microstructure/length_statistics.hpp"
#include "microstructure/orientation_sampling.hpp"

namespace fiberfate {
namespace {

const double nan_value = std::nan("");

TEST(ImpossibleTensor, IsToldApartFromOneThatIsSlightlyOff) {
  const auto state = [](double a, double b, double c) { return Mat3(Vec3(a, b, c).asDiagonal()); };
  for (const Mat3& good :
       {state(1, 0, 0), state(0.5, 0.5, 0), state(1.0005, 0, 0), state(0.6, 0.4005, -0.0005)})
    EXPECT_NO_THROW(require_forgivable(good)) << good;
  for (const Mat3& bad : {state(4, 0, 0), state(0.34, 0.34, 0.34), state(0.7, 0.32, -0.02),
                          state(nan_value, 0, 0), state(INFINITY, 0, 0), state(1.2, -0.1, -0.1)})
    EXPECT_THROW(require_forgivable(bad), InputError) << bad;
  Mat3 skew = state(0.5, 0.3, 0.2);
  skew(0, 1) = 0.01;
  EXPECT_THROW(require_forgivable(skew), InputError);
}

/// The shortcut by invariants agrees with principal values, also for tensors with large shear components.
TEST(ImpossibleTensor, ShearBeyondThePrincipalValuesIsSeen) {
  for (double shear = 0; shear < 0.7; shear += 0.01) {
    Mat3 a = Vec3(0.5, 0.3, 0.2).asDiagonal();
    a(0, 1) = a(1, 0) = shear;
    const bool possible = fault_of(a, forgiven_departure).empty();
    EXPECT_EQ(possible, [&] {
      try {
        require_forgivable(a);
      } catch (const InputError&) {
        return false;
      }
      return true;
    }()) << shear;
  }
}

TEST(ImpossibleLengths, AreRefused) {
  EXPECT_THROW(require_admissible(LengthLaw(LengthHistogram{{0, nan_value, 1}, {1, 1}})), InputError);
  EXPECT_THROW(require_admissible(LengthLaw(LengthHistogram{{nan_value, 1}, {1}})), InputError);
  EXPECT_THROW(require_admissible(LengthLaw(LengthHistogram{{0, INFINITY}, {1}})), InputError);
  EXPECT_THROW(static_cast<void>(sample_lengths(SingleLength{1e-3}, {.count = 3, .total = nan_value})),
               InputError);
  EXPECT_THROW(static_cast<void>(rods_for(nan_value, 1e-4)), InputError);
  EXPECT_THROW(static_cast<void>(rods_for(1, 1e-300)), InputError);
  const MeasuredLengths fibers = {{1e-3, 2e-3}, {}};
  EXPECT_THROW(static_cast<void>(length_shares(fibers, {0, nan_value, 1})), InputError);
  EXPECT_THROW(static_cast<void>(even_edges(fibers, 0)), InputError);
  EXPECT_THROW(static_cast<void>(bootstrap_mean_lengths(fibers, {1.5, 10, 1})), InputError);
  EXPECT_THROW(static_cast<void>(bootstrap_mean_lengths(fibers, {0.95, 0, 1})), InputError);
  EXPECT_THROW(static_cast<void>(percentile_interval(1, {}, 0.95)), InputError);
}

TEST(ImpossibleWeights, AreRefused) {
  const std::vector<Vec3> directions = {Vec3::UnitX(), Vec3::UnitY()};
  EXPECT_THROW(static_cast<void>(second_moment(directions, std::vector<double>{1})), InputError);
  EXPECT_THROW(static_cast<void>(deal_orientations(directions, std::vector<double>{1, -1}, 1)), InputError);
  EXPECT_THROW(static_cast<void>(sample_orientations(Mat3::Identity() / 3, std::vector<double>{1, nan_value},
                                                     OrientationDistribution::angular_central_gaussian, 1)),
               InputError);
}

}  // namespace
}  // namespace fiberfate
