// What the study orientation measures at every output time: the columns of series.csv and the charts of the
// report.
#pragma once

#include <vector>

#include "results/observable.hpp"
#include "studies/orientation/stress.hpp"

namespace fiberfate {

/// A moment of fibers that turn.
struct OrientationMoment {
  double time = 0, strain = 0, rate = 0;  ///< s, 1, 1/s
  Mat3 second = Mat3::Zero();             ///< A2
  Vec3 principal = Vec3::Zero();          ///< its values, falling
  double stretching_share = 0;            ///< D:A4:D/D:D
  Mat3 exact = Mat3::Zero();              ///< A2 without closure, where the case asks for it
  MeltStress stress = {};                 ///< where the case has a melt
};

/// The rows of series.csv; a new observable is one more row.
[[nodiscard]] Observables<OrientationMoment> orientation_observables(const OrientationCase& values);
[[nodiscard]] const std::vector<Chart>& orientation_charts();

}  // namespace fiberfate
