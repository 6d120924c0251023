// Builds the report of the study shear_cell from the files of its result folder.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "studies/sample/cell_section.hpp"
#include "studies/sample/fiber_sections.hpp"
#include "studies/shear_cell/run.hpp"
#include "studies/shear_cell/series.hpp"

namespace fiberfate {
namespace {

const char* name(BreakageLaw law) {
  switch (law) {
    case BreakageLaw::none:
      return "none";
    case BreakageLaw::fixed:
      return "fixed";
    case BreakageLaw::probability:
      return "probability";
    case BreakageLaw::strength:
      return "strength";
  }
  return "";
}

const char* name(DragLaw law) {
  switch (law) {
    case DragLaw::beads:
      return "beads";
    case DragLaw::beads_integer:
      return "beads_integer";
    case DragLaw::ellipsoid:
      return "ellipsoid";
  }
  return "";
}

void append_flow(std::vector<Fact>& facts, const FlowChoices& flow) {
  if (flow.kind == FlowKind::table) {
    facts.push_back({"Flow", fmt::format("table of {} intervals", flow.table.size())});
    return;
  }
  facts.push_back({"Shear rate", flow.rate.value_or(0), "1/s"});
  facts.push_back({"Matrix viscosity", flow.viscosity.value_or(0), "Pa s"});
  facts.push_back({"Shear stress of the matrix", flow.rate.value_or(0) * flow.viscosity.value_or(0), "Pa"});
  if (flow.kind == FlowKind::ramp)
    facts.push_back({"Ramp", fmt::format("{} steps in {:.4g} s", flow.ramp_steps, flow.ramp_duration)});
}

void append_breakage(std::vector<Fact>& facts, const BreakageParameters& breakage) {
  facts.push_back({"Breakage", std::string(name(breakage.law))});
  if (breakage.law == BreakageLaw::fixed) facts.push_back({"Critical radius", breakage.critical_radius, "m"});
  if (breakage.law == BreakageLaw::probability || breakage.law == BreakageLaw::strength) {
    facts.push_back({"Every hinge breaks at radius", breakage.minimum_radius, "m"});
    facts.push_back({"No hinge breaks above radius", breakage.maximum_radius, "m"});
  }
}

FactsSection asked(const ShearCellCase& values) {
  FactsSection section{"asked", "Inputs", sample_facts(values.sample)};
  append_flow(section.rows, values.flow);
  section.rows.push_back({"Duration", values.run.duration, "s"});
  section.rows.push_back(
      {"Boundary in y", std::string(values.boundary_y == Boundary::walls ? "walls" : "periodic")});
  section.rows.push_back({"Drag", std::string(name(values.dynamics.drag))});
  section.rows.push_back({"Contact force constant", values.dynamics.contact.force_constant, "N/m"});
  section.rows.push_back({"Friction coefficient", values.dynamics.contact.friction});
  append_breakage(section.rows, values.dynamics.breakage);
  section.rows.push_back({"Seed", static_cast<std::int64_t>(values.dynamics.seed)});
  return section;
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", outcome_facts(summary)};
  section.rows.insert(section.rows.begin(), {{"Simulated time", summary.number("simulated_s"), "s"},
                                             {"Shear strain", summary.number("strain")},
                                             {"Breaks", summary.count("breaks")}});
  return section;
}

void append_curves(std::vector<ReportSection>& sections, const CsvTable& series) {
  sections.emplace_back(lines_over_time("mean_lengths", "Mean fiber lengths", {"length", "m"}, series,
                                        {{"L_N_m", "L_N"}, {"L_W_m", "L_W"}}));
  sections.emplace_back(lines_over_time("orientation", "Orientation", {"component of A_2"}, series,
                                        {{"a11", "a_11"},
                                         {"a22", "a_22"},
                                         {"a33", "a_33"},
                                         {"a12", "a_12", CurveStyle::dashed},
                                         {"a13", "a_13", CurveStyle::dashed},
                                         {"a23", "a_23", CurveStyle::dashed}}));
  sections.emplace_back(
      lines_over_time("breaks", "Breaks", {"breaks so far"}, series, {{"breaks", "breaks"}}));
  sections.emplace_back(lines_over_time("near_critical", "Hinges near breaking", {"hinges"}, series,
                                        {{"near_critical_hinges", "near critical"}}));
  sections.emplace_back(lines_over_time("contacts", "Contacts", {"contacts a fiber"}, series,
                                        {{"contacts_per_fiber", "contacts"}}));
  sections.emplace_back(lines_over_time("overlap", "Overlap of fibers in contact", {"overlap", "radii"},
                                        series,
                                        {{"max_overlap_radii", "largest"}, {"mean_overlap_radii", "mean"}}));
  sections.emplace_back(lines_over_time("dissipation", "Power dissipated by drag", {"power", "W/m3"}, series,
                                        {{"drag_power_W_per_m3", "fibers"}}));
  sections.emplace_back(lines_over_time("step", "Step size", {"step", "s", AxisScale::logarithmic}, series,
                                        {{"dt_s", "step"}}));
  sections.emplace_back(
      lines_over_time("flow", "Shear rate", {"rate", "1/s"}, series, {{"rate_per_s", "rate"}}));
}

HistogramSection break_radius_section(const ShearCellCase& values, const CsvTable& breaks) {
  const std::vector<double>& radii = breaks.column("radius_m");
  const double largest = radii.empty() ? critical_radius(values.dynamics.breakage)
                                       : *std::max_element(radii.begin(), radii.end());
  HistogramSection section{"break_radii",
                           "Radius of curvature at breaks",
                           {"radius", "m"},
                           {"breaks"},
                           bin_edges(largest, values.output.radius_bin),
                           {}};
  section.frames.push_back({"all breaks", counts(radii, section.edges)});
  return section;
}

std::vector<double> histogram_times(const ShearCellCase& values, const VtkhdfReader& frames) {
  std::vector<double> times = values.output.histogram_times;
  times.insert(times.end(), {frames.times().front(), frames.times().back()});
  return times;
}

}  // namespace

ReportDocument report_shear_cell(const ShearCellCase& values, const ResultFolder& folder) {
  ReportDocument document;
  document.title = "Fibers in a sheared cell";
  document.stop_reason = "unfinished";
  document.sections.emplace_back(asked(values));
  const bool finished = std::filesystem::exists(folder.summary());
  if (finished) {
    const SummaryFile summary(folder.summary());
    document.stop_reason = summary.text("stop_reason");
    document.sections.emplace_back(came_out(summary));
  }
  const CsvTable series = read_csv(folder.series());
  append_curves(document.sections, series);
  const VtkhdfReader frames(folder.frames());
  const std::vector<double> times = histogram_times(values, frames);
  document.sections.emplace_back(length_section(frames, times, values.output.length_bin));
  document.sections.emplace_back(curvature_section(frames, times));
  const CsvTable breaks = read_csv(folder.breaks());
  if (breaks.rows() > 0) document.sections.emplace_back(break_radius_section(values, breaks));
  document.sections.emplace_back(
      fibers_section(frames, "Flow along x, gradient along y.", read_cell_history(series, breaks)));
  if (finished) document.sections.emplace_back(effort_section(SummaryFile(folder.summary())));
  return document;
}

}  // namespace fiberfate
