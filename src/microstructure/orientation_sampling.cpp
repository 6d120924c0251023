// Draws fiber directions whose second moment is a given orientation tensor.
#include "microstructure/orientation_sampling.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/random.hpp"
#include "microstructure/admissibility.hpp"

namespace fiberfate {
namespace {

// Eigenvalues below this count as zero: no fiber has a component along that axis.
constexpr double planar_limit = 1e-9;
constexpr double golden_angle = 2.39996322972865332;  // pi (3 − sqrt 5)

// Rows of random counters, so that the uses of the orientation stream stay independent.
enum Draw : std::uint32_t { rotation_draw = 0, deal_draw = 1, sign_draw = 2, cluster_draw = 3 };

/// Diagonalises a symmetric tensor with the largest eigenvalue first.
struct PrincipalAxes {
  explicit PrincipalAxes(const Mat3& tensor) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(0.5 * (tensor + tensor.transpose()));
    values = solver.eigenvalues().reverse();
    axes = solver.eigenvectors().rowwise().reverse();
  }
  Vec3 values;  ///< falling
  Mat3 axes;    ///< columns
};

/// Points spread evenly over a half sphere (axes have no sign).
std::vector<Vec3> fibonacci_half_sphere(std::size_t count) {
  std::vector<Vec3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double radius = std::sqrt(1 - z * z);
    const double azimuth = golden_angle * static_cast<double>(i);
    points[i] = {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
  }
  return points;
}

Mat3 random_rotation(std::uint64_t seed, std::uint32_t which) {
  const auto u = uniform4(seed, RandomStream::orientation, {0, rotation_draw, which});
  const double a = std::sqrt(1 - u[0]);
  const double b = std::sqrt(u[0]);
  const Eigen::Quaterniond turn(a * std::sin(2 * pi * u[1]), a * std::cos(2 * pi * u[1]),
                                b * std::sin(2 * pi * u[2]), b * std::cos(2 * pi * u[2]));
  return turn.toRotationMatrix();
}

template <class Item>
void shuffle(std::vector<Item>& items, std::uint64_t seed, Draw draw) {
  for (std::size_t i = items.size(); i > 1; --i) {
    const double u = uniform(seed, RandomStream::orientation, {static_cast<std::uint32_t>(i), draw, 0});
    std::swap(items[i - 1], items[static_cast<std::size_t>(u * static_cast<double>(i))]);
  }
}

/// Isotropic axes mapped by p = B u / |B u| in the principal frame. B = diag(a) is exact in the plane and
/// near in space.
std::vector<Vec3> map_to_ellipsoid(const Vec3& values, std::size_t count, std::uint64_t seed) {
  std::vector<Vec3> directions = fibonacci_half_sphere(count);
  const Mat3 turn = random_rotation(seed, 0);
  for (Vec3& p : directions) {
    p = values.cwiseProduct(turn * p);
    p = p.norm() > 0 ? Vec3(p.normalized()) : Vec3::UnitX();
  }
  shuffle(directions, seed, deal_draw);
  return directions;
}

/// Mixture of 3D-random, planar-random and aligned fibers in the principal frame with the shares
/// 3 a3, 2 (a2 − a3) and a1 − a2 of the total weight (thesis 3.28, 3.29).
std::vector<Vec3> mix_subclusters(const Vec3& values, std::span<const double> weights, std::uint64_t seed) {
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, seed, cluster_draw);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<std::size_t> in_space, in_plane;
  std::vector<Vec3> directions(weights.size(), Vec3::UnitX());
  double reached = 0;
  for (const std::size_t i : order) {
    const double place = (reached + 0.5 * weights[i]) / total;
    reached += weights[i];
    if (place < 3 * values[2]) {
      in_space.push_back(i);
    } else if (place < 3 * values[2] + 2 * (values[1] - values[2])) {
      in_plane.push_back(i);
    }
  }
  const std::vector<Vec3> sphere = fibonacci_half_sphere(in_space.size());
  const Mat3 turn = random_rotation(seed, 1);
  for (std::size_t k = 0; k < in_space.size(); ++k) directions[in_space[k]] = turn * sphere[k];
  const double start = uniform(seed, RandomStream::orientation, {1, cluster_draw, 1});
  for (std::size_t k = 0; k < in_plane.size(); ++k) {
    const double angle = pi * (static_cast<double>(k) + start) / static_cast<double>(in_plane.size());
    directions[in_plane[k]] = {std::cos(angle), std::sin(angle), 0};
  }
  return directions;
}

/// Power of a positive semi-definite tensor; axes with an eigenvalue of zero stay zero.
Mat3 semidefinite_power(const Mat3& tensor, double exponent) {
  const PrincipalAxes principal(tensor);
  Vec3 powers = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (principal.values[i] > planar_limit) powers[i] = std::pow(principal.values[i], exponent);
  }
  return principal.axes * powers.asDiagonal() * principal.axes.transpose();
}

/// Maps all directions by p ← M p / |M p|, M = A*^½ A^−½, until their moment A is A*; keeps the last step
/// that helped. The composed map is again of the form B u / |B u|. Few fibers (fewer than six, say) need not
/// have a solution.
void fit_second_moment(std::vector<Vec3>& directions, std::span<const double> weights, const Mat3& target) {
  constexpr int most_iterations = 500;
  constexpr double good_enough = 1e-13;
  const Mat3 root = semidefinite_power(target, 0.5);
  Mat3 moment = second_moment(directions, weights);
  double error = (moment - target).cwiseAbs().maxCoeff();
  std::vector<Vec3> trial(directions.size());
  for (int iteration = 0; iteration < most_iterations && error > good_enough; ++iteration) {
    const Mat3 map = root * semidefinite_power(moment, -0.5);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec3 mapped = map * directions[i];
      const double length = mapped.norm();
      trial[i] = length > 0 ? Vec3(mapped / length) : directions[i];
    }
    moment = second_moment(trial, weights);
    const double trial_error = (moment - target).cwiseAbs().maxCoeff();
    if (!(trial_error < error)) return;
    error = trial_error;
    directions.swap(trial);
  }
}

}  // namespace

Mat3 second_moment(std::span<const Vec3> directions, std::span<const double> weights) {
  require_same_size("weights", weights.size(), directions.size());
  Mat3 moment = Mat3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    moment += weights[i] * directions[i] * directions[i].transpose();
    total += weights[i];
  }
  return moment / total;
}

std::vector<Vec3> sample_orientations(const Mat3& tensor, std::span<const double> weights,
                                      OrientationDistribution law, std::uint64_t seed) {
  require_admissible(tensor);
  if (weights.empty()) return {};
  require_numbers("weights", weights, positive);
  const PrincipalAxes principal(nearest_admissible(tensor));
  const Vec3 values = principal.values.cwiseMax(0.0);
  std::vector<Vec3> directions = law == OrientationDistribution::subclusters
                                     ? mix_subclusters(values, weights, seed)
                                     : map_to_ellipsoid(values, weights.size(), seed);
  fit_second_moment(directions, weights, values.asDiagonal());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double coin =
        uniform(seed, RandomStream::orientation, {static_cast<std::uint32_t>(i), sign_draw, 0});
    directions[i] = (coin < 0.5 ? -1.0 : 1.0) * (principal.axes * directions[i]).normalized();
  }
  return directions;
}

std::vector<Vec3> deal_orientations(std::span<const Vec3> directions, std::span<const double> weights,
                                    std::uint64_t seed) {
  if (directions.empty()) throw InputError("the list of directions is empty", "give at least one");
  std::vector<Vec3> deck(directions.begin(), directions.end());
  for (Vec3& p : deck) {
    if (!(p.norm() > 0) || !p.allFinite())
      throw InputError("a direction has no length", "give vectors other than zero");
    p.normalize();
  }
  const Mat3 measured = second_moment(deck, std::vector<double>(deck.size(), 1.0));
  shuffle(deck, seed, cluster_draw);
  require_numbers("weights", weights, positive);
  std::vector<Vec3> dealt(weights.size());
  for (std::size_t i = 0; i < dealt.size(); ++i) dealt[i] = deck[i % deck.size()];
  shuffle(dealt, seed, deal_draw);
  fit_second_moment(dealt, weights, measured);
  return dealt;
}

}  // namespace fiberfate
