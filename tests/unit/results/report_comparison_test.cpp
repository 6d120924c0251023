// Checks how the documents of several runs become one.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "results/compared_runs.hpp"
#include "results/report_comparison.hpp"

namespace fiberfate {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A run with one chart of two quantities, of which the second is measured, too.
ComparedRun make_run(const std::string& name, double height, const std::string& rate,
                     const std::string& seed) {
  LinesSection chart{"length", "Lengths", {"time", "s"}, {"length", "m"}, {0, 1, 2}, {}};
  chart.series = {{"L_N", {1, height, height}},
                  {"L_W, fitted", {2, 2 * height, height}},
                  {"L_W, measured", {2, 1}, CurveStyle::points, {0, 2}}};
  FactsSection facts{"outcome", "Results", {{"L_N", height, "m"}, {"Ended", std::string("done")}}};
  ReportDocument document{"Lengths"};
  document.sections = {chart, facts};
  return {name, document, {{"flow.rate", rate, "1/s"}, {"run.seed", seed}}};
}

const LinesSection& chart_called(const ReportDocument& document, const std::string& id) {
  for (const ReportSection& section : document.sections)
    if (const auto* lines = std::get_if<LinesSection>(&section); lines && lines->id == id) return *lines;
  throw std::runtime_error("no chart " + id);
}

TEST(Comparison, DrawsALineARunAndWhatIsSharedOnce) {
  const ReportDocument page =
      compare_reports({make_run("a", 0.5, "10", "1"), make_run("b", 0.25, "20", "1")});
  const LinesSection& first = chart_called(page, "length_L_N");
  ASSERT_EQ(first.series.size(), 2U);
  EXPECT_EQ(first.series[1].label, "b");
  EXPECT_EQ(first.series[1].x, (std::vector<double>{0, 1, 2}));
  const LinesSection& second = chart_called(page, "length_L_W");
  ASSERT_EQ(second.series.size(), 3U);
  EXPECT_EQ(second.series[0].label, "a, fitted");
  EXPECT_EQ(second.series[2].label, "L_W, measured");
}

TEST(Comparison, ListsWhatDiffers) {
  const ReportDocument page =
      compare_reports({make_run("a", 0.5, "10", "1"), make_run("b", 0.25, "20", "2")});
  const auto& differences = std::get<ComparisonSection>(page.sections.front());
  ASSERT_EQ(differences.rows.size(), 2U);
  EXPECT_EQ(differences.rows[0].label, "flow.rate");
  EXPECT_EQ(differences.rows[0].unit, "1/s");
  EXPECT_EQ(std::get<double>(differences.rows[0].values[1].value), 20);
}

TEST(Comparison, MakesReplicasOneLineWithABand) {
  const ReportDocument page = compare_reports(
      {make_run("a", 0.5, "10", "1"), make_run("b", 0.3, "10", "2"), make_run("c", 0.1, "20", "1")});
  const LinesSection& chart = chart_called(page, "length_L_N");
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_EQ(chart.series[0].label, "a, b");
  EXPECT_DOUBLE_EQ(chart.series[0].values[1], 0.4);
  EXPECT_EQ(chart.series[0].low[1], 0.3);
  EXPECT_EQ(chart.series[0].high[1], 0.5);
  EXPECT_TRUE(chart.series[1].low.empty());
  const auto& facts = std::get<ComparisonSection>(page.sections.back());
  EXPECT_DOUBLE_EQ(std::get<double>(facts.rows[0].values[0].value), 0.4);
  EXPECT_EQ((*facts.rows[0].values[0].ends)[0], 0.3);
  EXPECT_EQ(std::get<std::string>(facts.rows[1].values[0].value), "done");
}

TEST(MergeReplicas, ReadsOtherTimesBetweenTheirPoints) {
  const ReportSeries merged = merge_replicas(
      {{"a", {0, 0, 0}, CurveStyle::line, {0, 1, 3}}, {"b", {2, 4}, CurveStyle::line, {0, 2}}});
  EXPECT_EQ(merged.values, (std::vector<double>{1, 1.5, 0}));
  EXPECT_EQ(merged.high, (std::vector<double>{2, 3, 0}));
}

TEST(MergeReplicas, LeavesOutWhatIsMissing) {
  const ReportSeries merged =
      merge_replicas({{"a", {nan, 1}, CurveStyle::line, {0, 1}}, {"b", {3, nan}, CurveStyle::line, {0, 1}}});
  EXPECT_EQ(merged.values, (std::vector<double>{3, 1}));
}

}  // namespace
}  // namespace fiberfate
