// The least chi^2 over one held coordinate, on whichever branch of minima is lowest.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "calibration/weighted_residuals.hpp"

namespace fiberfate {

/// The least chi^2 found with the coordinate held, and where the other coordinates are then.
struct ProfilePoint {
  double chi_square = 0;
  std::vector<double> others;
};

/// Whether two searches at one value ended in different minima: chi^2 and positions both differ by more
/// than a search's precision.
[[nodiscard]] bool are_distinct(const ProfilePoint& one, const ProfilePoint& other);

/// Computes points of a profile. At every one the other coordinates are searched from where the neighbour's
/// ended, from the best fit, where asked from drawn places (explore) and from the neighbours on both sides
/// (settle_branches), and the lowest minimum counts: a search that only follows its neighbour stays in a
/// minimum that has ceased to be the lowest.
class ProfileWalk {
 public:
  /// Refers to the residuals, which must live longer. `best` is the position of the fit.
  ProfileWalk(const WeightedResiduals& residuals, std::size_t coordinate, std::vector<double> best,
              int most_iterations);

  /// Computes the least chi^2 with the coordinate held.
  double at(double held);
  /// Searches a point again from drawn places, anywhere between the bounds: minima that neither the
  /// neighbours nor the best fit lead to. Returns the least chi^2 found.
  double explore(double held);
  /// Begins again next to the best fit.
  void begin_at_best();
  /// Whether searches from different places have ended in different minima anywhere.
  [[nodiscard]] bool found_several() const { return found_several_; }
  /// Searches every point again from its neighbours' minima until none finds a lower one.
  void settle_branches();

  [[nodiscard]] const std::map<double, ProfilePoint>& points() const { return points_; }
  [[nodiscard]] double start() const { return best_[coordinate_]; }
  /// Gives the full position of a point.
  [[nodiscard]] std::vector<double> position(double held) const;
  /// The minimum that a search from `others` ends in, with the coordinate held.
  [[nodiscard]] ProfilePoint search(double held, const std::vector<double>& others) const;

 private:
  bool improve(double held, const std::vector<double>& others);

  const WeightedResiduals& residuals_;
  std::size_t coordinate_;
  std::vector<double> best_;
  int most_iterations_;
  std::vector<double> best_others_, neighbour_;
  std::map<double, ProfilePoint> points_;
  bool found_several_ = false;
};

}  // namespace fiberfate
