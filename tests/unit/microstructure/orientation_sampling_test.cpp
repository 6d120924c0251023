// Tests that sampled directions have the moment that was asked for, and that impossible tensors are refused.
#include "microstructure/orientation_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "microstructure/exact_closure.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {
namespace {

Mat3 diagonal(double a, double b, double c) {
  return Vec3(a, b, c).asDiagonal();
}

/// Figure 3.7 of the thesis; its eigenvalues are 0.6, 0.3, 0.1.
Mat3 full_tensor() {
  Mat3 a;
  a << 0.34444, -0.17778, 0.15556, -0.17778, 0.41112, -0.02222, 0.15556, -0.02222, 0.24444;
  return a;
}

std::vector<double> random_weights(std::size_t count) {
  std::vector<double> weights(count);
  for (std::size_t i = 0; i < count; ++i)
    weights[i] = 0.1 + uniform(3, RandomStream::noise, {static_cast<std::uint32_t>(i), 0, 0});
  return weights;
}

double error(const std::vector<Vec3>& p, const std::vector<double>& weights, const Mat3& tensor) {
  return (second_moment(p, weights) - tensor).cwiseAbs().maxCoeff();
}

std::string refusal(const Mat3& tensor) {
  try {
    require_admissible(tensor);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "accepted";
}

class OrientationSampling : public testing::TestWithParam<OrientationDistribution> {};
INSTANTIATE_TEST_SUITE_P(Laws, OrientationSampling,
                         testing::Values(OrientationDistribution::angular_central_gaussian,
                                         OrientationDistribution::subclusters));

TEST_P(OrientationSampling, HasTheTensorExactly) {
  const std::vector<Mat3> tensors = {diagonal(1. / 3, 1. / 3, 1. / 3),
                                     diagonal(0.6, 0.3, 0.1),
                                     full_tensor(),
                                     diagonal(0.5, 0.5, 0),
                                     diagonal(0.7, 0, 0.3),
                                     diagonal(0, 1, 0),
                                     diagonal(0.1, 0.89, 0.01),
                                     diagonal(0.98, 0.01, 0.01)};
  for (const Mat3& tensor : tensors) {
    for (const std::size_t count : {138u, 1331u}) {
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const std::vector<double> weights = random_weights(count);
        const auto p = sample_orientations(tensor, weights, GetParam(), seed);
        for (const Vec3& direction : p) EXPECT_NEAR(direction.norm(), 1, 1e-14);
        // The fit ends at 1e-13 but for strongly aligned tensors, where round-off of A^-1/2 stops it a little
        // earlier; tensors given in five figures have a trace that is off by 1e-6 at most.
        EXPECT_LT(error(p, weights, tensor), 2e-6) << tensor << " with " << count;
      }
    }
  }
}

TEST_P(OrientationSampling, IsUnbiasedInSignAndDiffersBySeed) {
  const std::vector<double> weights(1000, 1.0);
  const auto first = sample_orientations(diagonal(0.6, 0.3, 0.1), weights, GetParam(), 1);
  const auto second = sample_orientations(diagonal(0.6, 0.3, 0.1), weights, GetParam(), 2);
  EXPECT_NE(first[0], second[0]);
  const Vec3 mean = std::accumulate(first.begin(), first.end(), Vec3(Vec3::Zero())) / 1000;
  EXPECT_LT(mean.norm(), 4 / std::sqrt(1000.0));  // four standard errors of a coin
}

TEST(OrientationSampling, OfOneOrTwoFibersIsAtLeastDirections) {
  for (const std::size_t count : {1u, 2u, 3u}) {
    const std::vector<double> weights(count, 1.0);
    for (const OrientationDistribution law :
         {OrientationDistribution::angular_central_gaussian, OrientationDistribution::subclusters}) {
      for (const Vec3& p : sample_orientations(diagonal(0.5, 0.3, 0.2), weights, law, 5))
        EXPECT_NEAR(p.norm(), 1, 1e-14);
    }
  }
}

// For the angular central Gaussian with an isotropic target A4 is isotropic: <p1^4> = 1/5, <p1^2 p2^2> =
// 1/15.
TEST(OrientationSampling, IsotropicHasTheIsotropicFourthMoment) {
  const std::vector<double> weights(1000, 1.0);
  const auto p = sample_orientations(Mat3::Identity() / 3, weights,
                                     OrientationDistribution::angular_central_gaussian, 1);
  double fourth = 0, mixed = 0;
  for (const Vec3& d : p) {
    fourth += std::pow(d[0], 4) / 1000;
    mixed += d[0] * d[0] * d[1] * d[1] / 1000;
  }
  EXPECT_NEAR(fourth, 1. / 5, 1e-3);  // a Fibonacci sphere of 1000 integrates quartics to about 1 / N
  EXPECT_NEAR(mixed, 1. / 15, 1e-3);
}

// The mixture of (3.28) has <p3^4> = 3 a3 / 5 because only the 3D-random part leaves the plane.
TEST(OrientationSampling, SubclustersHaveTheFourthMomentOfTheMixture) {
  const std::vector<double> weights(5000, 1.0);
  const auto p =
      sample_orientations(diagonal(0.6, 0.3, 0.1), weights, OrientationDistribution::subclusters, 1);
  double fourth = 0;
  for (const Vec3& d : p) fourth += std::pow(d[2], 4) / 5000;
  EXPECT_NEAR(fourth, 0.3 / 5, 1e-3);
}

TEST(OrientationSampling, DealsGivenDirectionsEvenly) {
  const std::vector<Vec3> measured = {{2, 0, 0}, {0, 3, 0}, {0, 0, 0.5}};
  const std::vector<double> weights(300, 1.0);
  const auto dealt = deal_orientations(measured, weights, 9);
  EXPECT_LT(error(dealt, weights, Mat3::Identity() / 3), 1e-14);
  EXPECT_THROW((void)deal_orientations({}, weights, 1), InputError);
  const std::vector<Vec3> zero = {Vec3::Zero()};
  EXPECT_THROW((void)deal_orientations(zero, weights, 1), InputError);
}

// A thousand of five thousand measured fibers, of unequal lengths: at random they would be off by some 0.01.
TEST(OrientationSampling, DealsAPartOfAListWithTheMomentOfAll) {
  const std::vector<double> alike(5000, 1.0);
  const auto measured = sample_orientations(full_tensor(), alike, OrientationDistribution::subclusters, 1);
  for (const std::size_t count : {100u, 1000u, 7001u}) {
    const std::vector<double> weights = random_weights(count);
    const auto dealt = deal_orientations(measured, weights, 3);
    EXPECT_LT(error(dealt, weights, second_moment(measured, alike)), 1e-12);
    // Turned by some tenth of a radian at most, a few hundredths in the mean: still measured directions.
    double turned = 0;
    for (const Vec3& p : dealt) {
      double nearest = 0;
      for (const Vec3& q : measured) nearest = std::max(nearest, std::abs(p.dot(q)));
      turned = std::max(turned, std::acos(std::min(nearest, 1.0)));
    }
    EXPECT_LT(turned, 0.15);
  }
}

// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], by Newton's method on the recurrence.
struct GaussLegendre {
  explicit GaussLegendre(int count) {
    for (int i = 0; i < count; ++i) {
      double x = std::cos(pi * (i + 0.75) / (count + 0.5)), slope = 1;
      for (int newton = 0; newton < 20; ++newton) {
        double now = 1, before = 0;
        for (int n = 1; n <= count; ++n) {
          const double next = ((2 * n - 1) * x * now - (n - 1) * before) / n;
          before = now;
          now = next;
        }
        slope = count * (x * now - before) / (x * x - 1);
        x -= now / slope;
      }
      nodes.push_back(x);
      weights.push_back(2 / ((1 - x * x) * slope * slope));
    }
  }
  std::vector<double> nodes, weights;
};

// The angular central Gaussian law is psi(p) = (p·B·p)^(-3/2) / 4 pi, det B = 1: its A2 picks B, and its A4
// is the integral of p p p p psi, here by Gauss-Legendre quadrature over z and equal steps of the azimuth.
TEST(OrientationSampling, DrawnFibersHaveTheFourthMomentOfTheLaw) {
  const GaussLegendre gauss(200);
  constexpr int azimuths = 400;
  for (const Vec3& values :
       {Vec3(0.6, 0.3, 0.1), Vec3(1. / 3, 1. / 3, 1. / 3), Vec3(0.8, 0.15, 0.05), Vec3(0.48, 0.48, 0.04)}) {
    double shape[3];
    ASSERT_TRUE(find_exact_shape(values.data(), shape));
    const Vec3 b(shape[0], shape[1], shape[2]);
    Mat6 law = Mat6::Zero();
    Mat3 second = Mat3::Zero();
    for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
      for (int k = 0; k < azimuths; ++k) {
        const double z = gauss.nodes[i], r = std::sqrt(1 - z * z), angle = 2 * pi * k / azimuths;
        const Vec3 p(r * std::cos(angle), r * std::sin(angle), z);
        const double psi = std::pow(p.dot(b.cwiseProduct(p)), -1.5) / (4 * pi);
        const double share = psi * gauss.weights[i] * 2 * pi / azimuths;
        law += share * fourth_power(p);
        second += share * p * p.transpose();
      }
    }
    ASSERT_LT((second - Mat3(values.asDiagonal())).cwiseAbs().maxCoeff(), 1e-6);
    for (const std::size_t count : {1000u, 20000u}) {
      const std::vector<double> weights(count, 1.0);
      const auto p = sample_orientations(values.asDiagonal(), weights,
                                         OrientationDistribution::angular_central_gaussian, 4);
      Mat6 drawn = Mat6::Zero();
      for (const Vec3& one : p) drawn += fourth_power(one) / static_cast<double>(count);
      // Points of a Fibonacci sphere integrate smooth functions to about 1 / count.
      EXPECT_LT((drawn - law).cwiseAbs().maxCoeff(), 2 / static_cast<double>(count)) << values.transpose();
    }
  }
}

TEST(OrientationSampling, RefusesWhatNoFibersHave) {
  EXPECT_EQ(refusal(Mat3::Identity() / 3), "accepted");
  EXPECT_EQ(refusal(diagonal(0.6, 0.5, 0.1)),
            "the trace of the orientation tensor is 1.2, not 1: the nearest possible tensor is [0.5333, "
            "0.4333, 0.03333]");
  EXPECT_EQ(refusal(diagonal(0.8, 0.3, -0.1)),
            "the orientation tensor has the eigenvalue -0.1, and no fibers have a negative one: "
            "the nearest possible tensor is [0.75, 0.25, 0]");
  Mat3 skewed = Mat3::Identity() / 3;
  skewed(0, 1) = 0.1;
  EXPECT_EQ(refusal(skewed), "the orientation tensor is not symmetric: make a_ij equal to a_ji");
}

}  // namespace
}  // namespace fiberfate
