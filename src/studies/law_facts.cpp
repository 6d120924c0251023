// A chosen law and its parameters, for a report and for summary.json.
#include "studies/law_facts.hpp"

#include "base/units.hpp"

namespace fiberfate {

ShownAs shown_as(const LawParameter& parameter) {
  const std::string unit = friendly_unit(parameter);
  return unit.empty() ? ShownAs{}
                      : ShownAs{unit == "um" ? "µm" : unit, 1 / unit_factor(unit, parameter.unit)};
}

std::vector<Fact> law_facts(const LawMenu& menu, const std::string& label, const LawChoice& choice) {
  const LawMenuItem* law = chosen_law(menu, choice);
  if (law == nullptr) return {};
  std::vector<Fact> facts = {{label, law->name, "", law->summary}};
  const std::vector<double> values = law_values(menu, choice);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& parameter = law->parameters[i];
    const ShownAs shown = shown_as(parameter);
    // With the law's place in front: tau, n and xi are names of several laws.
    facts.push_back({label + ": " + parameter.name, shown.factor * values[i], shown.unit, parameter.meaning});
  }
  return facts;
}

void append_law(RunSummary& summary, const LawKeys& keys, const LawMenu& menu, const LawChoice& choice) {
  summary.own.emplace_back(keys.prefix + keys.name, choice.name);
  const LawMenuItem& law = *chosen_law(menu, choice);
  const std::vector<double> values = law_values(menu, choice);
  for (std::size_t i = 0; i < values.size(); ++i)
    summary.own.emplace_back(keys.prefix + law.parameters[i].name, values[i]);
}

}  // namespace fiberfate
