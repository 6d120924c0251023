// Foretells how long a shear_cell run takes.
#include "studies/shear_cell/effort.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "dynamics/simulation.hpp"
#include "fibers/observables.hpp"
#include "results/memory_recorder.hpp"
#include "studies/pace.hpp"
#include "studies/sample/crowd.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/sample/start.hpp"

namespace fiberfate {
namespace {

// Strain of the steps to which contacts hold error control down: it falls with the number of fibers within
// reach of a fiber, volume fraction times squared aspect ratio, and grows as fibers align and break. Measured
// on the cases 00, 04, 05 and 06 and on variations of them, within a factor of 1.8.
constexpr double strain_a_step = 8.7;
constexpr double growth_with_strain = 0.2;

/// The share of the duration that stands for all of it.
constexpr double telling_share = 0.05;

/// The trial of a run's own first steps.
struct Trial {
  Pace pace{0.15};
  double seconds_a_rod_step = 0;
  double rods = 0;
  Crowding crowding;
};

Trial try_out(const ShearCellCase& values, Session& session) {
  Trial trial;
  const FlowHistory flow = flow_history(values.flow);
  StartingFibers fibers = make_fibers(
      values.sample, {values.dynamics.contact, values.boundary.y, values.run.seed, &flow}, session);
  Simulation simulation(dynamics_parameters(values), flow, std::move(fibers.state));
  const double begin = simulation.state().time;
  const Stopwatch watch;
  const double end = begin + values.run.duration;
  while (trial.pace.has_time() && simulation.state().time < end) {
    simulation.advance(end);
    trial.pace.reached((simulation.state().time - begin) / values.run.duration);
  }
  const auto work = static_cast<double>(std::max<std::int64_t>(simulation.state().rod_steps, 1));
  trial.seconds_a_rod_step = watch.elapsed() / work;
  trial.rods = static_cast<double>(simulation.state().rod_count());
  trial.crowding = {volume_fraction(simulation.state()), mean_lengths(simulation.state()).number_average /
                                                             simulation.state().materials.front().diameter()};
  return trial;
}

}  // namespace

double expected_steps(const ShearCellCase& values, const Crowding& fibers) {
  const StepParameters& step = values.dynamics.step;
  const double duration = values.run.duration;
  if (step.control == StepControl::fixed) return duration / step.initial;
  const double strain = total_strain(flow_history(values.flow), duration);
  const double within_reach = fibers.volume_fraction * fibers.aspect_ratio * fibers.aspect_ratio;
  const double by_contact =
      within_reach * strain / (strain_a_step * std::pow(std::max(strain, 1.0), growth_with_strain));
  return std::max(strain / step.maximum_strain, duration / step.maximum) + by_contact;
}

Crowding crowding(const ShearCellCase& values, const SamplePlan& plan) {
  const bool alone = values.sample.cluster.source == ClusterSource::fiber;
  const FiberKind& kind = values.sample.fibers;
  return {alone ? 0.0 : plan.volume_fraction, alone ? 1.0 : number_average(length_law(kind)) / kind.diameter};
}

namespace {

double computing_seconds(const ShearCellCase& values, const std::optional<SamplePlan>& plan) {
  MemoryRecorder recorder;
  Session session(recorder);
  session.use_threads(values.run.threads);
  const bool packs = values.sample.cluster.source == ClusterSource::generate;
  if (packs && plan->rods > most_rods_to_pack) {
    const double rod_step = seconds_a_rod_step(values.sample, values.dynamics.contact, values.run.seed);
    return packing_seconds(values.sample, {values.dynamics.contact, values.boundary.y, values.run.seed},
                           *plan, rod_step) +
           expected_steps(values, crowding(values, *plan)) * static_cast<double>(plan->rods) * rod_step;
  }
  const Trial trial = try_out(values, session);
  // The first steps are short: they tell the rest where they are a part of it, or where nothing holds steps
  // down.
  const bool alone = values.sample.cluster.source == ClusterSource::fiber;
  if (alone || trial.pace.share() > telling_share) return trial.pace.whole();
  return expected_steps(values, trial.crowding) * trial.rods * trial.seconds_a_rod_step;
}

}  // namespace

double shear_cell_seconds(const ShearCellCase& values, const std::optional<SamplePlan>& plan) {
  const double duration = values.run.duration;
  return computing_seconds(values, plan) + seconds_a_frame * duration / frame_interval(values) +
         seconds_a_row * duration / series_interval(values.run, values.output);
}

}  // namespace fiberfate
