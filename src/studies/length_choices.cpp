// Fiber lengths at the start of a study that follows them by a length law.
#include "studies/length_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "continuum/length_registry.hpp"
#include "continuum/phelps.hpp"
#include "microstructure/length_distribution.hpp"

namespace fiberfate {
namespace {

/// Classes of equal number that stand for a Weibull distribution.
constexpr std::size_t weibull_classes = 1000;

}  // namespace

KeyRows<LengthChoices> initial_length_rows() {
  using Lengths = LengthChoices;
  const std::vector<Column> classes = {{"length", {"m", "mm"}, Range::positive(10)},
                                       {"number", {"1", "1"}, Range::not_negative()}};
  return {
      rows_key("distribution", &Lengths::distribution, classes,
               "Classes: rows [length, number of fibers], or the path of a text file with such rows in SI.",
               optional(R"([["0.5 mm", 120], ["1 mm", 60], ["5 mm", 4]])"), "thesis 4.4"),
      key("number_average", &Lengths::number_average, {"m", "mm"}, Range::positive(10),
          "L_N at the start; with form = \"distribution\", of a Weibull distribution."),
      key("weight_average", &Lengths::weight_average, {"m", "mm"}, Range::positive(10), "L_W at the start."),
  };
}

KeyRows<LengthChoices> length_form_rows() {
  using Lengths = LengthChoices;
  const Choices<LengthForm> forms = {
      {LengthForm::distribution, "distribution", "classes of initial length, or bins"},
      {LengthForm::means, "means", "L_N and L_W, each by its own equation"}};
  const Choices<ClassWeight> weights = {
      {ClassWeight::length, "length", "the fiber length of the class: nothing is lost"},
      {ClassWeight::number, "number", "the number of its fibers, as the thesis"}};
  return {
      key("form", &Lengths::form, forms, "What is followed.", "thesis 4.3 (means), 4.4 (distribution)"),
      key("weight", &Lengths::weight, weights,
          "What a class keeps while it becomes shorter; not for " + laws_of_bins() + "."),
      key("bins", &Lengths::bins, {}, Range::between(2, static_cast<double>(most_bins)),
          "Bins of " + laws_of_bins() + ". L_ub should span several of them."),
      key("largest_length", &Lengths::largest_length, {"m", "mm"}, Range::positive(10),
          "Length of the last bin; not given: the longest fiber at the start."),
  };
}

bool lengths_are_read(const CaseChecker& checker) {
  return checker.is_sound("fibers.distribution") && checker.is_sound("fibers.number_average") &&
         checker.is_sound("fibers.weight_average");
}

bool gives_means(const LengthChoices& fibers) {
  return fibers.number_average || fibers.weight_average;
}

std::string laws_of_bins() {
  std::vector<std::string> names;
  for (const AttritionLawEntry& one : attrition_laws())
    if (one.form == AttritionForm::fragmentation) names.push_back(one.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

bool needs_bins(const LawChoice& law) {
  return std::ranges::any_of(attrition_laws(), [&law](const AttritionLawEntry& one) {
    return one.name == law.name && one.form == AttritionForm::fragmentation;
  });
}

void validate_mean_lengths(const LengthChoices& fibers, CaseChecker& checker) {
  if (!(fibers.number_average && fibers.weight_average))
    checker.error(fibers.number_average ? "fibers.weight_average" : "fibers.number_average", "not given",
                  "give both mean lengths");
  else if (!(*fibers.number_average < *fibers.weight_average))
    checker.error("fibers.number_average", "not less than " + checker.cite("fibers.weight_average"),
                  "L_N is less than L_W; for equal lengths give fibers.length");
}

void validate_distribution(const std::vector<std::vector<double>>& rows, CaseChecker& checker) {
  if (!rows.empty() && std::ranges::all_of(rows, [](const auto& row) { return row[1] == 0; }))
    checker.error("fibers.distribution", "there are no fibers", "give at least one number above zero");
}

LengthClasses length_classes(const std::vector<std::vector<double>>& rows) {
  LengthClasses classes;
  for (const std::vector<double>& row : rows) {
    classes.lengths.push_back(row[0]);
    classes.numbers.push_back(row[1]);
  }
  return classes;
}

LengthStart length_start(const LengthChoices& fibers) {
  LengthStart start;
  start.form = fibers.form;
  start.weight = fibers.weight;
  start.bins = {static_cast<std::size_t>(fibers.bins), fibers.largest_length.value_or(0)};
  if (!fibers.distribution.empty()) {
    start.initial = length_classes(fibers.distribution);
  } else if (fibers.length) {
    start.initial = {{*fibers.length}, {1}};
  } else if (fibers.number_average) {
    start.means = MeanLengths{*fibers.number_average, *fibers.weight_average};
    start.initial.lengths =
        sample_lengths(WeibullLengths{*fibers.number_average, *fibers.weight_average}, {weibull_classes});
    start.initial.numbers.assign(weibull_classes, 1.0);
  }
  return start;
}

std::string remark_on_bins(const LengthChoices& fibers, double unbreakable_length, double share) {
  const LengthStart start = length_start(fibers);
  const double longest = start.bins.largest_length > 0 ? start.bins.largest_length
                                                       : *std::ranges::max_element(start.initial.lengths);
  const double width = longest / static_cast<double>(start.bins.bins);
  const double open = 0.5 * width / unbreakable_length;
  if (!(open > share)) return {};
  return fmt::format(
      "fibers.bins = {}: bins of {:.3g} mm place the unbreakable length, {:.3g} mm, to {:.2g} %, and zeta to "
      "{:.2g} %: "
      "see what twice as many change",
      fibers.bins, 1e3 * width, 1e3 * unbreakable_length, 100 * open, 400 * open);
}

void append_length_shares(CsvTable& table, const std::vector<double>& leading,
                          const LengthClasses& population, const std::vector<double>& edges) {
  LengthClasses by_length = population;
  for (std::size_t i = 0; i < by_length.numbers.size(); ++i) by_length.numbers[i] *= by_length.lengths[i];
  const std::vector<double> numbers = histogram(population, edges), lengths = histogram(by_length, edges);
  const double all = std::accumulate(population.numbers.begin(), population.numbers.end(), 0.0);
  const double length = total_length(population);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    std::vector<double> row = leading;
    row.insert(row.end(), {edges[i], edges[i + 1], numbers[i] / all, lengths[i] / length});
    table.append(row);
  }
}

}  // namespace fiberfate
