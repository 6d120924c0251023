// The keys of the study calibration that are about molded parts, and their checks.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/timer.hpp"
#include "keys/text_rows.hpp"
#include "studies/calibration/case.hpp"
#include "studies/calibration/mold_experiment.hpp"
#include "studies/calibration/molds.hpp"

namespace fiberfate {
namespace {

/// Of a kept step, node and layer of half the gap.
constexpr double kept_bytes = 70, length_cost = 4e-8;  // bytes, s
/// Of a fit with the profiles of its parameters.
constexpr double predictions = 300;

using TextRow = std::vector<std::string>;

TextRow read_molding_row(const std::vector<TomlValue>& row, const std::filesystem::path& folder) {
  const RowTexts texts(row);
  TextRow words;
  for (std::size_t i = 0; i < texts.count(); ++i) words.push_back(texts.text(i));
  words[0] = std::filesystem::absolute(folder / words[0]).lexically_normal().string();
  return words;
}

TextRow write_molding_row(const TextRow& words, NumberStyle) {
  TextRow items;
  for (const std::string& word : words) items.push_back(write_text(word));
  return items;
}

Reading<MoldedLengths> read_lengths(const std::vector<TomlValue>& row, const std::vector<MoldedLengths>&) {
  const RowTexts texts(row);
  const auto mean = texts.count() >= 4 ? length_mean_of(texts.text(2)) : std::nullopt;
  if (!mean) return Complaint{"not a condition, a place, L_N or L_W, and at least one length", ""};
  MoldedLengths one = {texts.text(0), texts.text(1), *mean, {}};
  for (std::size_t i = 3; i < row.size(); ++i) {
    const Reading<double> length = read_quantity(row[i], {"m", "mm"}, Range::positive(1));
    if (const auto* complaint = std::get_if<Complaint>(&length))
      return Complaint{fmt::format("\"{}\": {}", texts.text(i), complaint->what), complaint->remedy};
    one.samples.push_back(std::get<double>(length));
  }
  return one;
}

TextRow write_lengths(const MoldedLengths& one, NumberStyle style) {
  TextRow items = {write_text(one.condition), write_text(one.place), write_text(symbol(one.mean))};
  for (const double sample : one.samples) items.push_back(write_quantity(sample, {"m", "mm"}, style));
  return items;
}

/// Checks what can be said without the moldings themselves.
void validate_molding_keys(const CalibrationCase& values, CaseChecker& checker) {
  const CalibrationConditions& conditions = values.conditions;
  const std::size_t rows = conditions.moldings.size();
  if (rows > 1 && rows != conditions.names.size() && !conditions.names.empty())
    checker.error("conditions.moldings",
                  fmt::format("{} entries for {} conditions", rows, conditions.names.size()),
                  "give one for each, or one for all");
  if (calibrates_orientation(values))
    checker.error("orientation.name", "only laws of length are calibrated in molds", "give a law in [law]");
  if (!conditions.rates.empty() || !conditions.speeds.empty())
    checker.error(conditions.rates.empty() ? "conditions.speeds" : "conditions.rates",
                  "the conditions are moldings, whose flow is computed", "remove it");
  if (!values.data.series.empty())
    checker.error("data.series", "the conditions are moldings", "give what was measured in data.lengths");
  if (values.data.lengths.empty())
    checker.error("data.lengths", "nothing is given that was measured",
                  "add lengths = [[\"" + (conditions.names.empty() ? "condition" : conditions.names[0]) +
                      "\", \"Loc.1\", \"L_N\", \"0.9 mm\"]] under [data]");
  checker.warn_unused(
      {"conditions.viscosities", "conditions.temperatures", "conditions.pressures", "conditions.compressions",
       "conditions.flows", "conditions.orientation", "fibers.distribution", "fibers.number_average",
       "fibers.weight_average", "melt.name", "data.absolute_uncertainty"},
      "a calibration without conditions.moldings");
}

void validate_coupled(const CalibrationCase& values, const std::string& name, CaseChecker& checker) {
  const CalibrationSweep& sweep = values.sweep;
  const bool swept = sweep.lower && sweep.upper && values.search.free.size() == 1 &&
                     values.search.free[0] == sweep.parameter;
  if (!swept)
    checker.error(sweep.parameter.empty() ? "fit.free" : "sweep.parameter",
                  fmt::format("the flow of '{}' feels the fibers, so that every value needs a filling of its "
                              "own",
                              name),
                  "leave one parameter free and sweep that from sweep.lower to sweep.upper, or take "
                  "fibers.coupling = \"none\"");
  if (!swept) return;
  const std::vector<LawParameter>& parameters = chosen_law(attrition_menu(), values.law)->parameters;
  const std::vector<double> start = law_values(attrition_menu(), values.law);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == sweep.parameter && !(*sweep.lower <= start[i] && start[i] <= *sweep.upper))
      checker.error("law." + sweep.parameter,
                    fmt::format("not between {} and {}; the coupled flow of '{}' is computed there only",
                                checker.cite("sweep.lower"), checker.cite("sweep.upper"), name),
                    "begin between them");
}

/// Checks one molding against the law and what was measured in it.
void validate_molding_of(const CalibrationCase& values, std::size_t condition, CaseChecker& checker) {
  const std::string& name = values.conditions.names[condition];
  const MoldingCase molding = molding_of(values, condition);
  const MoldingFiberChoices& fibers = molding.fibers;
  if (!fibers.length && fibers.distribution.empty() && !fibers.number_average)
    checker.error("conditions.lengths", fmt::format("no length at the gates of '{}' is given", name),
                  "give lengths here or under [fibers] of the molding");
  if (fibers.number_average && needs_bins(values.law))
    checker.error("law.name",
                  fmt::format("{} follows distributions, but '{}' has mean lengths", values.law.name, name),
                  "give a distribution or a length under [fibers] of the molding");
  if (fibers.coupling != CouplingChoice::none) validate_coupled(values, name, checker);
  std::vector<std::string> places;
  for (const NamedPlace& place : molding.output.places) places.push_back(place.name);
  for (const MoldedLengths& one : values.data.lengths) {
    if (one.condition != name || std::find(places.begin(), places.end(), one.place) != places.end()) continue;
    const std::string near = nearest_word(one.place, places);
    checker.error("data.lengths", fmt::format("'{}' has no place \"{}\"", name, one.place),
                  near.empty()
                      ? "add it to output.places of the molding"
                      : fmt::format("did you mean \"{}\"? Places are output.places of the molding", near));
  }
}

}  // namespace

KeyRow<CalibrationConditions> moldings_key() {
  const char* text =
      "For lengths measured in molded parts: rows [case file of the study molding, change, ...] instead of "
      "rates; changes are names of variants or \"key=value\". [law] stands for the case's own law, "
      "conditions.lengths, where given, for its lengths at the gates.";
  // Files are named from the folder of the case.
  const auto add = [text](KeyTable& table, const std::string& name, CalibrationConditions& conditions) {
    const auto read = [folder = table.folder()](const std::vector<TomlValue>& row,
                                                const std::vector<TextRow>&) {
      return read_molding_row(row, folder);
    };
    items_key("moldings", &CalibrationConditions::moldings, {read, write_molding_row}, text,
              optional(R"([["plaque.toml", "machine.fill_time=1.5 s"]])"), "thesis 4.2, 4.3")
        .add(table, name, conditions);
  };
  return {"moldings", add};
}

KeyRow<CalibrationData> molded_lengths_key() {
  return items_key("lengths", &CalibrationData::lengths, {read_lengths, write_lengths},
                   "Mean lengths measured in molded parts, rows [condition, place, \"L_N\" or \"L_W\", "
                   "length, ...] with the lengths of as many samples as there are; the place is one of "
                   "output.places of the molding.",
                   optional(R"([["plaque", "Loc.1", "L_N", "0.93 mm", "0.88 mm"]])"),
                   "thesis table 10, figure 4.5");
}

void validate_moldings(const CalibrationCase& values, CaseChecker& checker) {
  validate_molding_keys(values, checker);
  if (!checker.is_sound() || checker.files_may_be_gone()) return;
  std::set<std::string> said;  // conditions may share a case file
  for (std::size_t i = 0; i < values.conditions.names.size(); ++i) {
    try {
      validate_molding_of(values, i, checker);
    } catch (const InputError& error) {
      for (InputProblem problem : error.problems()) {
        const std::string remedy = std::exchange(problem.remedy, {});
        if (!std::filesystem::exists(problem.file)) problem.file.clear();  // changes are in no file
        if (said.insert(problem.message()).second)
          checker.error("conditions.moldings", problem.message(), remedy);
      }
    }
  }
}

CaseEstimate molded_estimate(const CalibrationCase& values, CaseEstimate estimate) {
  std::int64_t fillings = 0;
  for (std::size_t i = 0; i < values.conditions.names.size(); ++i) {
    const MoldingCase molding = molding_of(values, i);
    const auto held = static_cast<double>(peak_memory_bytes());  // by the program, whatever the moldings take
    const CaseEstimate one = estimate_molding(molding);
    const bool coupled = molding.fibers.coupling != CouplingChoice::none;
    const std::int64_t count = coupled ? values.sweep.count : 1;
    fillings += count;
    estimate.facts.emplace_back(
        values.conditions.names[i],
        fmt::format("{:.4g} mm at the gates, {}", 1e3 * inlet_length(values, i),
                    coupled ? "the flow feels the fibers" : "the flow does not feel the fibers"));
    estimate.wall_seconds += static_cast<double>(count) * one.wall_seconds;
    estimate.memory_bytes += one.memory_bytes - held;
    if (coupled) continue;
    // The kept steps of the one filling, and about a thousand times the lengths alone.
    const double points = static_cast<double>(molding.numerics.layers) / 2 *
                          static_cast<double>(ShellMesh(molding_setup(molding).part.shell).node_count());
    const double steps = points * static_cast<double>(molding.numerics.steps);
    estimate.memory_bytes += kept_bytes * steps;
    estimate.wall_seconds += predictions * length_cost * steps;
  }
  // A run holds no less than the trials did.
  estimate.memory_bytes = std::max(estimate.memory_bytes, static_cast<double>(peak_memory_bytes()));
  estimate.facts.emplace_back("fillings", fmt::format("{}", fillings));
  estimate.assumption = "a few hundred predictions of each molding; profiles and bootstrap take more";
  return estimate;
}

}  // namespace fiberfate
