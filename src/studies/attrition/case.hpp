// Holds a case of the study attrition: fiber lengths in a history of flow and temperature.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continuum/attrition_law.hpp"
#include "continuum/couette_rheometer.hpp"
#include "continuum/length_history.hpp"
#include "continuum/viscosity.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_table.hpp"
#include "keys/law_choice.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Names what the flow is.
enum class AttritionFlow { constant, couette, table };

/// Holds [flow].
struct AttritionFlowChoices {
  AttritionFlow kind = AttritionFlow::constant;
  std::optional<double> rate;                 ///< 1/s
  std::optional<double> speed;                ///< revolutions per minute, of kind couette
  CouetteRheometer couette = {0.021, 0.027};  ///< R_i = 3.5 (R_o - R_i), which gives the thesis' rates
  double temperature = 523.15;                ///< K
  double pressure = 0;                        ///< Pa
  HistoryForm form = HistoryForm::ramps;
  std::vector<std::vector<double>> table;  ///< rows (time s, rate 1/s, temperature K, pressure Pa)
  double compression = 1;
};

/// Holds [fibers]: the lengths at the start and how they are followed.
struct AttritionFiberChoices {
  std::optional<double> length;
  std::vector<std::vector<double>> distribution;  ///< rows (length m, number)
  std::optional<double> number_average;           ///< L_N, m
  std::optional<double> weight_average;           ///< L_W, m
  LengthForm form = LengthForm::distribution;
  ClassWeight weight = ClassWeight::length;
  std::int64_t bins = 100;
  std::optional<double> largest_length;  ///< of the bins, m
};

/// Holds [output].
struct AttritionOutputChoices {
  std::optional<double> interval;       ///< s; not given: duration/200
  std::vector<double> histogram_times;  ///< s; empty: start and end
  std::int64_t histogram_bins = 30;
};

struct AttritionCase {
  LawChoice law;
  LawChoice compared;  ///< a second law on the same fibers; no name: none
  LawChoice melt = {"newtonian", {}};
  AttritionFlowChoices flow;
  AttritionFiberChoices fibers;
  AttritionOutputChoices output;
  double duration = 0;  ///< s
};

void describe_attrition(KeyTable& table, AttritionCase& values);
void validate_attrition(const AttritionCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_attrition(const AttritionCase& values);

/// Adds the keys of [flow] that describe a Couette rheometer, and of [fibers] and their bins; calibration has
/// them too.
void describe_couette(KeyTable& table, const std::string& section, CouetteRheometer& couette);
void describe_initial_distribution(KeyTable& table, const std::string& section,
                                   AttritionFiberChoices& fibers);
void describe_length_form(KeyTable& table, const std::string& section, AttritionFiberChoices& fibers);

/// Finds what is wrong where mean lengths are given; calibration asks too.
void validate_mean_lengths(const AttritionFiberChoices& fibers, CaseChecker& checker);

/// Makes what a valid case asks for.
[[nodiscard]] LengthHistory length_history(const AttritionFlowChoices& flow);
[[nodiscard]] LengthStart length_start(const AttritionFiberChoices& fibers);
/// Tells the times of series.csv, s: multiples of the interval, and the end.
[[nodiscard]] std::vector<double> output_times(const AttritionCase& values);

}  // namespace fiberfate
