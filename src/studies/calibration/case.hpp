// A case of the study calibration: a law, the conditions of experiments, and what was measured in them.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "calibration/fit_problem.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"
#include "keys/law_choice.hpp"
#include "studies/flow_choices.hpp"
#include "studies/length_choices.hpp"
#include "studies/molding/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// [conditions]: lists with one entry a condition, or one for all.
struct CalibrationConditions {
  std::vector<std::string> names;
  std::vector<double> rates;   ///< 1/s
  std::vector<double> speeds;  ///< revolutions per minute, instead of rates
  CouetteRheometer couette = thesis_rheometer;
  std::vector<double> viscosities;                 ///< Pa s, instead of [melt]
  std::vector<double> temperatures;                ///< K, for [melt]
  std::vector<double> pressures;                   ///< Pa, for [melt]
  std::vector<double> lengths;                     ///< at the start, m
  std::vector<std::vector<std::string>> moldings;  ///< rows (case file of the study molding, change, …)
  std::vector<double> compressions;
  std::vector<std::string> flows;  ///< shear, planar, uniaxial, biaxial; for orientation
  ShearGradient shear_gradient = ShearGradient::y;
  Mat3 orientation = Mat3::Identity() / 3;  ///< A2 at the start
};

/// Whether conditions share their parameters.
enum class FitScope { together, separately };

/// What was measured of one mean length at one place of a molded part.
struct MoldedLengths {
  std::string condition, place;
  LengthMean mean = LengthMean::number_average;
  std::vector<double> samples;  ///< m
};

/// [data].
struct CalibrationData {
  std::vector<std::vector<std::string>> series;  ///< rows (condition, quantity, file or value[, time])
  std::vector<MoldedLengths> lengths;
  double relative_uncertainty = 0.02;  ///< of lengths and rate constants
  double absolute_uncertainty = 0.02;  ///< of components of A2 and of shares in histograms
  NoiseScale noise = NoiseScale::estimated;
};

/// Whether intervals are found by profiles, too.
enum class ProfileChoice { all, none };

/// [fit].
struct CalibrationSearch {
  std::vector<std::string> free;
  std::vector<std::string> linear;               ///< free parameters searched by value, not logarithm
  std::vector<std::vector<std::string>> bounds;  ///< rows (parameter, lower, upper)
  FitScope scope = FitScope::together;
  std::int64_t starts = 1;
  double level = 0.95;
  ProfileChoice profiles = ProfileChoice::all;
  std::int64_t bootstrap = 0;  ///< samples
  std::int64_t seed = 1;
};

/// [sweep]; no parameter: none.
struct CalibrationSweep {
  std::string parameter;
  std::optional<double> lower, upper;  ///< in the SI unit of the parameter
  std::int64_t count = 50;
  ParameterScale spacing = ParameterScale::logarithmic;
};

struct CalibrationCase {
  LawChoice law;          ///< attrition
  LawChoice orientation;  ///< or orientation
  std::string closure = "ibof";
  LawChoice melt = {"newtonian", {}};
  LengthChoices fibers;  ///< lengths at the start of every condition, and how they are followed
  CalibrationConditions conditions;
  CalibrationData data;
  CalibrationSearch search;
  CalibrationSweep sweep;
};

void describe_calibration(KeyTable& table, CalibrationCase& values);
/// The keys that are about molded parts: conditions.moldings and data.lengths.
[[nodiscard]] KeyRow<CalibrationConditions> moldings_key();
[[nodiscard]] KeyRow<CalibrationData> molded_lengths_key();
/// Checks what belongs to calibration in molds only.
void validate_moldings(const CalibrationCase& values, CaseChecker& checker);
/// Adds to an estimate what its moldings need.
[[nodiscard]] CaseEstimate molded_estimate(const CalibrationCase& values, CaseEstimate estimate);
void validate_calibration(const CalibrationCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_calibration(const CalibrationCase& values);

/// Whether the case calibrates an orientation law.
[[nodiscard]] inline bool calibrates_orientation(const CalibrationCase& values) {
  return !values.orientation.name.empty();
}
/// Whether the conditions are moldings: parts that fill.
[[nodiscard]] inline bool calibrates_in_molds(const CalibrationCase& values) {
  return !values.conditions.moldings.empty();
}
/// The entry of a list of [conditions] for one condition: its own, or the one for all; the standard where
/// the list is not given.
template <class Entry>
[[nodiscard]] Entry entry(const std::vector<Entry>& list, std::size_t condition,
                          const std::type_identity_t<Entry>& standard = {}) {
  if (list.empty()) return standard;
  return list.size() == 1 ? list[0] : list[condition];
}
/// Gives the menu and the choice of the law that the case calibrates.
[[nodiscard]] const LawMenu& calibrated_menu(const CalibrationCase& values);
[[nodiscard]] const LawChoice& calibrated_law(const CalibrationCase& values);

}  // namespace fiberfate
