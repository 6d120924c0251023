// The report of the study shear_cell from the files of its result folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/law_choice.hpp"
#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "fibers/contact_laws/contact_registry.hpp"
#include "studies/sample/cell_section.hpp"
#include "studies/sample/fiber_sections.hpp"
#include "studies/shear_cell/observables.hpp"
#include "studies/shear_cell/run.hpp"

namespace fiberfate {
namespace {

/// Names a type of flow in a report.
const char* name(FlowType type) {
  switch (type) {
    case FlowType::planar:
      return "planar elongation";
    case FlowType::uniaxial:
      return "uniaxial elongation";
    case FlowType::biaxial:
      return "biaxial elongation";
    case FlowType::mixed:
      return "mixed planar flow";
    case FlowType::gradient:
      return "by velocity gradient";
    default:
      return "simple shear";
  }
}

/// What the axes of the picture are.
const char* axes_of(FlowType type) {
  switch (type) {
    case FlowType::planar:
      return "Stretched along x, shortened along y.";
    case FlowType::uniaxial:
      return "Stretched along x, shortened along y and z.";
    case FlowType::biaxial:
      return "Stretched along x and y, shortened along z.";
    case FlowType::gradient:
      return "";
    default:
      return "Flow along x, gradient along y.";
  }
}

void append_flow(std::vector<Fact>& facts, const FlowChoices& flow) {
  facts.push_back({"Flow", std::string(name(flow.type))});
  if (flow.kind == FlowKind::table) {
    const std::size_t rows = std::max(flow.table.size(), flow.gradient_table.size());
    facts.push_back({"Flow over time", fmt::format("table of {} intervals", rows)});
    return;
  }
  const bool is_shear = flow.type == FlowType::shear;
  if (flow.rate) facts.push_back({is_shear ? "Shear rate" : "Rate", *flow.rate, "1/s"});
  facts.push_back({"Matrix viscosity", flow.viscosity.value_or(0), "Pa s"});
  if (is_shear)
    facts.push_back({"Shear stress of the matrix", flow.rate.value_or(0) * flow.viscosity.value_or(0), "Pa"});
  if (flow.type == FlowType::mixed) facts.push_back({"alpha", flow.alpha});
  if (flow.kind == FlowKind::ramp)
    facts.push_back({"Ramp", fmt::format("{} steps in {:.4g} s", flow.ramp_steps, flow.ramp_duration)});
  if (flow.kind == FlowKind::oscillation) facts.push_back({"Period", flow.period.value_or(0), "s"});
}

void append_breakage(std::vector<Fact>& facts, const BreakageParameters& breakage) {
  facts.push_back({"Breakage", breakage.law});
  const BreakageRow& law = breakage_law_named(breakage.law);
  const double certain = law.certain_radius(breakage), onset = law.onset_radius(breakage);
  if (onset == 0) return;
  if (certain == onset) {
    facts.push_back({"Critical radius", certain, "m"});
    return;
  }
  facts.push_back({"Every hinge breaks at and below", certain, "m"});
  facts.push_back({"No hinge breaks above", onset, "m"});
}

void append_contact(std::vector<Fact>& facts, const ContactParameters& contact) {
  facts.push_back({"Contact", contact.law});
  if (reads_constant(contact_law_named(contact.law).text, "force_constant"))
    facts.push_back({"Contact force constant", contact.force_constant, "N/m"});
}

FactsSection asked(const ShearCellCase& values) {
  FactsSection section{"asked", "Inputs", sample_facts(values.sample)};
  append_flow(section.rows, values.flow);
  section.rows.push_back({"Duration", values.run.duration, "s"});
  section.rows.push_back(
      {"Boundary in y", std::string(values.boundary.y == Boundary::walls ? "walls" : "periodic")});
  section.rows.push_back({"Drag", values.dynamics.drag});
  append_contact(section.rows, values.dynamics.contact);
  section.rows.push_back({"Friction", values.dynamics.contact.friction_law});
  section.rows.push_back({"Friction coefficient", values.dynamics.contact.friction});
  section.rows.push_back({"Bending", values.dynamics.hinge});
  append_breakage(section.rows, values.dynamics.breakage);
  section.rows.push_back({"Seed", std::to_string(values.run.seed)});
  return section;
}

/// A mean over the stationary part in a summary.
struct MeanKeys {
  const char *label, *mean, *error, *unit;
};
constexpr MeanKeys means[] = {
    {"Relative viscosity", "relative_viscosity_mean", "relative_viscosity_error", ""},
    {"Elongational viscosity", "elongational_viscosity_mean_Pa_s", "elongational_viscosity_error_Pa_s",
     "Pa s"},
    {"First normal stress difference", "N1_mean_Pa", "N1_error_Pa", "Pa"},
    {"Second normal stress difference", "N2_mean_Pa", "N2_error_Pa", "Pa"}};

/// The mean over the stationary part with its standard error.
void append_mean(std::vector<Fact>& facts, const SummaryFile& summary, const MeanKeys& keys) {
  const double mean = summary.number(keys.mean), error = summary.number(keys.error);
  if (!std::isfinite(mean)) return;
  const std::string note =
      std::isfinite(error) && mean != 0 ? fmt::format("± {:.2g} %", 100 * std::abs(error / mean)) : "";
  facts.push_back({std::string(keys.label) + ", mean", mean, keys.unit, note});
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", outcome_facts(summary)};
  section.rows.insert(section.rows.begin(), {{"Simulated time", summary.number("simulated_s"), "s"},
                                             {"Strain", summary.number("strain")},
                                             {"Breaks", summary.count("breaks")}});
  section.rows.push_back({"Largest overlap at the end", summary.number("max_overlap_radii"), "radii"});
  for (const MeanKeys& keys : means) append_mean(section.rows, summary, keys);
  return section;
}

bool has_numbers(const LinesSection& section) {
  return std::any_of(section.series.begin(), section.series.end(), [](const ReportSeries& one) {
    return std::any_of(one.values.begin(), one.values.end(),
                       [](double value) { return std::isfinite(value); });
  });
}

/// The charts that tell something of this flow: an elongation has no shear stress, and without readings there
/// is none.
std::vector<LinesSection> charts(FlowType type, const CsvTable& series) {
  const bool shears = type != FlowType::planar && type != FlowType::uniaxial && type != FlowType::biaxial;
  std::vector<LinesSection> sections = draw(cell_charts(), cell_observables(), series);
  std::erase_if(sections, [&](const LinesSection& section) {
    const bool of_other_flows = (section.id == "shear_causes" && !shears) ||
                                (section.id == "stretch_causes" && type == FlowType::shear);
    return of_other_flows || !has_numbers(section);
  });
  return sections;
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
  ReportDocument document{values.flow.type == FlowType::shear ? "Fibers in a sheared cell"
                                                              : "Fibers in a flowing cell"};
  document.sections.emplace_back(asked(values));
  const std::optional<SummaryFile> summary = read_summary(folder.summary());
  if (summary) document.sections.emplace_back(came_out(*summary));
  const CsvTable series = read_csv(folder.series());
  append(document.sections, charts(values.flow.type, series));
  const VtkhdfReader frames(folder.frames());
  const std::vector<double> times = histogram_times(values, frames);
  document.sections.emplace_back(length_section(frames, times, values.output.length_bin));
  document.sections.emplace_back(curvature_section(frames, times));
  const CsvTable breaks = read_csv(folder.breaks());
  if (breaks.rows() > 0) document.sections.emplace_back(break_radius_section(values, breaks));
  document.sections.emplace_back(
      fibers_section(frames, axes_of(values.flow.type), read_cell_history(series, breaks)));
  if (summary) document.sections.emplace_back(effort_section(*summary));
  return document;
}

}  // namespace fiberfate
