// Walks along the profile of the likelihood.
#include "calibration/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "calibration/profile_walk.hpp"
#include "calibration/student.hpp"

namespace fiberfate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_doublings = 24;
constexpr int most_bisections = 40;
constexpr double end_tolerance = 1e-4;
constexpr int drawn_points = 6;  // on each side of the best fit
/// Places beyond an end, in its distances from the best fit, at which values might be as likely again.
constexpr double places_beyond[] = {1.5, 2, 3};
constexpr int most_parts = 4;
/// Better fits that are followed, one after another.
constexpr int most_better_fits = 3;
/// Share of s^2 t^2 by which a point must come below the fit to be a better one.
constexpr double distinct = 1e-3;

/// Sums of squares up to this one are round-off: residuals of 1e-12 of the values.
double round_off(const FitProblem& problem) {
  constexpr double share = 1e-12;
  double sum = 0;
  for (const FitSeries& series : problem.series)
    for (std::size_t i = 0; i < series.observed.size(); ++i)
      sum += std::pow(share * series.observed[i] / series.uncertainty[i], 2);
  return sum;
}

/// Finds where a profile passes a limit.
class EndSearch {
 public:
  EndSearch(ProfileWalk& walk, double limit) : walk_(walk), limit_(limit) {}

  /// Walks from the best fit until the profile passes the limit, and returns where it does.
  double end(double first_step, double bound) {
    walk_.begin_at_best();
    double inside = walk_.start(), step = first_step;
    for (int i = 0; i < most_doublings; ++i, step *= 1.6) {
      const double outside = step > 0 ? std::min(inside + step, bound) : std::max(inside + step, bound);
      if (walk_.at(outside) >= limit_ && walk_.explore(outside) >= limit_) return crossing(inside, outside);
      if (outside == bound) return bound;
      inside = outside;
    }
    return std::copysign(infinity, step);
  }

  /// Looks beyond an end for values that are as likely; returns the outermost end.
  double outermost(double end, double bound, bool& in_parts) {
    for (int part = 0; part < most_parts && std::isfinite(end) && end != bound; ++part) {
      const double again = likely_beyond(end, bound);
      if (again == end) return end;
      in_parts = true;
      const double step = 0.5 * (again - walk_.start());
      for (end = again; walk_.at(end) < limit_ && end != bound;)
        end = step > 0 ? std::min(end + step, bound) : std::max(end + step, bound);
      if (walk_.at(end) >= limit_) end = crossing(again, end);
    }
    return end;
  }

  /// Computes points between the best fit and an end, so that the profile can be drawn as a curve.
  void fill(double end) {
    if (!std::isfinite(end)) return;
    walk_.begin_at_best();
    const double start = walk_.start();
    for (int i = 0; i < drawn_points; ++i)
      walk_.at(std::lerp(start, end, static_cast<double>(i) / drawn_points));
  }

 private:
  /// The outermost place beyond an end that is as likely as those inside, or the end.
  double likely_beyond(double end, double bound) {
    double likely = end;
    for (const double place : places_beyond) {
      const double far = walk_.start() + place * (end - walk_.start());
      const double held = end > walk_.start() ? std::min(far, bound) : std::max(far, bound);
      if (held != end && walk_.explore(held) < limit_) likely = held;
    }
    return likely;
  }

  double crossing(double inside, double outside) {
    const double width = std::abs(outside - walk_.start());
    // Where the fit is exact, chi^2 is round-off and the bracket cannot shrink below that of its ends.
    for (int i = 0; i < most_bisections && std::abs(outside - inside) > end_tolerance * width; ++i) {
      const double below = walk_.at(inside) - limit_, above = walk_.at(outside) - limit_;
      const double secant =
          std::isfinite(above) ? inside - below * (outside - inside) / (above - below) : inside;
      // Alternating with bisection shrinks the bracket from both ends even where the profile bends strongly.
      const double share = std::clamp((secant - inside) / (outside - inside), 0.05, 0.95);
      const double middle = inside + share * (outside - inside);
      (walk_.at(middle) < limit_ ? inside : outside) = middle;
      const double centre = 0.5 * (inside + outside);
      if (std::abs(outside - inside) > end_tolerance * width)
        (walk_.at(centre) < limit_ ? inside : outside) = centre;
    }
    return 0.5 * (inside + outside);
  }

  ProfileWalk& walk_;
  double limit_;
};

std::size_t coordinate_of(const FitCoordinates& coordinates, std::size_t parameter) {
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    if (coordinates.parameter(i) == parameter) return i;
  throw InputError(fmt::format("parameter {} is not free", parameter), "profile one that was fitted");
}

/// What stays the same while better fits are followed.
struct ProfileTask {
  const FitProblem& problem;
  const WeightedResiduals& residuals;
  std::size_t coordinate;
  double step;  ///< of the walk, in coordinates
  int most_iterations;
};

/// One walk and what it found.
struct Walked {
  Profile profile;
  double best_chi_square = infinity;
  std::vector<double> best;  ///< position of the lowest point
};

/// Finds where the other parameters jump between neighbouring points: a search from the one side then ends
/// higher than what the other side has.
void find_jumps(const ProfileTask& task, const ProfileWalk& walk, Profile& result) {
  const FitCoordinates& coordinates = task.residuals.coordinates();
  const std::string& name = task.problem.parameters[coordinates.parameter(task.coordinate)].name;
  for (auto here = walk.points().begin(); here != walk.points().end(); ++here) {
    const auto next = std::next(here);
    if (next == walk.points().end()) return;
    const auto& [from, low] = *here;
    const auto& [to, high] = *next;
    if (low.others.empty() || !std::isfinite(low.chi_square) || !std::isfinite(high.chi_square)) continue;
    if (!are_distinct(walk.search(to, low.others), high)) continue;
    result.findings.push_back(
        {FindingKind::several_minima,
         fmt::format(
             "the profile of {} jumps between two minima from {:.6g} to {:.6g}: there the other parameters "
             "change at once, and the interval is that of the lower one of them",
             name, coordinates.to_value(task.coordinate, from), coordinates.to_value(task.coordinate, to))});
  }
}

Walked walk_from(const ProfileTask& task, const std::vector<double>& best, double limit) {
  const FitCoordinates& coordinates = task.residuals.coordinates();
  const double lowest = coordinates.lower()[task.coordinate], highest = coordinates.upper()[task.coordinate];
  ProfileWalk walk(task.residuals, task.coordinate, best, task.most_iterations);
  EndSearch search(walk, limit);
  bool in_parts = false;
  double lower = search.end(-task.step, lowest), upper = search.end(task.step, highest);
  lower = search.outermost(lower, lowest, in_parts);
  upper = search.outermost(upper, highest, in_parts);
  search.fill(lower);
  search.fill(upper);
  if (walk.found_several()) walk.settle_branches();
  Walked walked;
  walked.profile.limit = limit;
  walked.profile.interval = {coordinates.to_value(task.coordinate, lower),
                             coordinates.to_value(task.coordinate, upper)};
  for (const auto& [position, point] : walk.points()) {
    walked.profile.values.push_back(coordinates.to_value(task.coordinate, position));
    walked.profile.chi_squares.push_back(point.chi_square);
    if (point.chi_square >= walked.best_chi_square) continue;
    walked.best_chi_square = point.chi_square;
    walked.best = walk.position(position);
  }
  if (walk.found_several()) find_jumps(task, walk, walked.profile);
  if (in_parts)
    walked.profile.findings.push_back(
        {FindingKind::several_minima,
         fmt::format("the interval of {} is in parts: values beyond one of its ends are as likely again",
                     task.problem.parameters[coordinates.parameter(task.coordinate)].name)});
  return walked;
}

}  // namespace

Profile profile(const FitProblem& problem, const FitResult& fit, std::size_t parameter,
                const FitOptions& options) {
  options.check();
  require_same_size("values", fit.values.size(), problem.parameters.size());
  const double freedom =
      problem.noise == NoiseScale::known ? infinity : static_cast<double>(fit.degrees_of_freedom);
  const double t = student_quantile(options.level, freedom);
  const auto limit_of = [&](double chi_square) {
    const double variance = problem.noise == NoiseScale::known ? 1 : chi_square / freedom;
    return chi_square + variance * t * t;
  };
  Profile result;
  result.limit = fit.chi_square + fit.noise_scale * fit.noise_scale * t * t;
  if (!std::isfinite(result.limit)) {
    result.interval = {std::nan(""), std::nan("")};
    return result;
  }
  const WeightedResiduals residuals(problem, fit.values);
  const std::size_t i = coordinate_of(residuals.coordinates(), parameter);
  const double variance = fit.position_covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
  const double step = variance > 0 ? t * std::sqrt(variance) : 0.1;
  const ProfileTask task = {problem, residuals, i, step, options.most_iterations};

  std::vector<double> best = residuals.coordinates().positions(fit.values);
  double chi_square = fit.chi_square, limit = result.limit;
  for (int followed = 0;; ++followed) {
    Walked walked = walk_from(task, best, limit);
    result = std::move(walked.profile);
    const bool better = chi_square > round_off(problem) &&
                        walked.best_chi_square < chi_square - distinct * (limit - chi_square);
    if (!better || followed == most_better_fits) break;
    best = std::move(walked.best);
    chi_square = walked.best_chi_square;
    limit = limit_of(chi_square);
  }
  if (chi_square < fit.chi_square)
    result.findings.push_back(
        {FindingKind::better_fit,
         fmt::format("there is a better fit than the one found, near {} = {:.6g}: chi^2 {:.4g} instead of "
                     "{:.4g}. The "
                     "interval belongs to it; fit again from there, or from more starts",
                     problem.parameters[parameter].name, residuals.coordinates().to_value(i, best[i]),
                     chi_square, fit.chi_square)});
  return result;
}

}  // namespace fiberfate
