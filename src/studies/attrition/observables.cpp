// What the study attrition measures at every output time.
#include "studies/attrition/observables.hpp"

namespace fiberfate {

const Observables<LengthMoment>& length_observables() {
  using Moment = LengthMoment;
  constexpr InSummary number = InSummary::as_number;
  static const Observables<Moment> all = {
      {"time_s", "s", "", "", [](const Moment& m) { return m.time; }},
      {"L_N_m", "m", "L_N", "mean_lengths", [](const Moment& m) { return m.means.number_average; }},
      {"L_W_m", "m", "L_W", "mean_lengths", [](const Moment& m) { return m.means.weight_average; }},
      {"rate_per_s", "1/s", "", "", [](const Moment& m) { return m.melt.rate; }, number},
      {"temperature_K", "K", "", "", [](const Moment& m) { return m.melt.temperature; }},
      {"viscosity_Pa_s", "Pa s", "", "", [](const Moment& m) { return m.viscosity; }, number},
      {"shear_stress_Pa", "Pa", "stress", "stress", [](const Moment& m) { return m.viscosity * m.melt.rate; },
       number},
      {"unbreakable_length_m", "m", "unbreakable", "mean_lengths",
       [](const Moment& m) { return m.unbreakable_length; }, InSummary::no, CurveStyle::dashed},
  };
  return all;
}

Observables<LengthMoment> compared_observables(const AttritionCase& values) {
  Observables<LengthMoment> compared;
  if (values.compared.name.empty()) return compared;
  for (Observable<LengthMoment> one : length_observables()) {
    if (one.group != "mean_lengths") continue;
    if (one.style == CurveStyle::dashed) one.group.clear();  // one unbreakable length in the chart is enough
    one.column = "compared_" + one.column;
    one.label += ", " + values.compared.name;
    one.style = CurveStyle::dashed;
    compared.push_back(std::move(one));
  }
  return compared;
}

const std::vector<Chart>& length_charts() {
  static const std::vector<Chart> charts = {{"mean_lengths", "Mean fiber lengths", "length"},
                                            {"stress", "Shear stress", "stress"}};
  return charts;
}

}  // namespace fiberfate
