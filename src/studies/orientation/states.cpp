// What summary.json tells of single states of the study orientation.
#include "studies/orientation/states.hpp"

#include "base/error.hpp"
#include "continuum/fokker_planck.hpp"
#include "continuum/orientation_steady.hpp"
#include "microstructure/closure.hpp"
#include "studies/summary_tensors.hpp"

namespace fiberfate {
namespace {

void add_steady(const OrientationCase& values, RunSummary& summary) {
  const OrientationModel model = orientation_model(values);
  const Mat3 gradient = gradient_history(values.flow).at(values.run.duration).gradient;
  const SteadyOrientation steady = steady_orientation(model, gradient);
  summary.own.insert(summary.own.end(), {{"steady_A2", steady.second},
                                         {"steady_A4", components(close(steady.second, model.closure))},
                                         {"steady_decay_per_s", steady.decay_rate}});
  if (values.solution.distribution == DistributionChoice::no) return;
  const FokkerPlanck equation(model, static_cast<int>(values.solution.degree));
  summary.own.emplace_back("steady_distribution_A2", equation.second_moment(equation.steady(gradient)));
}

}  // namespace

void summarise_ends(const OrientationCase& values, const Mat3& last, RunSummary& summary) {
  const OrientationLaw law(orientation_model(values));
  const FlowHistory history = gradient_history(values.flow);
  const auto add = [&](const std::string& which, const Mat3& second, double time) {
    summary.own.emplace_back("A4" + which, components(close(second, law.model().closure)));
    summary.own.emplace_back("A2_rate" + which + "_per_s", law.rate(second, history.at(time).gradient));
  };
  summary.own.emplace_back("A2_start", values.fibers.orientation);
  add("_start", values.fibers.orientation, 0);
  add("", last, values.run.duration);
}

void summarise_steady(const OrientationCase& values, Session& session, RunSummary& summary) {
  std::string fault;
  try {
    add_steady(values, summary);
  } catch (const InputError& error) {
    fault = error.what();
  } catch (const SimulationFailure& error) {
    fault = error.what();
  }
  summary.own.emplace_back("steady", fault.empty() ? "found" : fault);
  if (!fault.empty()) session.recorder().warn(fault);
}

}  // namespace fiberfate
