// Merges the runs of a comparison.
#include "results/compared_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace

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
