// Chooses the drive and the length of steps.
#include "molding/step_control.hpp"

#include <algorithm>
#include <cmath>

#include "molding/front.hpp"

namespace fiberfate {
namespace {

/// Shortest step for the front's sake, over the one aimed at: closing pockets pass on what they cannot hold.
constexpr double shortest_share = 0.05;
/// Longest step over the one aimed at, where pressure holds the rate down.
constexpr double longest_share = 2;
/// Share of the set rate below which melt under pressure control counts as standing.
constexpr double least_rate_share = 1e-3;
/// Share of the cavity that may be missing at the end, for round-off.
constexpr double missing_share = 1e-12;
/// Share of the cavity that may be empty at the end where others hold as much too much.
constexpr double settled_share = 1e-11;
/// Share of the nodes at front or gates that are frozen where a melt that stands is frozen off.
constexpr double frozen_share = 0.5;

double fraction_of(const ShellMesh& mesh, const FillingState& state) {
  return state.injected_volume / mesh.total_volume();
}

double total_excess(const FillingState& state) {
  double sum = 0;
  for (const double volume : state.excess) sum += std::max(volume, 0.0);
  return sum;
}

/// Makes a field in which nothing flows between nodes and nothing is sheared.
void still_field(const ShellMesh& mesh, FillingState& state, FlowField& field) {
  const std::size_t n = mesh.node_count(), points = state.rate.size();
  field.shares.resize(points, 0);
  field.inverse_viscosity.assign(points, 0);
  field.fluidity.resize(n, 0);
  field.pressure.assign(n, 0);
  field.gradient.resize(n, Vec2::Zero());
  field.front_factor.resize(n, 2);
  field.edge_flux.assign(mesh.edges().size(), 0);
  field.wet.resize(n, 0);
  field.limited = false;
  std::fill(state.pressure.begin(), state.pressure.end(), 0.0);
  state.sprue_pressure = field.sprue_pressure = 0;
}

/// Makes a step that leaves every node what it holds.
void still_contents(const ShellMesh& mesh, const FillingState& state, StepFlow& step) {
  step.content.resize(mesh.node_count());
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    step.content[i] = mesh.volume(i) * state.filled[i] + state.excess[i];
    step.at_front[i] = state.filled[i] < 1 ? 1 : 0;
  }
  step.new_content = step.content;
}

/// How long a step of at most `volume` at `rate` is: at most the aimed one, and not past an event.
double cut_at_events(const Machine& machine, const FillingState& state, double volume, double rate) {
  const auto& [params, mesh, gates] = machine;
  const double total = mesh.total_volume(), fraction = fraction_of(mesh, state);
  const FlowProfile& profile = params.process.flow;
  const double aimed = total / params.numerics.steps;
  double fraction_ahead = std::min(1.0, gates.next_fraction(state));
  if (params.process.switchover_fraction > fraction + missing_share)
    fraction_ahead = std::min(fraction_ahead, params.process.switchover_fraction);
  double time_ahead = std::min(gates.next_time(state), params.process.longest_time);
  if (profile.against == ProfileAgainst::time)
    time_ahead = std::min(time_ahead, profile.next_row(state.time * (1 + missing_share)));
  else
    fraction_ahead = std::min(fraction_ahead, profile.next_row(fraction + missing_share));
  volume = std::min({volume, aimed, fraction_ahead * total - state.injected_volume});
  double duration = longest_share * aimed / profile.at(state.time, fraction);
  if (rate > 0) duration = std::min(duration, volume / rate);
  return std::min(duration, time_ahead - state.time);
}

/// What full nodes give up of what they hold too much, m³/s.
double released_rate(const FlowField& field) {
  double sum = 0;
  for (const double rate : field.source) sum += rate;
  return sum;
}

/// Whether melt that stands short of the end has frozen off.
FillingEnd end_of_standing_melt(const ShellMesh& mesh, const FillingState& state, const FlowField& field) {
  std::size_t frozen = 0, reached = 0;
  const std::size_t layers = state.rate.size() / mesh.node_count();
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    if (state.filled[i] < 1) continue;
    const auto neighbours = mesh.neighbours(i);
    const bool last = std::any_of(neighbours.begin(), neighbours.end(),
                                  [&](const ShellNeighbour& to) { return state.filled[to.node] < 1; });
    if (!last) continue;
    ++reached;
    if (field.inverse_viscosity[i * layers] == 0) ++frozen;
  }
  const bool frozen_off =
      static_cast<double>(frozen) >= frozen_share * static_cast<double>(reached) && frozen > 0;
  return frozen_off ? FillingEnd::frozen : FillingEnd::short_shot;
}

}  // namespace

bool settling(const ShellMesh& mesh, const FillingState& state) {
  return fraction_of(mesh, state) >= 1 - missing_share;
}

Drive drive_of(const FillingParams& params, const ShellMesh& mesh, const FillingState& state) {
  const MoldingProcess& process = params.process;
  Drive drive;
  drive.rate = process.flow.at(state.time, fraction_of(mesh, state));
  drive.pressure = state.control == ControlMode::switchover ? state.held_pressure : process.pressure_limit;
  drive.pressure = std::min(drive.pressure, greatest_pressure);
  drive.duration = mesh.total_volume() / params.numerics.steps / drive.rate;
  if (!settling(mesh, state)) return drive;
  drive.duration = total_excess(state) / drive.rate;
  drive.rate = 0;
  return drive;
}

void note_control(const FillingParams& params, const FlowField& field, double filled_fraction,
                  FillingState& state) {
  const auto note = [&](FillingEventKind kind) {
    state.events.push_back({state.time, filled_fraction, kind, -1});
  };
  state.flow_rate = field.rate;
  if (filled_fraction >= 1 - missing_share) return;  // settling: the machine no longer has a say
  state.sprue_pressure = field.sprue_pressure;
  if (state.control == ControlMode::switchover) return;
  if (field.limited && state.control == ControlMode::flow) {
    state.control = ControlMode::pressure_limit;
    note(FillingEventKind::pressure_limited);
  } else if (!field.limited && state.control == ControlMode::pressure_limit) {
    state.control = ControlMode::flow;
    note(FillingEventKind::flow_resumed);
  }
  const double switchover = params.process.switchover_fraction;
  if (switchover < 1 && filled_fraction >= switchover - missing_share) {
    state.control = ControlMode::switchover;
    const double wanted = std::min(params.process.switchover_pressure, params.process.pressure_limit);
    state.held_pressure = std::isfinite(params.process.switchover_pressure) ? wanted : field.sprue_pressure;
    note(FillingEventKind::switched_over);
  }
}

bool prime_at_sprue(const Machine& machine, FillingState& state, StepFlow& step, FlowField& field) {
  const auto& [params, mesh, gates] = machine;
  const double missing = gates.lacking(RunnerKind::none, state);
  if (!(missing > 0)) return false;
  still_field(mesh, state, field);
  state.flow_rate = field.rate = params.process.flow.at(state.time, fraction_of(mesh, state));
  step.duration = cut_at_events(machine, state, missing, state.flow_rate);
  const double share = std::min(1.0, step.duration * state.flow_rate / missing);
  still_contents(mesh, state, step);
  gates.fill_at_sprue(share, state, step.gate_volume);
  for (std::size_t node = 0; node < mesh.node_count(); ++node) {
    if (!(step.gate_volume[node] > 0)) continue;
    step.new_content[node] += step.gate_volume[node];
    const double before = state.filled[node];
    state.filled[node] = share < 1 ? step.new_content[node] / mesh.volume(node) : 1;
    if (before < 0.5 && state.filled[node] >= 0.5)
      state.fill_time[node] = state.time + step.duration * (0.5 - before) / (state.filled[node] - before);
  }
  return true;
}

void stand_still(const Machine& machine, FillingState& state, StepFlow& step, FlowField& field) {
  const FillingParams& params = machine.params;
  const ShellMesh& mesh = machine.mesh;
  still_field(mesh, state, field);
  still_contents(mesh, state, step);
  std::fill(field.gradient.begin(), field.gradient.end(), Vec2::Zero());
  std::fill(state.rate.begin(), state.rate.end(), 0.0);
  state.flow_rate = field.rate = 0;
  const double set_rate = params.process.flow.at(state.time, fraction_of(mesh, state));
  step.duration = cut_at_events(machine, state, 0, 0);
  step.duration = std::min(step.duration, mesh.total_volume() / params.numerics.steps / set_rate);
}

double step_duration(const Machine& machine, const FillingState& state, const FlowField& field) {
  const auto& [params, mesh, gates] = machine;
  if (settling(mesh, state))
    return total_excess(state) / params.process.flow.at(state.time, fraction_of(mesh, state));
  const double aimed = mesh.total_volume() / params.numerics.steps;
  const double ahead = volume_at_front(mesh, field) + gates.lacking(RunnerKind::resisting, state);
  const double volume = std::max(ahead, shortest_share * aimed);
  const double duration = std::min(cut_at_events(machine, state, volume, field.rate),
                                   gates.time_to_fill(state, field.sprue_pressure));
  // Full nodes must not give up more than their excess: they would lack melt and yet count as full.
  const bool fed =
      std::any_of(field.source.begin(), field.source.end(), [](double rate) { return rate != 0; });
  return fed ? std::min(duration, aimed / params.process.flow.at(state.time, fraction_of(mesh, state)))
             : duration;
}

FillingEnd reason_to_stop(const FillingParams& params, const ShellMesh& mesh, const FillingState& state,
                          const FlowField& field) {
  if (state.filled_volume >= (1 - settled_share) * mesh.total_volume()) return FillingEnd::filled;
  // All melt is in. No machine drives it any more: what full nodes hold too much finds the last free places,
  // at whatever pressure this takes, unless none can move it.
  if (settling(mesh, state)) {
    if (total_excess(state) <= settled_share * mesh.total_volume()) return FillingEnd::filled;
    return field.released_share < least_rate_share ? end_of_standing_melt(mesh, state, field)
                                                   : FillingEnd::none;
  }
  if (state.time >= params.process.longest_time * (1 - missing_share)) return FillingEnd::time;
  const double set_rate = params.process.flow.at(state.time, fraction_of(mesh, state));
  if (!field.limited || state.flow_rate > least_rate_share * set_rate) return FillingEnd::none;
  // A last corner may fill slowly: the shot is short when it would take longer than the filling was to take.
  const double missing = mesh.total_volume() - state.injected_volume;
  if (missing * set_rate < state.flow_rate * mesh.total_volume()) return FillingEnd::none;
  // What is on its way from full nodes moves the front as well, and holds the machine's melt back meanwhile.
  const double noticed = least_rate_share * mesh.total_volume() / params.numerics.steps;
  if ((total_excess(state) > noticed || released_rate(field) > least_rate_share * set_rate) &&
      field.released_share >= least_rate_share)
    return FillingEnd::none;
  return end_of_standing_melt(mesh, state, field);
}

}  // namespace fiberfate
