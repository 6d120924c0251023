// Checks averages, corrections and bootstrap intervals of measured fibers.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "microstructure/length_statistics.hpp"
#include "microstructure/orientation_statistics.hpp"

namespace fiberfate {
namespace {

TEST(LengthStatistics, MeansFollowTheirDefinitions) {
  const MeasuredLengths list{{1e-3, 2e-3, 3e-3}};
  EXPECT_NEAR(number_average(list), 2e-3, 1e-18);
  EXPECT_NEAR(weight_average(list), 14e-6 / 6e-3, 1e-18);
  const MeasuredLengths counted{{1e-3, 3e-3}, {3, 1}};
  EXPECT_NEAR(number_average(counted), 1.5e-3, 1e-18);
  EXPECT_THROW((void)number_average(MeasuredLengths{}), InputError);
  EXPECT_THROW((void)number_average(MeasuredLengths{{1e-3, -1e-3}}), InputError);
}

TEST(LengthStatistics, SharesSumToOneAndKeepTheEdges) {
  const MeasuredLengths list{{1, 1, 2, 4}};
  const LengthShares shares = length_shares(list, {0, 1, 2, 4});
  EXPECT_EQ(shares.by_number, (std::vector<double>{0, 0.5, 0.5}));
  EXPECT_EQ(shares.by_length, (std::vector<double>{0, 0.25, 0.75}));
  EXPECT_THROW((void)length_shares(list, {0, 0}), InputError);
}

TEST(LengthStatistics, DeviationsOfSharesAreThoseOfTheBootstrap) {
  const MeasuredLengths list{{1, 1, 1, 3, 3, 3, 3, 5}, {2, 1, 1, 1, 1, 1, 1, 1}};
  const LengthShares shares = length_shares(list, {0, 2, 4, 6, 8});
  const std::vector<double> deviations = share_deviations(list, shares);
  // Counts 1: sum N² over (sum N)²; an empty bin has that of one fiber.
  const double share = 4.0 / 9, inside = 4 + 1 + 1, outside = 5;
  EXPECT_NEAR(deviations[0], std::sqrt(inside * (1 - share) * (1 - share) + outside * share * share) / 9,
              1e-15);
  EXPECT_NEAR(deviations[3], std::sqrt(11.0 / 8) / 9, 1e-15);
}

/// Drops fibers at random on a plane and keeps those that meet a circle: the experiment that the correction
/// undoes.
MeasuredLengths caught_by_circle(const std::vector<double>& lengths, double diameter, int drops) {
  const double radius = diameter / 2, reach = radius + lengths.back();
  MeasuredLengths caught;
  for (int i = 0; i < drops; ++i) {
    const auto u = uniform4(1, RandomStream::noise, {static_cast<std::uint32_t>(i)});
    const double length = lengths[static_cast<std::size_t>(i) % lengths.size()];
    const double x = (2 * u[0] - 1) * reach, y = (2 * u[1] - 1) * reach, angle = pi * u[2];
    const double along = -(x * std::cos(angle) + y * std::sin(angle));
    const double s = std::clamp(along, -length / 2, length / 2);
    if (std::hypot(x + s * std::cos(angle), y + s * std::sin(angle)) <= radius)
      caught.lengths.push_back(length);
  }
  return caught;
}

TEST(LengthStatistics, TheCorrectionUndoesDownSampling) {
  const std::vector<double> lengths = {0.1, 1, 3};  // equally many of each
  const MeasuredLengths caught = caught_by_circle(lengths, 2, 400000);
  const double biased = number_average(caught);
  const double corrected = number_average(corrected_for_sampling(caught, 2));
  const double truth = 4.1 / 3;
  EXPECT_GT(biased, 1.3 * truth);
  EXPECT_NEAR(corrected, truth, 0.01 * truth);  // 1e5 caught: standard error 0.3 %
  EXPECT_THROW((void)corrected_for_sampling(caught, 0), InputError);
}

TEST(LengthStatistics, BootstrapIntervalsHoldAsOftenAsTheySay) {
  // Exponential lengths of mean 1: in 95 % of repetitions the interval of L_N holds 1, less a little for 100
  // fibers.
  int held = 0;
  constexpr int repetitions = 200;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    MeasuredLengths list;
    for (std::uint32_t i = 0; i < 100; ++i)
      list.lengths.push_back(
          -std::log(uniform(2, RandomStream::noise, {i, static_cast<std::uint32_t>(repetition)})));
    const LengthIntervals intervals =
        bootstrap_mean_lengths(list, {0.95, 200, static_cast<std::uint64_t>(repetition)});
    EXPECT_LT(intervals.number_average.lower, intervals.number_average.estimate);
    held += intervals.number_average.lower < 1 && 1 < intervals.number_average.upper;
  }
  EXPECT_GT(held, 0.88 * repetitions);
  EXPECT_LT(held, 0.99 * repetitions);
}

TEST(OrientationStatistics, MomentsFollowTheirDefinitions) {
  const MeasuredDirections list{{Vec3(2, 0, 0), Vec3(0, 0, -1)}, {3, 1}};
  EXPECT_NEAR(second_moment(list)(0, 0), 0.75, 1e-15);
  EXPECT_NEAR(second_moment(list)(2, 2), 0.25, 1e-15);
  const Mat6 fourth = fourth_moment(list);
  EXPECT_LT((contracted(fourth, Mat3::Identity()) - second_moment(list)).norm(), 1e-15);
  const Vec3 p = direction_of(pi / 2, pi / 2);
  EXPECT_NEAR(p[1], 1, 1e-15);
  EXPECT_THROW((void)second_moment(MeasuredDirections{{Vec3::Zero()}}), InputError);
}

/// Planes cut fibers in proportion to |p·n|; with what is caught weighed back, the whole population results.
TEST(OrientationStatistics, TheCorrectionOfACutUndoesIt) {
  MeasuredDirections all, caught;
  const Vec3 normal(0, 0, 2);
  for (std::uint32_t i = 0; i < 100000; ++i) {
    const auto u = uniform4(3, RandomStream::noise, {i});
    const double theta = std::acos(1 - 2 * u[0]) * 0.8, phi = 2 * pi * u[1];
    all.directions.push_back(direction_of(theta, phi));
    if (u[2] < std::max(std::abs(std::cos(theta)), 0.05)) caught.directions.push_back(all.directions.back());
  }
  const Mat3 truth = second_moment(all);
  EXPECT_GT(second_moment(caught)(2, 2), truth(2, 2) + 0.1);
  const Mat3 corrected = second_moment(corrected_for_cut(caught, normal, 20));
  EXPECT_LT((corrected - truth).norm(), 0.01);  // 1e5 fibers: standard error of each component 0.001
  EXPECT_THROW((void)corrected_for_cut(caught, Vec3::Zero(), 20), InputError);
  EXPECT_THROW((void)corrected_for_cut(caught, normal, 0.5), InputError);
}

TEST(OrientationStatistics, BootstrapIntervalsEncloseTheEstimateAndRepeat) {
  MeasuredDirections list;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const auto u = uniform4(3, RandomStream::noise, {i});
    list.directions.push_back(direction_of(std::acos(2 * u[0] - 1), 2 * pi * u[1]));
  }
  const OrientationInterval interval = bootstrap_second_moment(list, {0.95, 200, 7});
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(interval.lower(i, i), 1.0 / 3);
    EXPECT_GT(interval.upper(i, i), 1.0 / 3);
    // Standard deviation of <p_i²> of n isotropic fibers: sqrt(4/45/n) = 0.0172.
    EXPECT_NEAR(interval.upper(i, i) - interval.lower(i, i), 2 * 1.96 * 0.0172, 0.015);
  }
  EXPECT_EQ(bootstrap_second_moment(list, {0.95, 200, 7}).lower, interval.lower);
}

}  // namespace
}  // namespace fiberfate
