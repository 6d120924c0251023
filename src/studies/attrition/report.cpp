// The report of the study attrition from the files of its result folder.
#include <fmt/format.h>

#include "results/result_folder.hpp"
#include "studies/attrition/observables.hpp"
#include "studies/attrition/run.hpp"
#include "studies/law_facts.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const AttritionCase& values) {
  FactsSection section{"asked", "Inputs", law_facts(attrition_menu(), "Law", values.law)};
  append(section.rows, law_facts(attrition_menu(), "Compared with", values.compared));
  append(section.rows, law_facts(viscosity_menu(), "Viscosity of the melt", values.melt));
  if (values.flow.kind == AttritionFlow::couette)
    section.rows.push_back({"Couette rheometer", values.flow.speed.value_or(0), "rpm"});
  section.rows.push_back({"Duration", values.run.duration, "s"});
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
  const SummaryFile summary(folder.summary());
  ReportDocument document{"Fiber attrition"};
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(came_out(summary));
  append(document.sections,
         draw(length_charts(), joined<LengthMoment>({length_observables(), compared_observables(values)}),
              read_csv(folder.series())));
  const CsvTable histogram = read_csv(folder.file("histogram.csv"));
  if (histogram.rows() > 0) document.sections.emplace_back(histogram_section(histogram));
  return document;
}

}  // namespace fiberfate
