// Runs the study orientation: follows the orientation tensor.
#include "studies/orientation/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/fokker_planck.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"
#include "studies/law_facts.hpp"
#include "studies/orientation/observables.hpp"
#include "studies/orientation/states.hpp"
#include "studies/pace.hpp"
#include "studies/summary_tensors.hpp"

namespace fiberfate {
namespace {

/// Adds to a failure which keys help.
template <class Work>
void with_remedy(const char* remedy, const Work& work) {
  try {
    work();
  } catch (const SimulationFailure& failure) {
    throw SimulationFailure(fmt::format("{}: {}", failure.what(), remedy), {});
  }
}

/// Follows the distribution function from output to output.
class DistributionFollower {
 public:
  explicit DistributionFollower(const OrientationCase& values)
      : equation_(orientation_model(values), static_cast<int>(values.solution.degree)),
        history_(gradient_history(values.flow)),
        tolerance_{values.solution.tolerance, values.solution.tolerance},
        psi_(equation_.with_second_moment(values.fibers.orientation)) {}

  /// Gives A2 at a time not before the last one.
  [[nodiscard]] Mat3 advance_to(double time) {
    while (time_ < time) {
      const double end = std::min(time, history_.next_change(time_));
      const Mat3 gradient = history_.at(time_).gradient;
      if (!flow_ || flow_->gradient != gradient) flow_ = equation_.in_flow(gradient);
      equation_.advance(psi_, *flow_, end - time_, tolerance_);
      time_ = end;
    }
    return equation_.second_moment(psi_);
  }
  /// A4 where it is now.
  [[nodiscard]] Mat6 fourth() const { return equation_.fourth_moment(psi_); }

 private:
  FokkerPlanck equation_;
  FlowHistory history_;
  std::optional<FokkerPlanck::InFlow> flow_;
  IntegrationTolerance tolerance_;
  Eigen::VectorXd psi_;
  double time_ = 0;
};

/// Follows the tensor with all that is measured beside it.
class OrientationRun {
 public:
  explicit OrientationRun(const OrientationCase& values)
      : model_(orientation_model(values)),
        history_(gradient_history(values.flow)),
        integrator_(OrientationLaw(model_), history_, {0, values.fibers.orientation},
                    {values.solution.tolerance, values.solution.tolerance}) {
    if (values.solution.distribution == DistributionChoice::yes) distribution_.emplace(values);
    if (!values.melt.name.empty()) stress_.emplace(values);
  }

  [[nodiscard]] OrientationMoment advance_to(double time) {
    for (double at = time_; at < time; at = std::min(time, history_.next_change(at)))
      strain_ += history_.at(at).shear_rate() * (std::min(time, history_.next_change(at)) - at);
    time_ = time;
    with_remedy("raise solution.tolerance or lower run.duration", [&] { integrator_.advance_to(time); });
    const Flow flow = history_.at(time);
    OrientationMoment now{time, strain_, flow.shear_rate(), integrator_.state().second};
    const Mat6 fourth = close(now.second, model_.closure);
    now.principal = eigenframe(now.second).values;
    now.stretching_share = stretching_share(flow.rate_of_strain(), fourth);
    if (distribution_)
      with_remedy("raise solution.degree or solution.tolerance",
                  [&] { now.exact = distribution_->advance_to(time); });
    if (stress_) now.stress = stress_->at(flow, fourth);
    return now;
  }

  /// Adds to a summary what the last moment of a whole run tells.
  void summarise(const OrientationMoment& last, RunSummary& summary) const {
    summary.orientation = last.second;
    summary.steps = integrator_.record().accepted;
    if (distribution_)
      summary.own.insert(summary.own.end(), {{"distribution_A2", last.exact},
                                             {"distribution_A4", components(distribution_->fourth())},
                                             {"closure_error", (last.second - last.exact).norm()}});
    if (stress_)
      summary.own.insert(summary.own.end(),
                         {{"fiber_term", stress_->fiber_term()}, {"stress_Pa", last.stress.extra}});
    const double rate = OrientationLaw(model_).rate(last.second, history_.at(last.time).gradient).norm();
    summary.own.insert(summary.own.end(), {{"rejected_steps", integrator_.record().rejected},
                                           {"projections", integrator_.projections()},
                                           {"final_rate_per_s", rate}});
  }

 private:
  OrientationModel model_;
  FlowHistory history_;
  OrientationIntegrator integrator_;
  std::optional<DistributionFollower> distribution_;
  std::optional<StressEvaluator> stress_;
  double time_ = 0, strain_ = 0;
};

}  // namespace

double orientation_seconds(const OrientationCase& values) {
  const Observables<OrientationMoment> observables = orientation_observables(values);
  const Stopwatch making;
  OrientationRun run(values);
  const std::vector<double> times = series_times(values.run, values.output);
  const double made = making.elapsed() + seconds_a_row * static_cast<double>(times.size());
  Pace trial;
  for (const double time : with_early_times(times)) {
    static_cast<void>(measure(observables, run.advance_to(time)));
    trial.reached(time / values.run.duration);
    if (!trial.has_time()) break;
  }
  return made + trial.whole();
}

Outcome compute_orientation(const OrientationCase& values, Session& session) {
  require_memory(orientation_bytes(values), "take a lower solution.degree or fewer rows of output");
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  summary.simulated_s = values.run.duration;
  append_law(summary, {"", "diffusion"}, diffusion_menu(), values.diffusion);
  append_law(summary, {"", "retardation"}, retardation_menu(), values.retardation);
  summary.own.emplace_back("closure", values.solution.closure);
  summary.own.emplace_back("shape_factor", orientation_model(values).constants.xi);
  const Observables<OrientationMoment> observables = orientation_observables(values);
  CsvTable series{columns_of(observables)};
  OrientationRun run(values);
  OrientationMoment last;
  for (const double time : series_times(values.run, values.output)) {
    session.end_if_stopped("stopped; resuming begins again");
    series.append(measure(observables, last = run.advance_to(time)));
  }
  summarise(observables, last, summary);
  run.summarise(last, summary);
  summarise_ends(values, last.second, summary);
  if (values.solution.steady == SteadyChoice::yes) summarise_steady(values, session, summary);
  outcome.tables.push_back({"series", std::move(series)});
  const Vec3 diagonal = last.second.diagonal();
  outcome.headlines.push_back(fmt::format("a_11 {:.6f}, a_22 {:.6f}, a_33 {:.6f} after {:.4g} s", diagonal[0],
                                          diagonal[1], diagonal[2], values.run.duration));
  return outcome;
}

}  // namespace fiberfate
