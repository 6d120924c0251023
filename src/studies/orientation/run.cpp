// Runs the study orientation: follows the orientation tensor and writes it over time.
#include "studies/orientation/run.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "continuum/anisotropic_stress.hpp"
#include "continuum/fokker_planck.hpp"
#include "io/csv_table.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"
#include "studies/orientation/stress.hpp"

namespace fiberfate {
namespace {

/// Columns of tables, in the order of the particle level's series.
constexpr std::array component_names = {"11", "22", "33", "12", "13", "23"};

double rate_of(const Mat3& gradient) {
  const Mat3 strain_rate = 0.5 * (gradient + gradient.transpose());
  return std::sqrt(2 * double_dot(strain_rate, strain_rate));
}

CsvTable empty_series(const OrientationCase& values) {
  CsvTable series;
  series.columns = {"time_s", "strain", "rate_per_s"};
  for (const char* name : component_names) series.columns.push_back(std::string("a") + name);
  for (const char* name : {"1", "2", "3"}) series.columns.push_back(std::string("principal_") + name);
  series.columns.emplace_back("stretching_share");
  if (values.solution.distribution == DistributionChoice::yes)
    for (const char* name : component_names) series.columns.push_back(std::string("distribution_a") + name);
  if (!values.melt.name.empty())
    for (std::string& name : OrientationStress::columns()) series.columns.push_back(std::move(name));
  series.values.resize(series.columns.size());
  return series;
}

/// Follows the distribution function from output to output.
class DistributionFollower {
 public:
  explicit DistributionFollower(const OrientationCase& values)
      : equation_(orientation_model(values), static_cast<int>(values.solution.degree)),
        history_(gradient_history(values.flow)),
        tolerance_{values.solution.tolerance, values.solution.tolerance},
        psi_(equation_.with_second_moment(values.fibers.orientation)) {}

  [[nodiscard]] Mat3 advance_to(double time) {
    while (time_ < time) {
      const double end = std::min(time, history_.next_change(time_));
      equation_.advance(psi_, history_.at(time_), end - time_, tolerance_);
      time_ = end;
    }
    return equation_.second_moment(psi_);
  }

 private:
  FokkerPlanck equation_;
  GradientHistory history_;
  IntegrationTolerance tolerance_;
  Eigen::VectorXd psi_;
  double time_ = 0;
};

void append_components(std::vector<double>& row, const Mat3& a) {
  row.insert(row.end(), {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(0, 2), a(1, 2)});
}

/// Follows the orientation, appends to the series and returns the integrator at the end.
OrientationIntegrator follow(const OrientationCase& values, CsvTable& series, RunSummary& summary) {
  const OrientationModel model = orientation_model(values);
  const GradientHistory history = gradient_history(values.flow);
  OrientationIntegrator integrator(OrientationLaw(model), history, {0, values.fibers.orientation},
                                   {values.solution.tolerance, values.solution.tolerance});
  std::optional<DistributionFollower> distribution;
  if (values.solution.distribution == DistributionChoice::yes) distribution.emplace(values);
  std::optional<OrientationStress> stress;
  if (!values.melt.name.empty()) stress.emplace(values);
  double strain = 0, before = 0;
  Mat3 exact = Mat3::Zero();
  for (const double time : output_times(values)) {
    for (double at = before; at < time; at = std::min(time, history.next_change(at)))
      strain += rate_of(history.at(at)) * (std::min(time, history.next_change(at)) - at);
    before = time;
    integrator.advance_to(time);
    const Mat3& second = integrator.state().second;
    const Mat3& gradient = history.at(time);
    std::vector<double> row = {time, strain, rate_of(gradient)};
    append_components(row, second);
    const Vec3 principal = eigenframe(second).values;
    row.insert(row.end(), principal.begin(), principal.end());
    const Mat6 fourth = close(second, model.closure);
    row.push_back(stretching_share(0.5 * (gradient + gradient.transpose()), fourth));
    if (distribution) append_components(row, exact = distribution->advance_to(time));
    if (stress) stress->append(gradient, fourth, row);
    for (std::size_t i = 0; i < row.size(); ++i) series.values[i].push_back(row[i]);
  }
  summary.own.emplace_back("strain", strain);
  if (distribution) {
    summary.own.emplace_back("distribution_A2", exact);
    summary.own.emplace_back("closure_error", (integrator.state().second - exact).norm());
  }
  if (stress) stress->append(summary);
  return integrator;
}

void append_law(RunSummary& summary, const std::string& key, const LawMenu& menu, const LawChoice& choice) {
  summary.own.emplace_back(key, choice.name);
  const LawMenuItem& law = *chosen_law(menu, choice);
  const std::vector<double> values = law_values(menu, choice);
  for (std::size_t i = 0; i < values.size(); ++i) summary.own.emplace_back(law.parameters[i].name, values[i]);
}

}  // namespace

Outcome compute_orientation(const OrientationCase& values, Session& session) {
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  summary.simulated_s = values.duration;
  append_law(summary, "diffusion", diffusion_menu(), values.diffusion);
  append_law(summary, "retardation", retardation_menu(), values.retardation);
  summary.own.emplace_back("closure", values.solution.closure);
  summary.own.emplace_back("shape_factor", orientation_model(values).constants.xi);
  CsvTable series = empty_series(values);
  const OrientationIntegrator integrator = follow(values, series, summary);
  const Mat3& second = integrator.state().second;
  const Mat3 gradient = gradient_history(values.flow).at(values.duration);
  const OrientationLaw law(orientation_model(values));
  summary.orientation = second;
  summary.steps = integrator.record().accepted;
  summary.own.emplace_back("rejected_steps", integrator.record().rejected);
  summary.own.emplace_back("projections", integrator.projections());
  summary.own.emplace_back("final_rate_per_s", law.rate(second, gradient).norm());
  outcome.tables.push_back({"series", std::move(series)});
  session.recorder().note(fmt::format("A11 {:.6f}, A22 {:.6f}, A33 {:.6f} after {:.4g} s", second(0, 0),
                                      second(1, 1), second(2, 2), values.duration));
  return outcome;
}

}  // namespace fiberfate
