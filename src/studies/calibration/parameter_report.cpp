// Lists and draws what is known of the parameters of a fit.
#include "studies/calibration/parameter_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/csv_table.hpp"
#include "studies/law_facts.hpp"

namespace fiberfate {
namespace {

/// Gives the free parameters in the law's order.
std::vector<LawParameter> free_parameters(const CalibrationCase& values) {
  std::vector<LawParameter> free;
  for (const LawParameter& one : chosen_law(calibrated_menu(values), calibrated_law(values))->parameters)
    if (std::ranges::find(values.search.free, one.name) != values.search.free.end()) free.push_back(one);
  return free;
}

std::string written_interval(double low, double high) {
  return std::isnan(low) || std::isnan(high) ? std::string() : fmt::format("{:.4g} to {:.4g}", low, high);
}

/// How an interval was found, in the head of its columns.
std::string name_of_interval(const std::string& kind) {
  if (kind == "_profile_") return "by profile, ";
  return kind == "_bootstrap_" ? "by bootstrap, " : "linearised, ";
}

/// Numbers on top of the page: more of them than this would hide each other.
constexpr std::size_t most_headlines = 4;

/// The scale on which a parameter was searched.
AxisScale scale_of(const CalibrationCase& values, const std::string& parameter) {
  const bool linear = std::ranges::find(values.search.linear, parameter) != values.search.linear.end();
  return linear ? AxisScale::linear : AxisScale::logarithmic;
}

/// Whether a profile spans more than round-off, as it does not where the law gives the data exactly.
bool spans(const std::vector<double>& numbers) {
  if (numbers.empty()) return false;
  const auto [low, high] = std::ranges::minmax(numbers);
  return high - low > 1e-9 * std::max(std::abs(low), std::abs(high));
}

}  // namespace

std::vector<std::string> free_names(const CalibrationCase& values) {
  std::vector<std::string> names;
  for (const LawParameter& one : free_parameters(values)) names.push_back(one.name);
  return names;
}

TableSection estimates(const CalibrationCase& values, const SummaryFile& summary, const FitName& name) {
  const std::string level = fmt::format("{:g} % ", 100 * values.search.level);
  TableSection section{"estimates" + name.prefix, "Parameters" + name.heading, {}, {}};
  section.columns = {{"parameter"}, {"unit"}, {"value"}, {"standard error"}};
  std::vector<std::string> kinds = {"_"};
  if (values.search.profiles == ProfileChoice::all) kinds.emplace_back("_profile_");
  if (values.search.bootstrap > 0) kinds.emplace_back("_bootstrap_");
  for (const std::string& kind : kinds)
    for (const char* end : {"low", "high"}) section.columns.push_back({level + name_of_interval(kind) + end});
  for (const LawParameter& parameter : free_parameters(values)) {
    const std::string key = name.prefix + parameter.name;
    const auto [unit, factor] = shown_as(parameter);
    section.rows.push_back({parameter.name, unit, factor * summary.number(key),
                            factor * summary.number(key + "_standard_error")});
    for (const std::string& kind : kinds)
      for (const char* end : {"lower", "upper"})
        section.rows.back().emplace_back(factor * summary.number(key + kind + end));
  }
  section.caption = "A dash: the data do not determine this parameter.";
  return section;
}

std::vector<Fact> parameter_facts(const CalibrationCase& values, const SummaryFile& summary,
                                  const FitName& name) {
  const std::vector<LawParameter> free = free_parameters(values);
  const bool first = free.size() * fit_names(values).size() <= most_headlines;
  std::vector<Fact> facts;
  for (const LawParameter& one : free) {
    const std::string key = name.prefix + one.name;
    const auto [unit, factor] = shown_as(one);
    const std::string interval =
        written_interval(factor * summary.number(key + "_lower"), factor * summary.number(key + "_upper"));
    facts.push_back({one.name + name.heading, factor * summary.number(key), unit,
                     interval.empty() ? "the data give no interval"
                                      : fmt::format("{:g} % interval: {}{}{}", 100 * values.search.level,
                                                    interval, unit.empty() ? "" : " ", unit),
                     first ? Prominence::headline : Prominence::ordinary});
  }
  return facts;
}

void append_profiles(const CalibrationCase& values, const ResultFolder& folder, const FitName& name,
                     const SummaryFile& summary, std::vector<ReportSection>& sections) {
  if (!std::filesystem::exists(folder.file("profile.csv"))) return;
  const CsvTable table = read_csv(folder.file("profile.csv"));
  const std::vector<LawParameter>& parameters =
      chosen_law(calibrated_menu(values), calibrated_law(values))->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto number = static_cast<double>(i);
    const std::string& parameter = parameters[i].name;
    LinesSection section{"profile_" + parameter + name.prefix,
                         "Profile of " + parameter + name.heading,
                         {parameter, shown_unit(parameters[i].unit), scale_of(values, parameter)},
                         {"least sum of squares"},
                         pick(table, name.number, number, "value"),
                         {}};
    if (!spans(section.x_values)) continue;
    const std::vector<double> limit = pick(table, name.number, number, "limit");
    section.series = {{"least sum of squares", pick(table, name.number, number, "chi_square")},
                      {fmt::format("limit of {:g} %", 100 * values.search.level), limit, CurveStyle::dashed}};
    const std::string key = name.prefix + parameter;
    section.series.push_back({"fit and ends of the interval",
                              {limit.front(), summary.number(name.prefix + "chi_square"), limit.front()},
                              CurveStyle::points,
                              {summary.number(key + "_profile_lower"), summary.number(key),
                               summary.number(key + "_profile_upper")}});
    section.legend = LegendValues::none;
    sections.emplace_back(std::move(section));
  }
}

void append_samples(const CalibrationCase& values, const ResultFolder& folder, const FitName& name,
                    std::vector<ReportSection>& sections) {
  if (!std::filesystem::exists(folder.file("bootstrap.csv"))) return;
  constexpr std::size_t most_parameters = 3;
  const CsvTable table = read_csv(folder.file("bootstrap.csv"));
  const std::vector<LawParameter>& parameters =
      chosen_law(calibrated_menu(values), calibrated_law(values))->parameters;
  std::vector<std::pair<LawParameter, std::vector<double>>> drawn;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (auto samples = pick(table, name.number, static_cast<double>(i), "value"); spans(samples))
      drawn.emplace_back(parameters[i], std::move(samples));
  if (drawn.size() > most_parameters) return;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto axis = [&](const LawParameter& one) {
        return ReportAxis{one.name, shown_unit(one.unit), scale_of(values, one.name)};
      };
      LinesSection section{
          fmt::format("samples_{}_{}{}", k, i, name.prefix),
          fmt::format("Bootstrap of {} and {}{}", drawn[k].first.name, drawn[i].first.name, name.heading),
          axis(drawn[k].first),
          axis(drawn[i].first),
          {},
          {{"samples", drawn[i].second, CurveStyle::points, drawn[k].second}}};
      section.legend = LegendValues::none;
      sections.emplace_back(std::move(section));
    }
}

}  // namespace fiberfate
