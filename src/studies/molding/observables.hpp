// What the study molding measures: while the mold fills, of the whole, at named places, through the gap.
#pragma once

#include <vector>

#include "results/observable.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Where a step began: pressures and rates of the state after it are those that held from there on.
struct FillingMoment {
  const Filling& filling;
  double greatest_pressure = 0;  ///< at the sprue so far, Pa
  double time = 0;               ///< s
  double filled_fraction = 0;    ///< 1
  double injected_volume = 0;    ///< m³
};
[[nodiscard]] FillingMoment moment_of(const Filling& filling, double greatest);

/// The rows of series.csv.
[[nodiscard]] Observables<FillingMoment> filling_observables(const std::vector<Gate>& gates);
[[nodiscard]] const std::vector<Chart>& filling_charts();
/// What summary.json tells of the whole part.
[[nodiscard]] const Observables<FillingMoment>& part_observables();

/// A sample of the part at a named place, followed by one set of length laws.
struct PlaceSample {
  std::size_t place = 0, set = 0;
  double value = 0;            ///< of the sweep; NaN without
  double fill_time = 0;        ///< s
  double temperature = 0;      ///< K
  MeanLengths means = {};      ///< those that measurements are compared with
  MeanLengths of_sample = {};  ///< of all fibers of the sample
  MeanLengths of_gap = {};     ///< means over the gap
};
/// The rows of places.csv. A summary has those that it may, each after the name of its place; of compared
/// lengths no others.
[[nodiscard]] const Observables<PlaceSample>& place_observables();

/// A layer over a node.
struct GapPoint {
  const MoldingFields& fields;
  std::size_t node = 0, layer = 0;
  double viscosity = 0;   ///< Pa s
  std::size_t place = 0;  ///< whose nearest node it is
};
/// What is known there: a column of profiles.csv, NaN where a filling does not follow it, and an array of
/// layers.vtkhdf where it has a name in it.
struct GapField {
  Observable<GapPoint> profile;
  std::string array = {};
  enum class Of { melt, orientation, lengths } of = Of::melt;
};
[[nodiscard]] bool follows(const MoldingFields& fields, GapField::Of of);
[[nodiscard]] const std::vector<GapField>& gap_fields();
/// The rows of profiles.csv.
[[nodiscard]] const Observables<GapPoint>& profile_observables();
[[nodiscard]] const std::vector<Chart>& profile_charts();

}  // namespace fiberfate
