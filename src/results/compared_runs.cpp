// Merges the runs of a comparison.
#include "results/compared_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace fiberfate {
namespace {

/// Whether a key tells replicas apart (a seed) or changes no result (threads, checkpoints).
bool is_of_the_run(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  const std::string leaf = key.substr(dot == std::string::npos ? 0 : dot + 1);
  return leaf == "seed" || key == "run.threads" || key == "output.checkpoint_interval";
}

bool are_replicas(const ComparedRun& one, const ComparedRun& other) {
  const auto essential = [](const ComparedRun& run) {
    std::vector<std::pair<std::string, std::string>> keys;
    for (const ResolvedKey& key : run.keys)
      if (!is_of_the_run(key.name)) keys.emplace_back(key.name, key.value);
    return keys;
  };
  return essential(one) == essential(other);
}

std::string label_of(const std::vector<const ComparedRun*>& runs) {
  constexpr std::size_t most_named = 3;
  if (runs.size() > most_named) return fmt::format("{} and {} replicas", runs.front()->name, runs.size() - 1);
  std::string label;
  for (const ComparedRun* run : runs) label += (label.empty() ? "" : ", ") + run->name;
  return label;
}

/// Bitwise equality, for which NaN equals itself.
bool same_numbers(const std::vector<double>& one, const std::vector<double>& other) {
  return std::ranges::equal(one, other,
                            [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

/// The value of a curve at an x by linear interpolation; NaN beyond its ends and where its x does not rise.
double value_at(const ReportSeries& curve, double x) {
  const auto above = std::ranges::lower_bound(curve.x, x);
  if (above == curve.x.end()) return std::numeric_limits<double>::quiet_NaN();
  const auto k = static_cast<std::size_t>(above - curve.x.begin());
  if (curve.x[k] == x) return curve.values[k];
  if (k == 0) return std::numeric_limits<double>::quiet_NaN();
  const double share = (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
  return curve.values[k - 1] + share * (curve.values[k] - curve.values[k - 1]);
}

/// The histograms of a document.
std::vector<HistogramSection*> histograms_of(ComparedRun& run) {
  std::vector<HistogramSection*> found;
  for (ReportSection& section : run.document.sections)
    if (auto* bars = std::get_if<HistogramSection>(&section)) found.push_back(bars);
  return found;
}

/// Whether the longer edges begin with the shorter ones.
bool begins_with(const std::vector<double>& longer, const std::vector<double>& shorter) {
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
  return longer.size() > shorter.size() && std::equal(shorter.begin(), shorter.end(), longer.begin(), near);
}

/// Gives a histogram the edges of a longer one; there are no values in the bins that it gains.
void lengthen(HistogramSection& bars, const std::vector<double>& edges) {
  bars.edges = edges;
  for (HistogramFrame& frame : bars.frames) frame.values.resize(edges.size() - 1, 0.0);
  if (bars.reference) bars.reference->values.resize(edges.size() - 1, 0.0);
}

}  // namespace

void share_bins(std::vector<ComparedRun>& runs) {
  std::map<std::string, std::vector<double>> longest;
  for (ComparedRun& run : runs)
    for (const HistogramSection* bars : histograms_of(run))
      if (std::vector<double>& edges = longest[bars->id]; edges.size() < bars->edges.size())
        edges = bars->edges;
  for (ComparedRun& run : runs)
    for (HistogramSection* bars : histograms_of(run))
      if (begins_with(longest[bars->id], bars->edges)) lengthen(*bars, longest[bars->id]);
}

std::vector<Replicas> group_replicas(const std::vector<ComparedRun>& runs) {
  std::vector<Replicas> groups;
  for (const ComparedRun& run : runs) {
    const auto found = std::ranges::find_if(
        groups, [&run](const Replicas& group) { return are_replicas(*group.runs.front(), run); });
    if (found == groups.end())
      groups.push_back({{}, {&run}});
    else
      found->runs.push_back(&run);
  }
  for (Replicas& group : groups) group.label = label_of(group.runs);
  return groups;
}

ReportSeries merge_replicas(const std::vector<ReportSeries>& curves) {
  ReportSeries merged = curves.front();
  if (curves.size() == 1 || merged.style == CurveStyle::points) return merged;
  merged.low.clear();
  merged.high.clear();
  const bool same_x =
      std::ranges::all_of(curves, [&](const ReportSeries& one) { return same_numbers(one.x, merged.x); });
  for (std::size_t k = 0; k < merged.values.size(); ++k) {
    double sum = 0, count = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ReportSeries& one : curves) {
      const double value = same_x ? one.values[k] : value_at(one, merged.x[k]);
      if (std::isnan(value)) continue;
      sum += value;
      count += 1;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    merged.values[k] = sum / count;
    merged.low.push_back(low);
    merged.high.push_back(high);
  }
  return merged;
}

bool are_same(const ReportSeries& one, const ReportSeries& other) {
  return same_numbers(one.x, other.x) && same_numbers(one.values, other.values);
}

}  // namespace fiberfate
