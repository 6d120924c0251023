// The step of a filling: gates, flow, front, heat, lengths, orientation, events.
#include "molding/filling.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/timer.hpp"
#include "molding/flow_solver.hpp"
#include "molding/front.hpp"
#include "molding/gate_control.hpp"
#include "molding/heat.hpp"
#include "molding/last_melt.hpp"
#include "molding/length_transport.hpp"
#include "molding/orientation_transport.hpp"
#include "molding/state_checks.hpp"
#include "molding/step_control.hpp"
#include "molding/step_record.hpp"
#include "molding/sweep.hpp"
#include "molding/viscosity_stretch.hpp"

namespace fiberfate {

/// Parameters, state and scratch; only the state lasts.
struct Filling::Parts {
  Parts(ShellMesh mesh_in, FillingParams params_in)
      : mesh(std::move(mesh_in)),
        params(checked(std::move(params_in), mesh)),
        layers(params.numerics.layers / 2, params.numerics.wall_width_ratio,
               params.numerics.middle_width_ratio),
        gates(mesh, params),
        solver(mesh, params, layers),
        heat(mesh, params, layers),
        lengths(mesh, params, layers),
        orientation(mesh, params, layers) {}

  static FillingParams checked(FillingParams params, const ShellMesh& mesh) {
    check_params(params, mesh);
    return params;
  }

  ShellMesh mesh;
  FillingParams params;
  GapLayers layers;
  FillingState state;
  GateControl gates;
  FlowSolver solver;
  HeatTransport heat;
  LengthTransport lengths;
  OrientationTransport orientation;

  FlowField field;
  StepFlow step;
  std::vector<GateLink> links;  ///< of the open gates
  std::vector<std::size_t> open_gates;
  std::vector<double> stretching;
  std::optional<StepRecord> record;
  std::array<double, filling_phase_count> seconds{};

  void start();
  [[nodiscard]] StateShape shape() const;
  void link_gates();
  void follow_gates();
  [[nodiscard]] std::vector<double> stretching_now() const;
  void solve_flow();
  void measure_gates();
  void move_front();
  void carry();
  void sweep(bool heated);
  void conclude();
  void make_step();
  void settle();
  [[nodiscard]] bool is_settling() const { return settling(mesh, state); }
  [[nodiscard]] Machine machine() const { return {params, mesh, gates}; }
  [[nodiscard]] MeltMotion motion() const { return {layers, step, field, stretching}; }
  [[nodiscard]] double fraction() const { return state.injected_volume / mesh.total_volume(); }
  template <class Body>
  void timed(FillingPhase phase, const Body& body) {
    const double begin = wall_seconds();
    body();
    seconds[static_cast<std::size_t>(phase)] += wall_seconds() - begin;
  }
};

void Filling::Parts::start() {
  const std::size_t n = mesh.node_count(), points = n * layers.count();
  state.gates.assign(params.gates.size(), {});
  state.sensor_arrivals.assign(params.sensors.size(), std::numeric_limits<double>::quiet_NaN());
  state.filled.assign(n, 0);
  state.excess.assign(n, 0);
  state.fill_time.assign(n, std::numeric_limits<double>::quiet_NaN());
  state.pressure.assign(n, 0);
  state.gradient.assign(n, Vec2::Zero());
  state.inflow.assign(n, Vec2::Zero());
  state.mark.assign(n, NodeMark::none);
  state.temperature.assign(points, params.process.inlet_temperature);
  state.rate.assign(points, 0);
  if (params.fibers.orientation)
    for (auto& component : state.orientation) component.assign(points, 0);
  state.lengths.assign(points * lengths.field_count(), 0);
}

StateShape Filling::Parts::shape() const {
  StateShape shape{
      mesh.node_count(),     layers.count(),        params.fibers.orientation ? state.orientation.size() : 0,
      lengths.field_count(), params.sensors.size(), {}};
  for (const Gate& gate : params.gates)
    shape.most_moves.push_back(2 * static_cast<int>(gate.intervals.size()));
  return shape;
}

void Filling::Parts::link_gates() {
  links = gates.links(state, open_gates);
  std::vector<Gate> open;
  for (const std::size_t g : open_gates) open.push_back(params.gates[g]);
  solver.set_gates(links, open);
}

/// Links the gates anew where one has opened or closed, or where the front has passed one.
void Filling::Parts::follow_gates() {
  std::vector<std::size_t> open;
  if (gates.links(state, open) == links) return;
  state.covered.clear();
  link_gates();
}

/// By how much fibers raise the viscosity at the present state; nothing where they do not.
std::vector<double> Filling::Parts::stretching_now() const {
  if (!params.fibers.coupling) return {};
  const FiberCoupling& coupling = *params.fibers.coupling;
  const std::ptrdiff_t place =
      coupling.length_set < 0
          ? -1
          : static_cast<std::ptrdiff_t>(lengths.field_begin(coupling.length_set)) + coupling.length_class;
  return ViscosityStretch({mesh, layers}, params.fibers, place).at(state, field);
}

void Filling::Parts::solve_flow() {
  stretching = stretching_now();
  solver.solve(state, drive_of(params, mesh, state), stretching, field);
  note_control(params, field, fraction(), state);
}

void Filling::Parts::measure_gates() {
  for (std::size_t g = 0; g < state.gates.size(); ++g) {
    state.gates[g].rate = 0;
    state.gates[g].pressure = state.pressure[gates.nodes(g).front()];
  }
  for (std::size_t place = 0; place < links.size(); ++place)
    if (links[place].front == GateFront::inside) state.gates[open_gates[place]].pressure = 0;
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    if (step.gate_volume[i] == 0) continue;
    GateState& gate = state.gates[step.gate[i]];
    gate.rate += step.gate_volume[i] / step.duration;
    gate.volume += step.gate_volume[i];
  }
  state.injected_volume += field.rate * step.duration;
}

void Filling::Parts::move_front() {
  step.edge_volume.assign(mesh.edges().size(), 0);
  step.gate_volume.assign(mesh.node_count(), 0);
  step.at_front.resize(mesh.node_count());
  if (open_gates.empty()) return stand_still(machine(), state, step, field);
  gates.note_fed_nodes(state, step.gate);
  if (prime_at_sprue(machine(), state, step, field)) return;
  timed(FillingPhase::flow, [&] { solve_flow(); });
  step.duration = step_duration(machine(), state, field);
  gates.fill_through_runners(field.sprue_pressure, step.duration, state, step.gate_volume);
  for (std::size_t i = 0; i < mesh.node_count(); ++i) step.at_front[i] = field.wet[i] == 0 ? 1 : 0;
  timed(FillingPhase::front, [&] { advance_front(solver, field, step, state); });
}

void Filling::Parts::carry() {
  timed(FillingPhase::front, [&] {
    sort_into_levels(mesh, step);
    inherit_at_front({mesh, layers}, step, field, state);
    split_by_layers({mesh, layers}, field, step);
  });
  const bool heated = params.numerics.heat == HeatModel::full;
  if (heated) timed(FillingPhase::heat, [&] { heat.begin(step, field); });
  if (record) record->keep(motion(), state);
  sweep(heated);
  if (heated) heat.end(state);
}

/// All that rides on the melt goes down the flow together: threads wait for each other once a level. The wall
/// time of the sweep is shared out as the phases' times on all threads are.
void Filling::Parts::sweep(bool heated) {
  std::array<std::atomic<double>, filling_phase_count> spent{};
  std::exception_ptr failure;
  const auto body = [&](std::span<const Index> nodes) {
    double begin = wall_seconds();
    const auto lap = [&](FillingPhase phase) {
      const double now = wall_seconds();
      spent[static_cast<std::size_t>(phase)].fetch_add(now - begin, std::memory_order_relaxed);
      begin = now;
    };
    if (heated) heat.advance(nodes, motion(), state);
    lap(FillingPhase::heat);
    lengths.advance(nodes, motion(), state);
    lap(FillingPhase::lengths);
    orientation.advance(nodes, motion(), state);
    lap(FillingPhase::orientation);
  };
  const double begin = wall_seconds();
  sweep_down_the_flow(step, [&](std::span<const Index> nodes) {
    try {
      body(nodes);
    } catch (const std::exception&) {
      // Exceptions must not leave a thread; any one of them tells what went wrong.
#pragma omp critical
      failure = std::current_exception();
    }
  });
  if (failure) std::rethrow_exception(failure);
  double sum = 0;
  for (const auto& one : spent) sum += one;
  for (std::size_t p = 0; p < filling_phase_count && sum > 0; ++p)
    seconds[p] += (wall_seconds() - begin) * spent[p] / sum;
}

void Filling::Parts::conclude() {
  measure_gates();
  state.time += step.duration;
  ++state.steps;
  state.gradient = field.gradient;
  mark_front(mesh, step, state);
  state.filled_volume = 0;
  for (std::size_t i = 0; i < mesh.node_count(); ++i) state.filled_volume += mesh.volume(i) * state.filled[i];
  require_bearable_temperatures(mesh, params, state);
  state.stop_reason = reason_to_stop(params, mesh, state, field);
  if (state.stop_reason == FillingEnd::filled) mark_last(state);
  follow_gates();
}

void Filling::Parts::make_step() {
  Readings before(state);
  move_front();
  carry();
  conclude();
  if (is_settling()) bound_last_pressures(std::move(before), params, state);
}

/// Moves melt that has come in on to the last free places.
void Filling::Parts::settle() {
  Readings before(state);
  gates.update(state);
  follow_gates();
  move_front();
  carry();
  conclude();
  show_again(std::move(before), params, state);
}

Filling::Filling(ShellMesh mesh, FillingParams params)
    : parts_(std::make_unique<Parts>(std::move(mesh), std::move(params))) {
  parts_->start();
}

Filling::Filling(ShellMesh mesh, FillingParams params, FillingState state)
    : Filling(std::move(mesh), std::move(params)) {
  check_state(state, parts_->shape());
  parts_->state = std::move(state);
  parts_->field.gradient = parts_->state.gradient;
  parts_->link_gates();
}

Filling::~Filling() = default;
Filling::Filling(Filling&&) noexcept = default;
Filling& Filling::operator=(Filling&&) noexcept = default;

void Filling::advance() {
  Parts& p = *parts_;
  if (finished()) return;
  p.gates.update(p.state);
  p.follow_gates();
  if (p.open_gates.empty() && !std::isfinite(p.gates.next_time(p.state))) {
    p.state.stop_reason = FillingEnd::short_shot;
  } else {
    p.make_step();
    while (!finished() && p.is_settling()) p.settle();
  }
  if (finished()) p.state.events.push_back({p.state.time, p.fraction(), FillingEventKind::ended, -1});
}

const FillingState& Filling::run_to_end() {
  while (!finished()) advance();
  return state();
}

void Filling::keep_steps() {
  parts_->record.emplace();
}

void Filling::follow_lengths_again(std::vector<LengthSet> sets) {
  Parts& p = *parts_;
  const bool whole = p.record && static_cast<std::int64_t>(p.record->step_count()) == p.state.steps;
  if (!whole || sets.size() != p.params.fibers.length_sets.size())
    throw InputError("the lengths of this filling cannot be followed again",
                     "keep its steps from the start on, and give as many laws as it had");
  p.params.fibers.length_sets = std::move(sets);
  p.lengths = LengthTransport(p.mesh, p.params, p.layers);
  p.state.lengths = p.record->follow(p.lengths, {p.mesh, p.layers});
}

const ShellMesh& Filling::mesh() const {
  return parts_->mesh;
}
const FillingParams& Filling::params() const {
  return parts_->params;
}
const GapLayers& Filling::layers() const {
  return parts_->layers;
}
const FillingState& Filling::state() const {
  return parts_->state;
}
double Filling::filled_fraction() const {
  return parts_->state.filled_volume / parts_->mesh.total_volume();
}
double Filling::seconds(FillingPhase phase) const {
  return parts_->seconds[static_cast<std::size_t>(phase)];
}

std::size_t Filling::field_count(std::size_t set) const {
  return parts_->lengths.field_begin(set + 1) - parts_->lengths.field_begin(set);
}

std::span<const double> Filling::lengths(std::size_t set, std::size_t node, std::size_t layer) const {
  const std::size_t point = node * layers().count() + layer;
  return std::span(state().lengths)
      .subspan(point * parts_->lengths.field_count() + parts_->lengths.field_begin(set), field_count(set));
}

std::span<const double> Filling::amounts(std::size_t node, std::size_t layer) const {
  const LengthTransport& lengths = parts_->lengths;
  const std::size_t end = (node * layers().count() + layer + 1) * lengths.field_count();
  return std::span(state().lengths).subspan(end - lengths.amount_count(), lengths.amount_count());
}

std::vector<double> Filling::mean_lengths_of(std::size_t set, std::size_t node) const {
  std::vector<double> mean(field_count(set), 0);
  for (std::size_t k = 0; k < layers().count(); ++k) {
    const std::span<const double> values = lengths(set, node, k);
    for (std::size_t f = 0; f < mean.size(); ++f) mean[f] += layers().widths()[k] * values[f];
  }
  return mean;
}

std::span<const double> Filling::bin_lengths(std::size_t set) const {
  return parts_->lengths.bin_lengths(set);
}

std::vector<double> Filling::gap_average(std::span<const double> by_point) const {
  std::vector<double> mean(mesh().node_count(), 0);
  for (std::size_t i = 0; i < mean.size(); ++i)
    for (std::size_t k = 0; k < layers().count() && state().filled[i] > 0; ++k)
      mean[i] += layers().widths()[k] * by_point[i * layers().count() + k];
  return mean;
}

std::vector<double> Filling::viscosity() const {
  const std::size_t count = layers().count();
  const std::vector<double> stretching = parts_->stretching_now();
  std::vector<double> values(mesh().node_count() * count);
  for (std::size_t i = 0; i < mesh().node_count(); ++i)
    parts_->solver.viscosities(state(), i, stretching, std::span(values).subspan(i * count, count));
  return values;
}

std::vector<Vec3> Filling::velocity() const {
  std::vector<Vec3> values(mesh().node_count(), Vec3::Zero());
  for (std::size_t i = 0; i < parts_->field.fluidity.size(); ++i) {
    if (!(state().filled[i] > 0)) continue;
    const double mobility = std::pow(mesh().thickness(i), 2) / 4 * parts_->field.fluidity[i];
    const Vec2 v = -mobility * parts_->field.gradient[i];
    values[i] = mesh().frame(i).leftCols<2>() * v;
  }
  return values;
}

double Filling::stored_heat() const {
  return fiberfate::stored_heat(mesh(), params(), layers(), state());
}

}  // namespace fiberfate
