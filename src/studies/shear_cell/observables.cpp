// What the study shear_cell measures at every output time.
#include "studies/shear_cell/observables.hpp"

#include <array>
#include <limits>

#include "dynamics/dissipation.hpp"
#include "studies/shear_cell/stress_observables.hpp"

namespace fiberfate {
namespace {

using Tensor4 = Eigen::Matrix<double, 6, 6>;

double count(std::int64_t number) {
  return static_cast<double>(number);
}

/// Hinges that are bent nearly as sharply as breaks them.
double near_critical_hinges(const CellMoment& m) {
  return count(
      count_hinges(m.state, 0, critical_radius(m.values.dynamics.breakage) + m.values.output.near_critical));
}

/// Power that drag dissipates in a volume of the cell, W/m³; unknown before the first step has told how
/// fibers move.
double drag_power(const CellMoment& m) {
  if (m.state.step == 0) return std::numeric_limits<double>::quiet_NaN();
  return drag_dissipation(m.state, m.flow, m.values.dynamics.drag) / m.state.cell.volume();
}

/// The fifteen components of a fully symmetric tensor of fourth order.
Observables<CellMoment> fourth_moments(const std::string& suffix, Tensor4 CellMoment::*tensor) {
  // Rows and columns of a Tensor4 stand for these.
  constexpr std::array<const char*, 6> pairs = {"11", "22", "33", "23", "31", "12"};
  Observables<CellMoment> all;
  const auto add = [&](int row, int column) {
    all.push_back({std::string("a") + pairs[row] + pairs[column] + suffix, "", "", "",
                   [=](const CellMoment& m) { return (m.*tensor)(row, column); }});
  };
  for (int i = 0; i < 3; ++i) add(i, i);
  for (const auto& [i, j] : {std::pair{1, 2}, {0, 2}, {0, 1}}) add(i, j);
  for (int i = 0; i < 3; ++i)
    for (int j = 3; j < 6; ++j) add(i, j);
  return all;
}

Observables<CellMoment> flow_and_lengths() {
  return {
      {"time_s", "s", "", "", [](const CellMoment& m) { return m.state.time; }},
      {"strain", "", "", "", [](const CellMoment& m) { return m.strain; }, InSummary::as_number},
      {"hencky_strain", "", "", "", [](const CellMoment& m) { return m.hencky_strain; },
       InSummary::as_number},
      {"rate_per_s", "1/s", "rate", "flow", [](const CellMoment& m) { return m.rate; }},
      {"viscosity_Pa_s", "Pa s", "", "", [](const CellMoment& m) { return m.flow.viscosity; }},
      {"steps", "", "", "", [](const CellMoment& m) { return count(m.state.step); }},
      {"fibers", "", "", "", [](const CellMoment& m) { return count(m.state.fiber_count()); }},
      {"rods", "", "", "", [](const CellMoment& m) { return count(m.state.rod_count()); }},
      {"L_N_m", "m", "L_N", "mean_lengths", [](const CellMoment& m) { return m.lengths.number_average; }},
      {"L_W_m", "m", "L_W", "mean_lengths", [](const CellMoment& m) { return m.lengths.weight_average; }},
  };
}

Observables<CellMoment> hinges_and_contacts() {
  constexpr InSummary number = InSummary::as_number, whole = InSummary::as_count;
  return {
      {"min_radius_m", "m", "", "", [](const CellMoment& m) { return minimum_radius(m.state); }, number},
      {"near_critical_hinges", "", "near critical", "near_critical", near_critical_hinges, whole},
      {"breaks", "", "breaks", "breaks", [](const CellMoment& m) { return count(m.state.breaks); }},
      {"contacts", "", "", "", [](const CellMoment& m) { return count(m.contacts.contacts); }, whole},
      {"contacts_per_fiber", "", "contacts", "contacts",
       [](const CellMoment& m) { return m.contacts.contacts_per_fiber; }, number},
      {"max_overlap_radii", "radii", "largest", "overlap",
       [](const CellMoment& m) { return m.contacts.max_overlap; }},
      {"mean_overlap_radii", "radii", "mean", "overlap",
       [](const CellMoment& m) { return m.contacts.mean_overlap; }, number},
      {"max_contact_force_N", "N", "", "", [](const CellMoment& m) { return m.contacts.largest_force; }},
      {"dt_s", "s", "step", "step", [](const CellMoment& m) { return m.state.step_size; }, number},
      {"drag_power_W_per_m3", "W/m3", "fibers", "dissipation", drag_power},
  };
}

}  // namespace

CellMoment moment_of(const ShearCellCase& values, const FlowHistory& flow, Simulation& simulation) {
  const PhaseTimes before = simulation.times();
  const ContactStatistics contacts = simulation.contact_statistics();
  simulation.times() = before;
  const FiberState& state = simulation.state();
  return {values,
          state,
          flow.at(state.time),
          flow_rate(values.flow, flow.at(state.time).gradient),
          flow_strain(values.flow, flow, state.time),
          hencky_strain(state.cell.frame, flow, state.time),
          mean_lengths(state),
          contacts,
          orientation_tensor(state, Weighting::length),
          orientation_tensor(state, Weighting::number),
          orientation_tensor4(state, Weighting::length),
          orientation_tensor4(state, Weighting::number)};
}

const Observables<CellMoment>& cell_observables() {
  static const Observables<CellMoment> all = joined<CellMoment>(
      {flow_and_lengths(),
       tensor_observables<CellMoment>({"a", "", "", "a", "orientation", CurveStyle::dashed},
                                      [](const CellMoment& m) { return m.a2; }),
       tensor_observables<CellMoment>({"a", "_number"}, [](const CellMoment& m) { return m.a2_number; }),
       hinges_and_contacts(), stress_observables(), fourth_moments("", &CellMoment::a4),
       fourth_moments("_number", &CellMoment::a4_number)});
  return all;
}

const std::vector<Chart>& cell_charts() {
  static const std::vector<Chart> charts = {
      {"mean_lengths", "Mean fiber lengths", "length"},
      {"orientation", "Orientation tensor, by length", "component"},
      {"breaks", "Breaks", "breaks so far"},
      {"near_critical", "Hinges near breaking", "hinges"},
      {"contacts", "Contacts", "contacts per fiber"},
      {"overlap", "Overlap of fibers in contact", "overlap"},
      {"viscosity", "Relative viscosity", "viscosity over the melt's"},
      {"normal_stress", "Normal stress differences", "stress"},
      {"stress", "Particle stress", "component"},
      {"stretch_causes", "What makes the stress along x", "component 11"},
      {"shear_causes", "What makes the shear stress", "component 12"},
      {"power_balance", "Power that the flow spends on fibers", "power"},
      {"dissipation", "Power dissipated by drag", "power"},
      {"step", "Step size", "step", AxisScale::logarithmic},
      {"flow", "Rate of the flow", "rate"}};
  return charts;
}

const Observables<BreakEvent>& break_observables() {
  static const Observables<BreakEvent> all = {
      {"time_s", "s", "", "", [](const BreakEvent& event) { return event.time; }},
      {"birth_id", "", "", "", [](const BreakEvent& event) { return count(event.birth_id); }},
      {"birth_node", "", "", "", [](const BreakEvent& event) { return count(event.birth_node); }},
      {"radius_m", "m", "", "", [](const BreakEvent& event) { return event.radius; }},
      {"parent_length_m", "m", "", "", [](const BreakEvent& event) { return event.parent_length; }},
      {"child_length_m", "m", "", "", [](const BreakEvent& event) { return event.child_length; }},
  };
  return all;
}

}  // namespace fiberfate
