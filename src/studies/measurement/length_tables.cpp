// Tables of distributions of measured lengths.
#include "studies/measurement/length_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "microstructure/length_fit.hpp"

namespace fiberfate {
namespace {

constexpr int curve_points = 241;
constexpr std::array quantile_shares = {0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95};
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A law with the beginning of its keys in summary.json; nothing was fitted where lengths are alike.
struct NamedLaw {
  std::string name;
  std::optional<FittedLengths> law;
};

void append_constants(const NamedLaw& named, const CumulativeLengths& lengths, RunSummary& summary) {
  if (!named.law) return;
  const FittedLengths& law = *named.law;
  summary.own.insert(summary.own.end(), {{named.name + "_shape", law.shape},
                                         {named.name + "_scale_m", law.scale},
                                         {named.name + "_L_N_m", number_average(law)},
                                         {named.name + "_L_W_m", weight_average(law)},
                                         {named.name + "_distance", lengths.distance(law)}});
}

/// What a law has in a bin around a length, so that its curve stands at the height of the bars; nothing for
/// bins that would begin below zero.
double share_in_bin(double length, double width, const auto& share_below) {
  if (length < 0.5 * width) return unknown;
  return share_below(length + 0.5 * width) - share_below(length - 0.5 * width);
}

void append_law(std::vector<double>& row, const std::optional<FittedLengths>& law, double length,
                double width) {
  if (!law) {
    row.insert(row.end(), 4, unknown);
    return;
  }
  const auto by_number = [&law](double at) { return number_share_below(*law, at); };
  const auto by_length = [&law](double at) { return length_share_below(*law, at); };
  row.insert(row.end(), {by_number(length), by_length(length), share_in_bin(length, width, by_number),
                         share_in_bin(length, width, by_length)});
}

CsvTable quantile_table(const CumulativeLengths& by_number, const CumulativeLengths& by_length) {
  CsvTable table{{"share", "by_number_m", "by_length_m"}};
  for (const double share : quantile_shares)
    table.append({share, by_number.quantile(share), by_length.quantile(share)});
  return table;
}

}  // namespace

void append_distributions(const MeasuredLengths& fibers, const std::vector<double>& bins, Outcome& outcome) {
  const CumulativeLengths by_number(fibers, LengthWeight::number), by_length(fibers, LengthWeight::length);
  const std::array<NamedLaw, 2> laws = {{{"weibull", fit_lengths(LengthFamily::weibull, fibers)},
                                         {"log_normal", fit_lengths(LengthFamily::log_normal, fibers)}}};
  CsvTable curves{{"length_m", "number_share_below", "length_share_below"}};
  for (const NamedLaw& one : laws) {
    append_constants(one, by_number, outcome.summary);
    for (const char* column : {"_number_below", "_length_below", "_number_share", "_length_share"})
      curves.columns.push_back(one.name + column);
  }
  curves.values.resize(curves.columns.size());
  const double longest = bins.back(), width = bins[1] - bins[0];
  for (int i = 0; i < curve_points; ++i) {
    const double length = longest * i / (curve_points - 1);
    std::vector<double> row = {length, by_number.share_up_to(length), by_length.share_up_to(length)};
    for (const NamedLaw& one : laws) append_law(row, one.law, length, width);
    curves.append(row);
  }
  outcome.tables.push_back({"length_curves", std::move(curves)});
  outcome.tables.push_back({"quantiles", quantile_table(by_number, by_length)});
}

}  // namespace fiberfate
