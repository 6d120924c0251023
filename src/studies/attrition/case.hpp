// A case of the study attrition: fiber lengths in a history of flow and temperature.
#pragma once

#include <optional>
#include <vector>

#include "continuum/length_prediction.hpp"
#include "keys/case_checker.hpp"
#include "keys/law_choice.hpp"
#include "studies/flow_choices.hpp"
#include "studies/length_choices.hpp"
#include "studies/run_choices.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// What the flow is.
enum class AttritionFlow { constant, couette, table };

/// [flow].
struct AttritionFlowChoices {
  AttritionFlow kind = AttritionFlow::constant;
  std::optional<double> rate;   ///< 1/s
  std::optional<double> speed;  ///< revolutions per minute, of kind couette
  CouetteRheometer couette = thesis_rheometer;
  double temperature = 523.15;  ///< K
  double pressure = 0;          ///< Pa
  HistoryForm form = HistoryForm::ramps;
  std::vector<std::vector<double>> table;  ///< rows (time s, rate 1/s, temperature K, pressure Pa)
  double compression = 1;
};

/// [output].
struct AttritionOutputChoices : SeriesChoices {
  std::vector<double> histogram_times;  ///< s; empty: start and end
  std::int64_t histogram_bins = 30;
};

struct AttritionCase {
  LawChoice law;
  LawChoice compared;  ///< a second law on the same fibers; no name: none
  LawChoice melt = {"newtonian", {}};
  AttritionFlowChoices flow;
  LengthChoices fibers;
  AttritionOutputChoices output;
  RunChoices run;  ///< duration
};

void describe_attrition(KeyTable& table, AttritionCase& values);
void validate_attrition(const AttritionCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_attrition(const AttritionCase& values);

/// Makes what a valid case asks for.
[[nodiscard]] FlowHistory flow_history(const AttritionFlowChoices& flow);
/// The times of series.csv, those of the histograms among them, s.
[[nodiscard]] std::vector<double> output_times(const AttritionCase& values);

}  // namespace fiberfate
