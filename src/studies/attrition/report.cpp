// Builds the report of the study attrition from the files of its result folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/attrition/run.hpp"
#include "studies/law_facts.hpp"
#include "studies/sample/fiber_sections.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const AttritionCase& values) {
  FactsSection section{"asked", "Inputs", law_facts(attrition_menu(), "Law", values.law)};
  const auto append = [&section](const std::vector<Fact>& facts) {
    section.rows.insert(section.rows.end(), facts.begin(), facts.end());
  };
  append(law_facts(attrition_menu(), "Compared with", values.compared));
  append(law_facts(viscosity_menu(), "Viscosity of the melt", values.melt));
  if (values.flow.kind == AttritionFlow::couette)
    section.rows.push_back({"Couette rheometer", values.flow.speed.value_or(0), "rpm"});
  section.rows.push_back({"Duration", values.duration, "s"});
  return section;
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", {}};
  section.rows = {
      {"L_N at the start", summary.number("L_N_start_m"), "m"},
      {"L_W at the start", summary.number("L_W_start_m"), "m"},
      {"L_N at the end", summary.number("L_N_end_m"), "m"},
      {"L_W at the end", summary.number("L_W_end_m"), "m"},
      {"Unbreakable length", summary.number("unbreakable_length_m"), "m", "in the flow at the end"},
      {"k_f", summary.number("rate_constant_per_s"), "1/s", "at the end"},
      {"Shear rate", summary.number("rate_per_s"), "1/s", "at the end"},
      {"Viscosity", summary.number("viscosity_Pa_s"), "Pa s", "at the end"},
      {"Shear stress", summary.number("shear_stress_Pa"), "Pa", "at the end"},
      {"Fibers at the end for each at the start", summary.number("fiber_growth")},
      {"Relative change of the total fiber length", summary.number("total_length_change")}};
  return section;
}

LinesSection lengths_section(const AttritionCase& values, const CsvTable& series) {
  std::vector<Curve> curves = {{"L_N_m", "L_N"}, {"L_W_m", "L_W"}};
  curves.push_back({"unbreakable_length_m", "unbreakable", CurveStyle::dashed});
  LinesSection section =
      lines_over_time("mean_lengths", "Mean fiber lengths", {"length", "m"}, series, curves);
  if (values.compared.name.empty()) return section;
  section.series.push_back(
      {"L_N, " + values.compared.name, series.column("compared_L_N_m"), CurveStyle::dashed});
  section.series.push_back(
      {"L_W, " + values.compared.name, series.column("compared_L_W_m"), CurveStyle::dashed});
  return section;
}

HistogramSection histogram_section(const CsvTable& table) {
  HistogramSection section{"histogram", "Fibers by length", {"length", "m"}, {"share of the fibers", "%"}, {},
                           {}};
  const std::vector<double>& times = table.column("time_s");
  const std::vector<double>& low = table.column("length_low_m");
  const std::vector<double>& high = table.column("length_high_m");
  const std::vector<double>& share = table.column("number_share");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i == 0 || times[i] != times[i - 1]) section.frames.push_back({fmt::format("{:.4g} s", times[i]), {}});
    section.frames.back().values.push_back(100 * share[i]);
    if (section.frames.size() > 1) continue;
    if (i == 0) section.edges.push_back(low[i]);
    section.edges.push_back(high[i]);
  }
  return section;
}

}  // namespace

ReportDocument report_attrition(const AttritionCase& values, const ResultFolder& folder) {
  ReportDocument document;
  document.title = "Fiber attrition";
  const SummaryFile summary(folder.summary());
  const CsvTable series = read_csv(folder.series());
  document.stop_reason = summary.text("stop_reason");
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(came_out(summary));
  document.sections.emplace_back(lengths_section(values, series));
  document.sections.emplace_back(
      lines_over_time("stress", "Shear stress", {"stress", "Pa"}, series, {{"shear_stress_Pa", "stress"}}));
  const CsvTable histogram = read_csv(folder.file("histogram.csv"));
  if (histogram.rows() > 0) document.sections.emplace_back(histogram_section(histogram));
  return document;
}

}  // namespace fiberfate
