// Builds the report of the study cluster from the files of its result folder.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "results/fiber_frame.hpp"
#include "studies/cluster/pictures.hpp"
#include "studies/cluster/run.hpp"
#include "studies/sample/cell_section.hpp"
#include "studies/sample/fiber_sections.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const ClusterCase& values) {
  FactsSection section{"asked", "Inputs", sample_facts(values.sample)};
  section.rows.push_back(
      {"Weight of curvature", values.sample.cluster.weights.curvature, "", "against overlap"});
  section.rows.push_back(
      {"Weight of orientation", values.sample.cluster.weights.orientation, "", "against overlap"});
  section.rows.push_back({"Seed", std::to_string(values.run.seed)});
  return section;
}

std::string percent(double fraction) {
  return fmt::format("{:.5g} %", 100 * fraction);
}

std::string millimetres(double length) {
  return fmt::format("{:.5g} mm", 1e3 * length);
}

std::string micrometres(double radius) {
  return std::isnan(radius) ? "straight" : fmt::format("{:.4g} µm", 1e6 * radius);
}

/// Sets the lengths and shares of several kinds side by side.
void add_kinds(TableSection& table, const SummaryFile& summary) {
  const std::vector<double> fibers = summary.numbers("kind_fibers");
  const auto pair = [&](std::size_t kind, const char* what, const std::string& key, const std::string& unit,
                        const auto& write) {
    table.rows.push_back({fmt::format("Kind {}: {}", kind + 1, what),
                          write(summary.numbers(key + "_asked" + unit).at(kind)),
                          write(summary.numbers(key + unit).at(kind))});
  };
  for (std::size_t kind = 0; kind < fibers.size(); ++kind) {
    pair(kind, "L_N", "kind_L_N", "_m", millimetres);
    pair(kind, "L_W", "kind_L_W", "_m", millimetres);
    pair(kind, "share of the fibers' volume", "kind_volume_share", "", percent);
  }
}

/// Sets what was asked beside what came out.
TableSection comparison(const ClusterCase& values, const SummaryFile& summary) {
  const SampleCase& sample = values.sample;
  TableSection table{"comparison", "Asked and achieved", {{"quantity"}, {"asked"}, {"achieved"}}, {}};
  const auto add = [&table](const std::string& what, const std::string& asked, const std::string& achieved) {
    table.rows.push_back({what, asked, achieved});
  };
  if (!std::isnan(summary.number("L_N_asked_m"))) {
    add("L_N", millimetres(summary.number("L_N_asked_m")), millimetres(summary.number("L_N_m")));
    add("L_W", millimetres(summary.number("L_W_asked_m")), millimetres(summary.number("L_W_m")));
  }
  add_kinds(table, summary);
  if (sample.fibers.weight_fraction)
    add("Weight fraction", percent(*sample.fibers.weight_fraction),
        percent(weight_from_volume_fraction(summary.number("volume_fraction"), mean_density(species(sample)),
                                            sample.matrix.density.value_or(0))));
  if (sample.fibers.volume_fraction)
    add("Volume fraction", percent(*sample.fibers.volume_fraction),
        percent(summary.number("volume_fraction")));
  if (sample.fibers.count)
    add("Fibers", fmt::format("{}", *sample.fibers.count), fmt::format("{}", summary.count("fibers")));
  const Mat3 wanted = summary.tensor("A2_asked"), reached = summary.tensor("A2");
  const auto component = [](double value) {
    return fmt::format("{:.5f}", std::abs(value) < 5e-6 ? 0 : value);
  };
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}})
    add(fmt::format("a_{}{}", i + 1, j + 1), component(wanted(i, j)), component(reached(i, j)));
  add("Largest overlap", fmt::format("{:.3g} D", sample.cluster.overlap_tolerance),
      fmt::format("{:.3g} D", summary.number("max_overlap_diameters")));
  add("Smallest radius of curvature",
      sample.cluster.minimum_radius > 0 ? micrometres(sample.cluster.minimum_radius) : "no limit given",
      micrometres(summary.number("min_radius_m")));
  return table;
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", outcome_facts(summary)};
  append<Fact, Fact>(
      section.rows,
      {{"Orientation error", summary.number("orientation_error"), "", "largest component"},
       {"Largest overlap", summary.number("max_overlap_diameters"), "diameters"},
       {"Mean curvature", summary.number("mean_curvature_per_m"), "1/m"},
       {"Root mean square curvature", summary.number("rms_curvature_per_m"), "1/m"},
       {"Hinges within 10 % of the smallest radius", 100 * summary.number("sharp_hinges"), "%"},
       {"Contacts per fiber, placed at random", summary.number("contacts_per_fiber_random"), "",
        "theory of Toll for straight fibers"},
       {"Packing ended", summary.text("packing_end") == "at_rest" ? "at rest under the contact law"
                                                                  : "once nothing overlapped"},
       {"Largest overlap at rest under the contact law", summary.number("max_overlap_at_rest_diameters"),
        "diameters"},
       {"Smallest radius at rest", summary.number("min_radius_at_rest_m"), "m"},
       {"Packing steps", summary.count("packing_steps")}});
  if (!summary.text("relaxation_end").empty())
    append<Fact, Fact>(section.rows,
                       {{"Relaxation ended", summary.text("relaxation_end")},
                        {"Relaxed for", summary.number("relaxation_s"), "s"},
                        {"Orientation changed meanwhile", summary.number("relaxation_orientation_drift")}});
  return section;
}

/// Lists the components of A4 that do not vanish in the principal frame, of the law and of the fibers.
TableSection fourth_moments(const SummaryFile& summary) {
  constexpr std::array<std::array<std::size_t, 2>, 6> places = {
      {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  TableSection table{"A4", "Fourth moments", {{"component of A_4"}, {"directions drawn"}, {"fibers"}}, {}};
  const std::vector<double> drawn = summary.numbers("A4_drawn"), reached = summary.numbers("A4");
  for (const auto& [i, j] : places)
    table.rows.push_back({fmt::format("a_{0}{0}{1}{1}", i + 1, j + 1),
                          fmt::format("{:.5f}", drawn.at(6 * i + j)),
                          fmt::format("{:.5f}", reached.at(6 * i + j))});
  table.caption = "By length; what a closure approximates from the orientation tensor.";
  return table;
}

HistogramSection lengths(const SummaryFile& summary) {
  HistogramSection section{
      "lengths", "Fiber lengths", {"length", "m"}, {"fibers"}, summary.numbers("length_edges_m"), {}};
  section.frames.push_back({"this cluster", summary.numbers("length_fibers")});
  section.reference = HistogramFrame{"asked", summary.numbers("length_fibers_asked")};
  const std::int64_t bins = summary.count("length_chi_square_bins");
  section.caption = fmt::format("Chi-square against the lengths asked for: {:.3g} ({} {}).",
                                summary.number("length_chi_square"), bins, bins == 1 ? "bin" : "bins");
  return section;
}

LinesSection pair_section(const SummaryFile& summary) {
  LinesSection section{"pair_distances",
                       "Neighbours by distance",
                       {"axis distance", "diameters"},
                       {"neighbours per fiber"},
                       {},
                       {}};
  const std::vector<double> low = summary.numbers("pair_distance_low_diameters");
  const std::vector<double> high = summary.numbers("pair_distance_high_diameters");
  for (std::size_t i = 0; i < low.size(); ++i) section.x_values.push_back(0.5 * (low[i] + high[i]));
  section.series = {
      {"this packing", summary.numbers("pair_distance_per_fiber")},
      {"placed at random", summary.numbers("pair_distance_per_fiber_random"), CurveStyle::dashed}};
  section.caption =
      "Places along a fiber where another one passes at a distance of axes, beside the theory of straight "
      "fibers "
      "placed at random; at one diameter they touch.";
  return section;
}

}  // namespace

ReportDocument report_cluster(const ClusterCase& values, const ResultFolder& folder) {
  const SummaryFile summary(folder.summary());
  ReportDocument document{"A packing of fibers"};
  const VtkhdfReader frames(folder.frames());
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(came_out(summary));
  document.sections.emplace_back(fibers_section(frames, ""));
  document.sections.emplace_back(cut_section(fibers_of(frames.read(frames.times().size() - 1))));
  append(document.sections, density_sections(folder));
  if (!summary.numbers("pair_distance_low_diameters").empty())
    document.sections.emplace_back(pair_section(summary));
  if (!summary.numbers("length_edges_m").empty()) document.sections.emplace_back(lengths(summary));
  document.sections.emplace_back(curvature_section(frames, {0.0}));
  document.sections.emplace_back(fourth_moments(summary));
  document.sections.emplace_back(comparison(values, summary));
  document.sections.emplace_back(effort_section(summary));
  return document;
}

}  // namespace fiberfate
