// Builds the report of the study orientation from the files of its result folder.

#include "studies/law_facts.hpp"
#include "studies/orientation/run.hpp"
#include "studies/sample/fiber_sections.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const OrientationCase& values) {
  FactsSection section{"asked", "Inputs", law_facts(diffusion_menu(), "Rotary diffusion", values.diffusion)};
  const std::vector<Fact> retardation = law_facts(retardation_menu(), "Retardation", values.retardation);
  section.rows.insert(section.rows.end(), retardation.begin(), retardation.end());
  const std::vector<Fact> melt = law_facts(viscosity_menu(), "Viscosity of the melt", values.melt);
  section.rows.insert(section.rows.end(), melt.begin(), melt.end());
  section.rows.push_back({"Closure", values.solution.closure});
  section.rows.push_back({"Shape factor", orientation_model(values).constants.xi});
  section.rows.push_back({"Velocity gradient at the start", gradient_history(values.flow).at(0), "1/s"});
  section.rows.push_back({"Orientation at the start", values.fibers.orientation});
  section.rows.push_back({"Duration", values.duration, "s"});
  return section;
}

FactsSection came_out(const OrientationCase& values, const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", {}};
  section.rows = {{"Orientation at the end", summary.tensor("A2")},
                  {"Strain", summary.number("strain")},
                  {"Rate of change at the end", summary.number("final_rate_per_s"), "1/s", "norm of DA/Dt"},
                  {"Steps", summary.count("steps")},
                  {"States returned to the admissible ones", summary.count("projections"), "",
                   "where the closure left them"}};
  if (values.solution.distribution == DistributionChoice::yes) {
    section.rows.push_back({"Orientation without closure", summary.tensor("distribution_A2")});
    section.rows.push_back(
        {"Error of the closure", summary.number("closure_error"), "", "norm of the difference"});
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

LinesSection components_section(const OrientationCase& values, const CsvTable& series) {
  LinesSection section = lines_over_time(
      "components", "Orientation tensor", {"component"}, series,
      {{"a11", "A_11"}, {"a22", "A_22"}, {"a33", "A_33"}, {"a12", "A_12"}, {"a13", "A_13"}, {"a23", "A_23"}});
  if (values.solution.distribution == DistributionChoice::no) return section;
  for (const char* name : {"11", "22", "33"})
    section.series.push_back({std::string("A_") + name + " without closure",
                              series.column(std::string("distribution_a") + name), CurveStyle::dashed});
  return section;
}

}  // namespace

ReportDocument report_orientation(const OrientationCase& values, const ResultFolder& folder) {
  ReportDocument document;
  document.title = "Fiber orientation";
  const SummaryFile summary(folder.summary());
  const CsvTable series = read_csv(folder.series());
  document.stop_reason = summary.text("stop_reason");
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(came_out(values, summary));
  document.sections.emplace_back(components_section(values, series));
  document.sections.emplace_back(
      lines_over_time("principal_values", "Principal values", {"principal value"}, series,
                      {{"principal_1", "first"}, {"principal_2", "second"}, {"principal_3", "third"}}));
  document.sections.emplace_back(lines_over_time("stretching", "Share of the flow that stretches fibers",
                                                 {"D:A4:D/D:D"}, series, {{"stretching_share", "share"}}));
  if (!values.melt.name.empty()) {
    document.sections.emplace_back(lines_over_time("stress", "Extra stress", {"stress", "Pa"}, series,
                                                   {{"stress_11_Pa", "tau_11"},
                                                    {"stress_22_Pa", "tau_22"},
                                                    {"stress_33_Pa", "tau_33"},
                                                    {"stress_12_Pa", "tau_12"},
                                                    {"stress_13_Pa", "tau_13"},
                                                    {"stress_23_Pa", "tau_23"}}));
    document.sections.emplace_back(
        lines_over_time("viscosity", "Viscosity", {"viscosity", "Pa s"}, series,
                        {{"viscosity_Pa_s", "matrix"}, {"effective_viscosity_Pa_s", "informed isotropic"}}));
  }
  return document;
}

}  // namespace fiberfate
