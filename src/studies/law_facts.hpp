// A chosen law and its parameters, for a report and for summary.json.
#pragma once

#include <string>
#include <vector>

#include "keys/law_choice.hpp"
#include "results/report_document.hpp"
#include "results/summary.hpp"

namespace fiberfate {

/// Gives a unit as a report shows it: none for a pure number, whose unit is "1".
[[nodiscard]] inline std::string shown_unit(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

/// How numbers in SI are shown: times a factor, in a unit.
struct ShownAs {
  std::string unit;
  double factor = 1;
};
/// Shows the values of a parameter in the unit in which people write it.
[[nodiscard]] ShownAs shown_as(const LawParameter& parameter);

/// Lists the chosen law and its parameters; nothing where no law is chosen.
[[nodiscard]] std::vector<Fact> law_facts(const LawMenu& menu, const std::string& label,
                                          const LawChoice& choice);

/// The keys under which a law stands in summary.json: prefix + name, and prefix + each parameter.
struct LawKeys {
  std::string prefix, name;
};
/// Adds the chosen law and the values of its parameters.
void append_law(RunSummary& summary, const LawKeys& keys, const LawMenu& menu, const LawChoice& choice);

}  // namespace fiberfate
