// What the study orientation measures at every output time.
#include "studies/orientation/observables.hpp"

namespace fiberfate {
namespace {

using Moment = OrientationMoment;

Observables<Moment> shape() {
  const std::string group = "principal_values", stretching = "stretching";
  return {
      {"principal_1", "", "first", group, [](const Moment& m) { return m.principal[0]; }},
      {"principal_2", "", "second", group, [](const Moment& m) { return m.principal[1]; }},
      {"principal_3", "", "third", group, [](const Moment& m) { return m.principal[2]; }},
      {"stretching_share", "", "share", stretching, [](const Moment& m) { return m.stretching_share; }},
  };
}

/// The components without closure; a chart shows those on the diagonal beside the others.
Observables<Moment> without_closure() {
  Observables<Moment> all =
      tensor_observables<Moment>({"distribution_a"}, [](const Moment& m) { return m.exact; });
  for (std::size_t i = 0; i < 3; ++i) {
    all[i].label = "a_" + std::to_string(11 * (i + 1)) + " without closure";
    all[i].group = "components";
    all[i].style = CurveStyle::dashed;
  }
  return all;
}

Observables<Moment> stress() {
  const std::string group = "viscosity";
  return joined<Moment>(
      {{{"viscosity_Pa_s", "Pa s", "matrix", group, [](const Moment& m) { return m.stress.viscosity; },
         InSummary::as_number},
        {"effective_viscosity_Pa_s", "Pa s", "informed isotropic", group,
         [](const Moment& m) { return m.stress.effective_viscosity; }, InSummary::as_number}},
       tensor_observables<Moment>({"stress_", "_Pa", "Pa", "sigma", "stress"},
                                  [](const Moment& m) { return m.stress.extra; })});
}

}  // namespace

Observables<OrientationMoment> orientation_observables(const OrientationCase& values) {
  const Observables<Moment> flow = {
      {"time_s", "s", "", "", [](const Moment& m) { return m.time; }},
      {"strain", "", "", "", [](const Moment& m) { return m.strain; }, InSummary::as_number},
      {"rate_per_s", "1/s", "", "", [](const Moment& m) { return m.rate; }}};
  std::vector<Observables<Moment>> tables = {
      flow,
      tensor_observables<Moment>({"a", "", "", "a", "components"}, [](const Moment& m) { return m.second; }),
      shape()};
  if (values.solution.distribution == DistributionChoice::yes) tables.push_back(without_closure());
  if (!values.melt.name.empty()) tables.push_back(stress());
  return joined(tables);
}

const std::vector<Chart>& orientation_charts() {
  static const std::vector<Chart> charts = {
      {"components", "Orientation tensor", "component"},
      {"principal_values", "Principal values", "principal value"},
      {"stretching", "Share of the flow that stretches the fibers", "D:A4:D / D:D"},
      {"stress", "Extra stress", "stress"},
      {"viscosity", "Viscosity", "viscosity"}};
  return charts;
}

}  // namespace fiberfate
