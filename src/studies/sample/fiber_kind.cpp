// Checks one kind of fibers and translates it for the packing.
#include "studies/sample/fiber_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"

namespace fiberfate {
namespace {

bool is_partly_given(const std::string& table, const CaseChecker& checker) {
  return checker.is_given(table + ".length_histogram.heights") ||
         checker.is_given(table + ".length_distribution.weight_average");
}

/// Demands one way of giving lengths, and tells which key it is.
std::string length_key(const std::string& table, CaseChecker& checker) {
  std::vector<std::string> given;
  for (const std::string& key : length_keys(table))
    if (checker.is_given(key)) given.push_back(key);
  if (given.empty() && !is_partly_given(table, checker))
    checker.require(table + ".length", "fibers need a length", "\"2.5 mm\"");
  for (std::size_t i = 1; i < given.size(); ++i)
    checker.error(given[i], "contradicts " + checker.cite(given[0]), "remove one of the two");
  return given.empty() ? table + ".length" : given[0];
}

/// Demands both of two keys, or none.
void require_both(const std::string& first, const std::string& second, const std::string& remedy,
                  CaseChecker& checker) {
  if (checker.is_given(first) == checker.is_given(second)) return;
  const bool lacks_first = !checker.is_given(first);
  checker.error(lacks_first ? first : second,
                fmt::format("not given, but {} is", lacks_first ? second : first), remedy);
}

/// Finds which key of a histogram is at fault, if one is.
std::string blamed(const std::string& key, const FiberKind& kind) {
  const LengthHistogram& histogram = kind.length_histogram;
  const bool flat = histogram.edges.size() == histogram.heights.size() + 1 &&
                    std::all_of(histogram.heights.begin(), histogram.heights.end(),
                                [](double height) { return height == 0; });
  const auto dot = key.rfind('.');
  return key.ends_with("length_histogram.edges") && flat ? key.substr(0, dot) + ".heights" : key;
}

void validate_law(const FiberKind& kind, const std::string& table, const std::string& key,
                  CaseChecker& checker) {
  const LengthLaw law = length_law(kind);
  if (!checker.report_at(blamed(key, kind), [&law] { require_admissible(law); })) return;
  if (!(kind.diameter > 0)) return;
  const std::string diameter = checker.cite(table + ".diameter");
  if (number_average(law) < kind.diameter)
    checker.error(key, "fibers are shorter than they are thick, " + diameter,
                  "give lengths of at least one diameter");
  const auto specks = std::count_if(kind.lengths.begin(), kind.lengths.end(),
                                    [&kind](const auto& row) { return row[0] < kind.diameter; });
  if (specks > 0)
    checker.error(key,
                  fmt::format("{} of {} fibers are shorter than they are thick, {}", specks,
                              kind.lengths.size(), diameter),
                  "leave them out: they are no fibers any more");
}

void validate_lengths(const FiberKind& kind, const std::string& table, CaseChecker& checker) {
  const std::string key = length_key(table, checker);
  const std::string histogram = table + ".length_histogram.", smooth = table + ".length_distribution.";
  require_both(histogram + "edges", histogram + "heights", "give one more edge than there are heights",
               checker);
  require_both(smooth + "number_average", smooth + "weight_average", "a law needs both means", checker);
  const std::vector<std::string> keys = {key, histogram + "edges", histogram + "heights",
                                         smooth + "number_average", smooth + "weight_average"};
  if (std::all_of(keys.begin(), keys.end(),
                  [&checker](const std::string& each) { return checker.is_sound(each); }))
    validate_law(kind, table, key, checker);
}

void validate_rods(const FiberKind& kind, const std::string& table, CaseChecker& checker) {
  const std::string rod_length = table + ".rod_length", diameter = checker.cite(table + ".diameter");
  checker.require(rod_length, "fibers are cut into rods", "\"0.1 mm\"");
  if (kind.diameter <= 0 || !kind.rod_length) return;
  if (*kind.rod_length < kind.diameter)
    checker.error(rod_length, "a rod is shorter than it is thick, " + diameter,
                  "give at least one diameter; about five is usual");
  else if (*kind.rod_length < 2 * kind.diameter)
    checker.warn(rod_length, "rods are shorter than two diameters",
                 "contacts next to a hinge are then counted on both of its rods; about five is usual");
}

}  // namespace

std::vector<std::string> length_keys(const std::string& table) {
  return {table + ".length", table + ".lengths", table + ".length_histogram.edges",
          table + ".length_distribution.number_average"};
}

void validate_fiber_kind(const FiberKind& kind, const std::string& table, CaseChecker& checker) {
  validate_lengths(kind, table, checker);
  validate_rods(kind, table, checker);
}

LengthLaw length_law(const FiberKind& kind) {
  if (!kind.length_histogram.edges.empty()) return kind.length_histogram;
  if (!kind.lengths.empty()) {
    ListedLengths list;
    for (const std::vector<double>& row : kind.lengths) list.lengths.push_back(row[0]);
    return list;
  }
  const LengthDistributionChoices& smooth = kind.length_distribution;
  if (smooth.number_average) {
    const double number = *smooth.number_average, weight = smooth.weight_average.value_or(number);
    if (smooth.law == LengthDistributionLaw::weibull) return WeibullLengths{number, weight};
    return LogNormalLengths{number, weight};
  }
  return SingleLength{kind.length.value_or(0)};
}

FiberMaterial material(const FiberKind& kind) {
  return {kind.diameter / 2, kind.youngs_modulus, kind.density.value_or(0)};
}

}  // namespace fiberfate
