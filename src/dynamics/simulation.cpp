// Steps a population of fibers: neighbours, loads, solve, trial, accept or shrink, breakage.
#include "dynamics/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "dynamics/breakage.hpp"
#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/chain_solver.hpp"
#include "dynamics/contact_loads.hpp"
#include "dynamics/contact_search.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/simulable.hpp"
#include "dynamics/step_control.hpp"
#include "fibers/neighbour_list.hpp"

namespace fiberfate {
namespace {

// Margins are made to last for so many steps at the present speeds, within bounds in radii: wide ones list
// more pairs, narrow ones list them more often. Speeds flicker from contact to contact, so half of the mean
// speed is allowed to every rod.
constexpr double margin_life = 40;
constexpr double shared_speed = 0.5;
constexpr double least_margin = 2;
constexpr double most_margin = 4;
// Where more rods than this share leave their margins at once, it is cheaper to list all.
constexpr double most_renewed = 0.3;

// Fewer rods are stepped faster by one thread than by threads that wait for each other a dozen times a step.
constexpr std::int64_t rods_a_thread = 1000;

[[nodiscard]] SuitableThreads suitable_threads(const FiberState& state) {
  return {state.rod_count(), rods_a_thread};
}

ContactGap<double> gap_of(const FiberState& state, const Contact& contact) {
  const Vec3 first = state.axis(contact.first).normalized();
  const Vec3 second = state.axis(contact.second).normalized();
  return {contact.distance, first.cross(second).norm()};
}

}  // namespace

/// Parameters, state and scratch, apart.
struct Simulation::Parts {
  Parts(const DynamicsParameters& chosen, FlowHistory history, FiberState begin)
      : parameters(chosen),
        breakage_law(breakage_law_named(chosen.breakage.law)),
        flow(std::move(history)),
        state(std::move(begin)),
        loads(chosen.contact, state) {
    if (state.step_size <= 0) state.step_size = parameters.step.initial;
    fit_to_fibers();
  }

  /// Renews everything that depends on which fibers there are.
  void fit_to_fibers() {
    const std::size_t nodes = state.position.size();
    solver.arrange(state, {parameters.drag, parameters.hinge});
    middle.resize(nodes);
    velocity.resize(nodes);
    tension.resize(nodes);
    travelled.resize(nodes);
  }

  [[nodiscard]] bool has_contacts() const { return loads.range() > 0; }
  [[nodiscard]] bool may_break() const { return breakage_law.onset_radius(parameters.breakage) > 0; }
  [[nodiscard]] double next_check() const {
    return static_cast<double>(state.breakage_checks + 1) * parameters.breakage.check_interval;
  }
  [[nodiscard]] double next_event(double until) const {
    const double change = std::min(until, flow.next_change(state.time));
    return may_break() ? std::min(change, next_check()) : change;
  }

  void find_contacts(const Flow& now, double step);
  void renew_list(const Flow& now, double step);
  [[nodiscard]] double margin_of(FiberIndex fiber, double ahead, double mean_ahead) const;
  double try_step(const Flow& now, double step);
  [[nodiscard]] bool reaches(double event, double step) const {
    return state.time + step >= event - 1e-6 * step;
  }
  [[nodiscard]] bool is_watched(double step) const {
    return stress_interval > 0 && ((state.step + 1) % stress_interval == 0 || reaches(asked_time, step));
  }
  [[nodiscard]] ParticleStress measure_stress(const Flow& now, double step) const;
  void accept(const Flow& now, const StepChoice& choice, double error, double event);
  void measure(const Contact& contact, ContactStatistics& statistics, std::vector<double>& overlaps) const;
  [[nodiscard]] SimulationFailure failure(const std::string& what) const;

  // Params
  DynamicsParameters parameters;
  const BreakageRow& breakage_law;
  FlowHistory flow;
  // State
  FiberState state;
  // Scratch
  NeighbourList neighbours;
  ContactSearch search;
  ContactLoads loads;
  ChainSolver solver;
  IndexedVector<NodeIndex, Vec3> middle;
  IndexedVector<NodeIndex, Vec3> velocity;
  IndexedVector<NodeIndex, Vec3> last_velocity;  // of a watched step: about which contacts are linearised
  IndexedVector<RodIndex, double> tension;
  IndexedVector<RodIndex, double> margin;
  IndexedVector<RodIndex, double> travelled;
  IndexedVector<FiberIndex, double> error_by_fiber;
  bool list_is_stale = true;
  std::int64_t stress_interval = 0;  // steps; 0: stress is not watched
  double asked_time = 0;             // to which the present step advances at most, s
  // Results
  std::vector<BreakEvent> events;
  PhaseTimes times;
};

Simulation::Simulation(const DynamicsParameters& parameters, FlowHistory flow, FiberState state) {
  require_admissible(parameters);
  require_simulable(state);
  require_simulable(flow);
  require_flow(state.cell, flow);
  const SuitableThreads threads = suitable_threads(state);
  parts_ = std::make_unique<Parts>(parameters, std::move(flow), std::move(state));
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

StepReport Simulation::advance(double until) {
  Parts& p = *parts_;
  if (!(until > p.state.time))
    throw InputError(fmt::format("asked to step to {:g} s, but it is {:g} s already", until, p.state.time),
                     "ask for a later time");
  const SuitableThreads threads = suitable_threads(p.state);
  const Flow now = p.flow.at(p.state.time);
  const double event = p.next_event(until);
  p.asked_time = until;
  StepChoice choice = propose_step(p.parameters.step, p.state.step_size, now, event - p.state.time);
  int rejections = 0;
  double error = p.try_step(now, choice.size);
  while (!is_acceptable(p.parameters.step, error)) {
    choice = {shrunk_step(p.parameters.step, choice.size, error), StepLimit::tolerance};
    if (choice.size < p.parameters.step.minimum) throw p.failure("no step above the minimum is acceptable");
    error = p.try_step(now, choice.size);
    ++rejections;
  }
  if (!(p.state.time + choice.size > p.state.time))
    throw p.failure("the step is too short to advance the time");
  StepReport report{choice.size, choice.limit, rejections};
  if (p.is_watched(choice.size)) report.stress = p.measure_stress(now, choice.size);
  p.accept(now, choice, error, event);
  return report;
}

/// Solves for the velocities of a trial step and returns its error.
double Simulation::Parts::try_step(const Flow& now, double step) {
  find_contacts(now, step);
  extrapolate_to_middle(state, now, step, middle);
  IndexedSpan<NodeIndex, const Vec3> last = state.relative_velocity;
  for (int sweep = 0; sweep < parameters.contact.sweeps; ++sweep) {
    if (is_watched(step)) last_velocity.assign(last.begin(), last.end());
    {
      const PhaseTimer timer(times, Phase::loads);
      loads.evaluate(search.contacts(), {state.position, last, now, step});
    }
    const PhaseTimer timer(times, Phase::solve);
    const ChainProblem problem{state, middle, loads.walls(), now, step, &loads.pairs(), last};
    solver.solve(problem, {velocity, tension});
    last = velocity;
  }
  return displacement_error(state, step, error_by_fiber, velocity);
}

/// Evaluates the stress of the last trial step.
ParticleStress Simulation::Parts::measure_stress(const Flow& now, double step) const {
  const ChainProblem problem{state, middle, loads.walls(), now, step, &loads.pairs(), last_velocity};
  return particle_stress({problem, velocity, tension, loads}, {parameters.drag, parameters.hinge});
}

void Simulation::Parts::find_contacts(const Flow& now, double step) {
  if (has_contacts()) {
    {
      const PhaseTimer timer(times, Phase::neighbours);
      if (!neighbours.look_ahead(state, now, step) || list_is_stale) renew_list(now, step);
    }
    const PhaseTimer timer(times, Phase::loads);
    search.find(state, neighbours, loads.range());
  }
  const PhaseTimer timer(times, Phase::loads);
  loads.arrange(search.contacts(), state);
}

/// Lists the rods that leave their margins anew, or all rods.
void Simulation::Parts::renew_list(const Flow& now, double step) {
  const auto ahead = neighbours.ahead();
  const double mean = std::accumulate(ahead.begin(), ahead.end(), 0.0) / static_cast<double>(ahead.size());
  margin.resize(ahead.size(), 0.0);
  const auto leaving = neighbours.leaving();
  if (!list_is_stale && std::ssize(leaving) < most_renewed * state.rod_count()) {
    for (const RodIndex rod : leaving) margin[rod] = margin_of(neighbours.fiber_of(rod), ahead[rod], mean);
    if (neighbours.renew(state, margin)) return;
  }
  for (const FiberIndex fiber : state.fibers()) {
    for (const RodIndex rod : state.rods(fiber)) margin[rod] = margin_of(fiber, ahead[rod], mean);
  }
  neighbours.build(state, loads.range(), margin);
  list_is_stale = !neighbours.look_ahead(state, now, step);
}

/// A margin that lasts a rod of the fiber for some steps, m.
double Simulation::Parts::margin_of(FiberIndex fiber, double ahead, double mean_ahead) const {
  const double radius = state.material(fiber).radius;
  const double wanted = margin_life * (ahead + shared_speed * mean_ahead);
  return std::clamp(wanted, least_margin * radius, most_margin * radius) + 2 * ahead;
}

void Simulation::Parts::accept(const Flow& now, const StepChoice& choice, double error, double event) {
  {
    const PhaseTimer timer(times, Phase::update);
    const bool reaches_event = reaches(event, choice.size);
    move_fibers(state, now, choice.size, velocity, travelled);
    if (reaches_event) state.time = event;
    state.step_size = next_proposal(parameters.step, choice, state.step_size, error);
    if (has_contacts()) neighbours.carry(now, choice.size, travelled);
    release_separated_ends(state, loads.range());
    if (tidy_cell(state)) list_is_stale = true;
  }
  if (!may_break() || state.time < next_check()) return;
  const PhaseTimer timer(times, Phase::breakage);
  const std::vector<NodeIndex> broken = check_breakage(state, parameters, events);
  if (broken.empty()) return;
  fit_to_fibers();
  if (!list_is_stale) neighbours.split(state, broken);
}

SimulationFailure Simulation::Parts::failure(const std::string& what) const {
  FailurePlace place{state.step, state.time, -1, 0};
  place.largest_force = loads.largest_normal_force();
  double worst = -1;
  for (const FiberIndex fiber : state.fibers()) {
    for (const NodeIndex node : state.nodes(fiber)) {
      const double change = (velocity[node] - state.relative_velocity[node]).norm();
      if (std::isfinite(change) && change <= worst) continue;
      worst = std::isfinite(change) ? change : std::numeric_limits<double>::infinity();
      place.fiber = state.birth_id[fiber];
    }
  }
  return {what, place};
}

void Simulation::watch_stress(std::int64_t steps) {
  parts_->stress_interval = steps;
}

const FiberState& Simulation::state() const {
  return parts_->state;
}

std::vector<BreakEvent> Simulation::take_break_events() {
  return std::exchange(parts_->events, {});
}

ContactStatistics Simulation::contact_statistics() {
  Parts& p = *parts_;
  ContactStatistics statistics;
  if (!p.has_contacts()) return statistics;
  const SuitableThreads threads = suitable_threads(p.state);
  p.find_contacts(p.flow.at(p.state.time), 0);
  std::vector<double> overlaps;
  for (const ContactChunk& chunk : p.search.contacts()) {
    for (int i = 0; i < chunk.count; ++i) p.measure(chunk.at(i), statistics, overlaps);
  }
  statistics.contacts = static_cast<std::int64_t>(overlaps.size());
  statistics.contacts_per_fiber = 2.0 * static_cast<double>(statistics.contacts) / p.state.fiber_count();
  // Contacts come in the order of the neighbour list, which a resumed run builds anew: sort, so that the sum
  // always rounds alike.
  std::sort(overlaps.begin(), overlaps.end());
  const double sum = std::accumulate(overlaps.begin(), overlaps.end(), 0.0);
  if (statistics.contacts > 0) statistics.mean_overlap = sum / static_cast<double>(statistics.contacts);
  return statistics;
}

/// Takes a contact into the statistics when it carries a force.
void Simulation::Parts::measure(const Contact& contact, ContactStatistics& statistics,
                                std::vector<double>& overlaps) const {
  const ContactPair pair{contact_body(state.materials[contact.first_material]),
                         contact_body(state.materials[contact.second_material])};
  const double force = NormalForce(parameters.contact, pair)(gap_of(state, contact));
  if (force <= 0) return;
  const double overlap = (pair.first.radius + pair.second.radius - contact.distance) / pair.mean_radius();
  overlaps.push_back(overlap);
  statistics.max_overlap = std::max(statistics.max_overlap, overlap);
  statistics.largest_force = std::max(statistics.largest_force, force);
}

PhaseTimes& Simulation::times() {
  return parts_->times;
}

}  // namespace fiberfate
