// Measures what series.csv of the study shear_cell records.
#include "studies/shear_cell/series.hpp"

#include <algorithm>
#include <limits>

#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/dissipation.hpp"
#include "fibers/observables.hpp"

namespace fiberfate {
namespace {

using Tensor4 = Eigen::Matrix<double, 6, 6>;
constexpr std::array<std::array<int, 2>, 6> pairs_of_2 = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
// Rows and columns of a Tensor4 stand for these; the fifteen components of a fully symmetric tensor follow.
constexpr std::array<const char*, 6> pairs_of_4 = {"11", "22", "33", "23", "31", "12"};

struct Component4 {
  int row, column;
};
constexpr std::array<Component4, 15> components_of_4 = {{{0, 0},
                                                         {1, 1},
                                                         {2, 2},
                                                         {1, 2},
                                                         {0, 2},
                                                         {0, 1},
                                                         {0, 3},
                                                         {0, 4},
                                                         {0, 5},
                                                         {1, 3},
                                                         {1, 4},
                                                         {1, 5},
                                                         {2, 3},
                                                         {2, 4},
                                                         {2, 5}}};

void append_tensor(std::vector<double>& row, const Mat3& tensor) {
  for (const auto& [i, j] : pairs_of_2) row.push_back(tensor(i, j));
}

void append_tensor(std::vector<double>& row, const Tensor4& tensor) {
  for (const Component4& component : components_of_4) row.push_back(tensor(component.row, component.column));
}

void append_names(std::vector<std::string>& names, const std::string& suffix) {
  for (const auto& [i, j] : pairs_of_2)
    names.push_back("a" + std::to_string(i + 1) + std::to_string(j + 1) + suffix);
}

void append_names4(std::vector<std::string>& names, const std::string& suffix) {
  for (const Component4& component : components_of_4)
    names.push_back(std::string("a") + pairs_of_4[static_cast<std::size_t>(component.row)] +
                    pairs_of_4[static_cast<std::size_t>(component.column)] + suffix);
}

/// Measures contacts without letting the measurement count as time of the run's phases.
ContactStatistics measure_contacts(Simulation& simulation) {
  const PhaseTimes before = simulation.times();
  const ContactStatistics statistics = simulation.contact_statistics();
  simulation.times() = before;
  return statistics;
}

/// Power that drag dissipates in a volume of the cell, W/m³; unknown before the first step has told how
/// fibers move.
double drag_power(const std::string& law, const FiberState& state, const Flow& flow) {
  if (state.step == 0) return std::numeric_limits<double>::quiet_NaN();
  return drag_dissipation(state, flow, law) / state.cell.volume();
}

}  // namespace

std::vector<std::string> shear_cell_columns() {
  std::vector<std::string> names = {"time_s", "strain", "rate_per_s", "viscosity_Pa_s", "steps",
                                    "fibers", "rods",   "L_N_m",      "L_W_m"};
  append_names(names, "");
  append_names(names, "_number");
  for (const char* name :
       {"min_radius_m", "near_critical_hinges", "breaks", "contacts", "contacts_per_fiber",
        "max_overlap_radii", "mean_overlap_radii", "max_contact_force_N", "dt_s", "drag_power_W_per_m3"})
    names.emplace_back(name);
  append_names4(names, "");
  append_names4(names, "_number");
  return names;
}

std::vector<double> shear_cell_row(const ShearCellCase& values, const FlowHistory& flow,
                                   Simulation& simulation) {
  const FiberState& state = simulation.state();
  const ContactStatistics contacts = measure_contacts(simulation);
  const MeanLengths lengths = mean_lengths(state);
  const Flow now = flow.at(state.time);
  const double near = critical_radius(values.dynamics.breakage) + values.output.near_critical;
  std::vector<double> row = {state.time,
                             shear_strain(flow, state.time),
                             now.gradient(0, 1),
                             now.viscosity,
                             static_cast<double>(state.step),
                             static_cast<double>(state.fiber_count()),
                             static_cast<double>(state.rod_count()),
                             lengths.number_average,
                             lengths.weight_average};
  append_tensor(row, orientation_tensor(state, Weighting::length));
  append_tensor(row, orientation_tensor(state, Weighting::number));
  row.insert(row.end(),
             {minimum_radius(state), static_cast<double>(count_hinges(state, 0, near)),
              static_cast<double>(state.breaks), static_cast<double>(contacts.contacts),
              contacts.contacts_per_fiber, contacts.max_overlap, contacts.mean_overlap,
              contacts.largest_force, state.step_size, drag_power(values.dynamics.drag, state, now)});
  append_tensor(row, orientation_tensor4(state, Weighting::length));
  append_tensor(row, orientation_tensor4(state, Weighting::number));
  return row;
}

std::vector<std::string> break_columns() {
  return {"time_s", "birth_id", "birth_node", "radius_m", "parent_length_m", "child_length_m"};
}

std::vector<double> break_row(const BreakEvent& event) {
  return {event.time,
          static_cast<double>(event.birth_id),
          static_cast<double>(event.birth_node),
          event.radius,
          event.parent_length,
          event.child_length};
}

double critical_radius(const BreakageParameters& breakage) {
  const double certain = breakage_law_named(breakage.law).certain_radius(breakage);
  return certain > 0 ? certain : breakage.critical_radius;
}

double shear_strain(const FlowHistory& flow, double time) {
  double strain = 0;
  double begin = 0;
  for (const FlowInterval& interval : flow.intervals()) {
    const bool lasts = &interval == &flow.intervals().back();
    const double end = lasts ? time : std::min(interval.end_time, time);
    strain += interval.rate * std::max(0.0, end - begin);
    begin = std::max(begin, end);
  }
  return strain;
}

}  // namespace fiberfate
