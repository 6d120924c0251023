// Draws distributions of measured lengths.
#include "studies/measurement/length_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "io/csv_table.hpp"
#include "studies/measurement/lists.hpp"

namespace fiberfate {
namespace {

/// A law as its keys and as a reader names it.
struct LawName {
  std::string key, label, shape, scale;
};

const std::array<LawName, 2> law_names = {
    {{"weibull", "Weibull", "exponent", "scale"},
     {"log_normal", "log-normal", "standard deviation of ln L", "median"}}};

bool has_laws(const ResultFolder& folder) {
  return std::filesystem::exists(folder.file("length_curves.csv"));
}

bool was_fitted(const SummaryFile& summary, const LawName& law) {
  return !std::isnan(summary.number(law.key + "_shape"));
}

std::vector<double> percent(const CsvTable& table, const std::string& column) {
  std::vector<double> shares = table.column(column);
  for (double& share : shares) share *= 100;
  return shares;
}

/// How fibers are counted, in columns and in words.
struct Counting {
  std::string column, id, title, axis;
};

const std::array<Counting, 2> countings = {
    {{"number", "by_number", "Fibers by length", "share of the fibers"},
     {"length", "by_length", "Total length by length", "share of the total length"}}};

HistogramSection bars(const Counting& counting, const MeasurementCase& values, const SummaryFile& summary,
                      const ResultFolder& folder) {
  const CsvTable table = read_rows(folder.file("histogram.csv"));
  HistogramSection section{counting.id, counting.title, {"length", "m"}, {counting.axis, "%"}, {}, {}};
  section.edges = table.column("length_low_m");
  section.edges.push_back(table.column("length_high_m").back());
  const bool corrected = values.lengths.sample_diameter.has_value();
  section.frames = {{corrected ? "corrected" : "measured", percent(table, counting.column + "_share")}};
  if (corrected && counting.column == "number")
    section.reference = HistogramFrame{"as measured", percent(table, "uncorrected_number_share")};
  if (!has_laws(folder)) return section;
  const CsvTable curves = read_rows(folder.file("length_curves.csv"));
  for (const LawName& law : law_names) {
    if (!was_fitted(summary, law)) continue;
    ReportSeries curve{law.label, percent(curves, law.key + "_" + counting.column + "_share")};
    curve.x = curves.column("length_m");
    section.curves.push_back(std::move(curve));
  }
  if (!section.curves.empty())
    section.caption = counting.column == "number"
                          ? "Curves: laws fitted to the list by maximum likelihood, not to the bars."
                          : "Curves: the laws that are fitted to the number of fibers, weighted by length.";
  return section;
}

LinesSection cumulative(const Counting& counting, const MeasurementCase& values, const SummaryFile& summary,
                        const ResultFolder& folder) {
  const CsvTable curves = read_rows(folder.file("length_curves.csv"));
  LinesSection section{
      "cumulative_" + counting.id,
      counting.column == "number" ? "Fibers that are shorter" : "Total length in shorter fibers",
      {"length", "m"},
      {counting.axis, "%"},
      curves.column("length_m"),
      {{values.lengths.sample_diameter ? "corrected" : "measured",
        percent(curves, counting.column + "_share_below")}}};
  for (const LawName& law : law_names)
    if (was_fitted(summary, law))
      section.series.push_back(
          {law.label, percent(curves, law.key + "_" + counting.column + "_below"), CurveStyle::dashed});
  section.legend = LegendValues::none;
  return section;
}

TableSection quantiles(const ResultFolder& folder) {
  const CsvTable table = read_rows(folder.file("quantiles.csv"));
  TableSection section{
      "quantiles",
      "Quantiles",
      {{"share", "%"}, {"by number", "m"}, {"by length", "m"}},
      {},
      "Length up to which the fibers hold the given share of their number and of their total length."};
  const std::vector<double> shares = percent(table, "share");
  for (std::size_t i = 0; i < table.rows(); ++i)
    section.rows.push_back({shares[i], table.column("by_number_m")[i], table.column("by_length_m")[i]});
  return section;
}

TableSection means(const SummaryFile& summary, bool corrected) {
  TableSection section{
      "lengths", "Mean lengths", {{"average"}, {"value", "m"}, {"low", "m"}, {"high", "m"}}, {}};
  if (corrected) section.columns.push_back({"uncorrected", "m"});
  for (const std::string name : {"L_N", "L_W"}) {
    section.rows.push_back({name, summary.number(name + "_m"), summary.number(name + "_lower_m"),
                            summary.number(name + "_upper_m")});
    if (corrected) section.rows.back().push_back(summary.number(name + "_uncorrected_m"));
  }
  section.role = SectionRole::chart;
  return section;
}

TableSection laws(const SummaryFile& summary) {
  TableSection section{"laws",
                       "Laws fitted to the lengths",
                       {{"law"}, {"L_N", "m"}, {"L_W", "m"}, {"distance", "%"}, {"constants"}},
                       {},
                       "Maximum likelihood. The distance is the largest one between the cumulative curves of "
                       "the list and of the law; L_N and L_W are those of the law, as a cluster takes them."};
  for (const LawName& law : law_names) {
    if (!was_fitted(summary, law)) continue;
    const auto number = [&](const char* name) { return summary.number(law.key + name); };
    section.rows.push_back({law.label, number("_L_N_m"), number("_L_W_m"), 100 * number("_distance"),
                            fmt::format("{} {:.4g}, {} {:.4g} mm", law.shape, number("_shape"), law.scale,
                                        1e3 * number("_scale_m"))});
  }
  return section;
}

std::string interval(const MeasurementCase& values, const SummaryFile& summary, const std::string& name) {
  return fmt::format("{:.4g} to {:.4g} mm with {:g} %", 1e3 * summary.number(name + "_lower_m"),
                     1e3 * summary.number(name + "_upper_m"), 100 * values.statistics.level);
}

/// The length that half of the fibers, or half of the total length, lie below.
double median(const CsvTable& quantiles, const std::string& column) {
  const std::vector<double>& shares = quantiles.column("share");
  const auto half = std::ranges::find(shares, 0.5);
  return half == shares.end() ? std::nan("") : quantiles.column(column)[half - shares.begin()];
}

}  // namespace

std::vector<Fact> length_facts(const MeasurementCase& values, const SummaryFile& summary,
                               const ResultFolder& folder) {
  const double number_average = summary.number("L_N_m"), weight_average = summary.number("L_W_m");
  std::vector<Fact> facts = {
      {"L_N", number_average, "m", interval(values, summary, "L_N"), Prominence::headline},
      {"L_W", weight_average, "m", interval(values, summary, "L_W"), Prominence::headline},
      {"L_W over L_N", weight_average / number_average, "", "1 if all fibers have the same length",
       Prominence::headline}};
  if (std::filesystem::exists(folder.file("quantiles.csv"))) {
    const CsvTable quantiles = read_rows(folder.file("quantiles.csv"));
    facts.push_back({"Median length", median(quantiles, "by_number_m"), "m", "half of the fibers are shorter",
                     Prominence::headline});
    facts.push_back({"Median length by length", median(quantiles, "by_length_m"), "m",
                     "half of the total length is in shorter fibers"});
  }
  facts.push_back({"Shortest", summary.number("shortest_m"), "m"});
  facts.push_back({"Longest", summary.number("longest_m"), "m"});
  const auto count = [&summary](const char* key) { return static_cast<std::size_t>(summary.count(key)); };
  const std::string left_out = LeftOut{count("left_out_empty_lines"), count("left_out_zero_lengths")}.text();
  facts.push_back({"Lengths measured", summary.count("measured_lengths"), "",
                   left_out.empty() ? "no row is left out" : left_out, Prominence::headline});
  facts.push_back({"Column", summary.text("lengths_column")});
  return facts;
}

std::vector<ReportSection> length_sections(const MeasurementCase& values, const SummaryFile& summary,
                                           const ResultFolder& folder) {
  std::vector<ReportSection> sections;
  for (const Counting& counting : countings) sections.emplace_back(bars(counting, values, summary, folder));
  if (has_laws(folder)) {
    for (const Counting& counting : countings)
      sections.emplace_back(cumulative(counting, values, summary, folder));
    sections.emplace_back(quantiles(folder));
  }
  sections.emplace_back(means(summary, values.lengths.sample_diameter.has_value()));
  if (TableSection table = laws(summary); !table.rows.empty()) sections.emplace_back(std::move(table));
  return sections;
}

}  // namespace fiberfate
