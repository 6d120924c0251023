// Walks along the profile of the likelihood.
#include "calibration/profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>

#include "calibration/student.hpp"
#include "calibration/weighted_residuals.hpp"

namespace fiberfate {
namespace {

constexpr int most_doublings = 24;
constexpr int most_bisections = 40;
constexpr double end_tolerance = 1e-4;
constexpr int drawn_points = 6;  // on each side of the best fit

class ProfileWalk {
 public:
  ProfileWalk(const WeightedResiduals& residuals, std::size_t coordinate, std::vector<double> best,
              double limit, int most_iterations)
      : residuals_(residuals),
        coordinate_(coordinate),
        best_(std::move(best)),
        limit_(limit),
        most_iterations_(most_iterations) {}

  /// Computes the least chi^2 with the coordinate held, starting from where its neighbour ended.
  double at(double held) {
    const auto known = chi_squares_.find(held);
    if (known != chi_squares_.end()) return known->second;
    const LeastSquares problem = residuals_.pose_without(coordinate_, held, most_iterations_);
    double chi_square = 0;
    if (others_.empty()) {
      std::vector<double> residuals(problem.residual_count);
      const bool possible = problem.residuals({}, residuals);
      for (const double residual : residuals) chi_square += residual * residual;
      if (!possible) chi_square = std::numeric_limits<double>::infinity();
    } else {
      const LeastSquaresMinimum minimum = minimise(problem, others_);
      chi_square = minimum.sum_of_squares;
      if (std::isfinite(chi_square)) others_ = minimum.position;
    }
    chi_squares_[held] = chi_square;
    return chi_square;
  }

  /// Walks from the best fit until the profile passes the limit, and returns where it does.
  double end(double first_step, double bound) {
    begin_at_best();
    const double start = best_[coordinate_];
    double inside = start, step = first_step;
    for (int i = 0; i < most_doublings; ++i, step *= 1.6) {
      const double outside = step > 0 ? std::min(inside + step, bound) : std::max(inside + step, bound);
      if (at(outside) >= limit_) return crossing(inside, outside, std::abs(outside - start));
      if (outside == bound) return bound;
      inside = outside;
    }
    return step > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  }

  /// Computes points between the best fit and an end, so that the profile can be drawn as a curve.
  void fill(double end) {
    if (!std::isfinite(end)) return;
    begin_at_best();
    const double start = best_[coordinate_];
    for (int i = 0; i < drawn_points; ++i) at(std::lerp(start, end, static_cast<double>(i) / drawn_points));
  }

  [[nodiscard]] const std::map<double, double>& chi_squares() const { return chi_squares_; }

 private:
  void begin_at_best() {
    others_ = best_;
    others_.erase(others_.begin() + static_cast<std::ptrdiff_t>(coordinate_));
  }

  double crossing(double inside, double outside, double width) {
    // Where the fit is exact, chi^2 is round-off and the bracket cannot shrink below that of its ends.
    for (int i = 0; i < most_bisections && std::abs(outside - inside) > end_tolerance * width; ++i) {
      const double below = at(inside) - limit_, above = at(outside) - limit_;
      const double secant =
          std::isfinite(above) ? inside - below * (outside - inside) / (above - below) : inside;
      // Alternating with bisection shrinks the bracket from both ends even where the profile bends strongly.
      const double share = std::clamp((secant - inside) / (outside - inside), 0.05, 0.95);
      const double middle = inside + share * (outside - inside);
      (at(middle) < limit_ ? inside : outside) = middle;
      const double centre = 0.5 * (inside + outside);
      if (std::abs(outside - inside) > end_tolerance * width)
        (at(centre) < limit_ ? inside : outside) = centre;
    }
    return 0.5 * (inside + outside);
  }

  const WeightedResiduals& residuals_;
  std::size_t coordinate_;
  std::vector<double> best_;
  double limit_;
  int most_iterations_;
  std::vector<double> others_;
  std::map<double, double> chi_squares_;
};

std::size_t coordinate_of(const FitCoordinates& coordinates, std::size_t parameter) {
  std::size_t coordinate = 0;
  while (coordinate < coordinates.size() && coordinates.parameter(coordinate) != parameter) ++coordinate;
  assert(coordinate < coordinates.size());
  return coordinate;
}

}  // namespace

Profile profile(const FitProblem& problem, const FitResult& fit, std::size_t parameter,
                const FitOptions& options) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double freedom =
      problem.noise == NoiseScale::known ? infinity : static_cast<double>(fit.degrees_of_freedom);
  const double t = student_quantile(options.level, freedom);
  Profile result;
  result.limit = fit.chi_square + fit.noise_scale * fit.noise_scale * t * t;
  if (!std::isfinite(result.limit)) {
    result.interval = {std::nan(""), std::nan("")};
    return result;
  }
  const WeightedResiduals residuals(problem, fit.values);
  const FitCoordinates& coordinates = residuals.coordinates();
  const std::size_t i = coordinate_of(coordinates, parameter);
  const std::vector<double> best = coordinates.positions(fit.values);
  const double variance = fit.position_covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
  const double step = variance > 0 ? t * std::sqrt(variance) : 0.1;
  ProfileWalk walk(residuals, i, best, result.limit, options.most_iterations);
  const double lower = walk.end(-step, coordinates.lower()[i]);
  const double upper = walk.end(step, coordinates.upper()[i]);
  result.interval = {coordinates.to_value(i, lower), coordinates.to_value(i, upper)};
  walk.fill(lower);
  walk.fill(upper);
  for (const auto& [position, chi_square] : walk.chi_squares()) {
    result.values.push_back(coordinates.to_value(i, position));
    result.chi_squares.push_back(chi_square);
  }
  return result;
}

}  // namespace fiberfate
