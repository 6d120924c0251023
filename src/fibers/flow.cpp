// Follows the flow over time.
#include "fibers/flow.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace fiberfate {

Flow simple_shear(double rate, double viscosity) {
  Flow flow;
  flow.gradient(0, 1) = rate;
  flow.viscosity = viscosity;
  return flow;
}

double principal_rate(const Flow& flow) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(flow.rate_of_strain(), Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

FlowHistory::FlowHistory(std::vector<FlowInterval> intervals) : intervals_(std::move(intervals)) {
  if (intervals_.empty()) throw InputError("a flow history has no intervals", "give at least one");
  double before = 0;
  for (const FlowInterval& interval : intervals_) {
    if (!(interval.end_time > before))
      throw InputError("the end times of a flow history do not increase", "sort the rows by end time");
    if (!std::isfinite(interval.rate))
      throw InputError("a flow history has a rate that is not finite", "give the shear rate in 1/s");
    if (!(interval.viscosity > 0) || std::isinf(interval.viscosity))
      throw InputError("a flow history has a viscosity that is not positive",
                       "give the matrix viscosity in Pa s");
    before = interval.end_time;
  }
}

FlowHistory FlowHistory::constant(double rate, double viscosity) {
  return FlowHistory({{std::numeric_limits<double>::infinity(), rate, viscosity}});
}

FlowHistory FlowHistory::ramp(double rate, double viscosity, double duration, int steps) {
  std::vector<FlowInterval> intervals;
  for (int i = 1; i <= steps; ++i) intervals.push_back({duration * i / steps, rate * i / steps, viscosity});
  intervals.push_back({std::numeric_limits<double>::infinity(), rate, viscosity});
  return FlowHistory(std::move(intervals));
}

std::size_t FlowHistory::interval_at(double time) const {
  const auto found = std::upper_bound(intervals_.begin(), intervals_.end(), time,
                                      [](double t, const FlowInterval& row) { return t < row.end_time; });
  return std::min(static_cast<std::size_t>(found - intervals_.begin()), intervals_.size() - 1);
}

Flow FlowHistory::at(double time) const {
  const FlowInterval& interval = intervals_[interval_at(time)];
  return simple_shear(interval.rate, interval.viscosity);
}

double FlowHistory::next_change(double time) const {
  const std::size_t i = interval_at(time);
  if (i + 1 == intervals_.size()) return std::numeric_limits<double>::infinity();
  return intervals_[i].end_time;
}

}  // namespace fiberfate
