// The report of the study orientation from the files of its result folder.
#include "results/result_folder.hpp"
#include "studies/law_facts.hpp"
#include "studies/orientation/observables.hpp"
#include "studies/orientation/run.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const OrientationCase& values) {
  FactsSection section{"asked", "Inputs", law_facts(diffusion_menu(), "Rotary diffusion", values.diffusion)};
  append(section.rows, law_facts(retardation_menu(), "Retardation", values.retardation));
  append(section.rows, law_facts(viscosity_menu(), "Viscosity of the melt", values.melt));
  section.rows.push_back({"Closure", values.solution.closure});
  section.rows.push_back({"Shape factor", orientation_model(values).constants.xi});
  section.rows.push_back(
      {"Velocity gradient at the start", gradient_history(values.flow).at(0).gradient, "1/s"});
  section.rows.push_back({"Orientation at the start", values.fibers.orientation});
  section.rows.push_back({"Duration", values.run.duration, "s"});
  return section;
}

FactsSection came_out(const OrientationCase& values, const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", {}};
  section.rows = {
      {"Orientation at the end", summary.tensor("A2"), "", "", Prominence::headline},
      {"Strain", summary.number("strain"), "", "", Prominence::headline},
      {"Rate of change at the end", summary.number("final_rate_per_s"), "1/s", "norm of DA/Dt"},
      {"Steps", summary.count("steps")},
      {"Inadmissible tensors put back", summary.count("projections"), "", "where the closure left them"}};
  if (values.solution.distribution == DistributionChoice::yes) {
    section.rows.push_back(
        {"Orientation without closure", summary.tensor("distribution_A2"), "", "", Prominence::headline});
    section.rows.push_back(
        {"Error of the closure", summary.number("closure_error"), "", "norm of the difference"});
  }
  if (values.solution.steady == SteadyChoice::yes) {
    section.rows.push_back({"Steady state", summary.text("steady"), "", "of the flow at the end"});
    if (summary.text("steady") == "found") {
      section.rows.push_back({"Steady orientation", summary.tensor("steady_A2")});
      section.rows.push_back({"Slowest decay to it", summary.number("steady_decay_per_s"), "1/s"});
    }
  }
  if (!values.melt.name.empty()) {
    section.rows.push_back(
        {"Viscosity of the matrix", summary.number("viscosity_Pa_s"), "Pa s", "at the end"});
    section.rows.push_back(
        {"Informed-isotropic viscosity", summary.number("effective_viscosity_Pa_s"), "Pa s", "at the end"});
    section.rows.push_back({"Fiber term", summary.number("fiber_term"), "", "phi N_p"});
    section.rows.push_back({"Extra stress", summary.tensor("stress_Pa"), "Pa", "at the end"});
  }
  return section;
}

}  // namespace

ReportDocument report_orientation(const OrientationCase& values, const ResultFolder& folder) {
  const SummaryFile summary(folder.summary());
  ReportDocument document{"Fiber orientation"};
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(came_out(values, summary));
  append(document.sections,
         draw(orientation_charts(), orientation_observables(values), read_csv(folder.series())));
  return document;
}

}  // namespace fiberfate
