// What the study attrition measures at every output time: the columns of series.csv and the charts of the
// report.
#pragma once

#include <vector>

#include "continuum/length_prediction.hpp"
#include "results/observable.hpp"
#include "studies/attrition/case.hpp"

namespace fiberfate {

/// A moment of fibers that break.
struct LengthMoment {
  double time = 0;  ///< s
  MeltState melt;
  double viscosity = 0;           ///< Pa s
  double unbreakable_length = 0;  ///< m
  MeanLengths means;
};

/// The rows of series.csv; a new observable is one more row.
[[nodiscard]] const Observables<LengthMoment>& length_observables();
/// Those among them that series.csv has of a second law too: compared_ stands before their names.
[[nodiscard]] Observables<LengthMoment> compared_observables(const AttritionCase& values);
[[nodiscard]] const std::vector<Chart>& length_charts();

}  // namespace fiberfate
