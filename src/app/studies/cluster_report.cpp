// Builds the report of the study cluster from the files of its result folder.
#include <filesystem>

#include "app/studies/cluster_run.hpp"
#include "app/studies/fiber_sections.hpp"
#include "base/version.hpp"

namespace fiberfate {
namespace {

constexpr double length_bins = 40;

FactsSection asked(const ClusterCase& values) {
  FactsSection section{"asked", "What was asked", sample_facts(values.sample)};
  section.rows.push_back({"Overlap allowed", values.sample.cluster.overlap_tolerance, "diameters"});
  section.rows.push_back({"Seed", static_cast<std::int64_t>(values.seed)});
  return section;
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "What came out", outcome_facts(summary)};
  section.rows.insert(section.rows.end(),
                      {{"Orientation error", summary.number("orientation_error"), "", "largest component"},
                       {"Largest overlap", summary.number("max_overlap_diameters"), "diameters"},
                       {"Mean curvature", summary.number("mean_curvature_per_m"), "1/m"},
                       {"Contacts a fiber, placed at random", summary.number("contacts_per_fiber_random")},
                       {"Packing steps", summary.count("packing_steps")}});
  return section;
}

LinesSection pair_section(const SummaryFile& summary) {
  LinesSection section{
      "pair_distances", "Neighbours by distance", {"axis distance", "diameters"}, {"places a fiber"}, {}, {}};
  const std::vector<double> low = summary.numbers("pair_distance_low_diameters");
  const std::vector<double> high = summary.numbers("pair_distance_high_diameters");
  for (std::size_t i = 0; i < low.size(); ++i) section.x_values.push_back(0.5 * (low[i] + high[i]));
  section.series = {
      {"this packing", summary.numbers("pair_distance_per_fiber")},
      {"placed at random", summary.numbers("pair_distance_per_fiber_random"), CurveStyle::dashed}};
  section.caption =
      "Places along a fiber where another one passes, beside the theory of fibers placed at random.";
  return section;
}

}  // namespace

ReportDocument report_cluster(const ClusterCase& values, const ResultFolder& folder) {
  ReportDocument document;
  document.title = "A packing of fibers";
  document.subtitle = std::filesystem::path(folder.path()).filename().string();
  document.study = "cluster";
  document.version = version;
  const SummaryFile summary(folder.summary());
  document.stop_reason = summary.text("stop_reason");
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(came_out(summary));
  if (!summary.numbers("pair_distance_low_diameters").empty())
    document.sections.emplace_back(pair_section(summary));
  const VtkhdfReader frames(folder.frames());
  const std::vector<double> times = {0.0};
  const double bin = 2 * summary.number("L_W_m") / length_bins;
  document.sections.emplace_back(length_section(frames, times, bin));
  document.sections.emplace_back(curvature_section(frames, times));
  document.sections.emplace_back(fibers_section(frames, ""));
  document.sections.emplace_back(effort_section(summary));
  return document;
}

}  // namespace fiberfate
