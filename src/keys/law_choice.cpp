// Builds keys for laws from their registries.
#include "keys/law_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/viscosity.hpp"

namespace fiberfate {
namespace {

template <class Entry>
LawMenu menu_of(const std::vector<Entry>& entries) {
  LawMenu menu;
  for (const Entry& entry : entries)
    menu.push_back({entry.name, entry.summary, entry.source, entry.parameters});
  return menu;
}

template <class Choice>
void append_law(const OrientationChoice<Choice>& law, std::vector<std::string>& names, LawMenuItem& item) {
  names.insert(names.end(), law.constants.begin(), law.constants.end());
  item.summary += (item.summary.empty() ? "" : " ") + law.meaning;
  item.source += (item.source.empty() ? "" : "; ") + law.source;
}

LawMenu make_orientation_menu() {
  LawMenu menu;
  for (const NamedOrientationModel& model : named_orientation_models()) {
    std::vector<std::string> names = {"xi", "U0"};
    LawMenuItem item = {model.name, "", "", {}};
    append_law(description_of(model.diffusion), names, item);
    if (model.retardation != Retardation{}) append_law(description_of(model.retardation), names, item);
    for (const OrientationConstant& constant : orientation_constants())
      if (std::find(names.begin(), names.end(), constant.parameter.name) != names.end())
        item.parameters.push_back(constant.parameter);
    menu.push_back(std::move(item));
  }
  return menu;
}

std::string laws_with(const LawMenu& menu, const std::string& parameter) {
  std::vector<std::string> names;
  for (const LawMenuItem& item : menu)
    if (std::any_of(item.parameters.begin(), item.parameters.end(),
                    [&](const LawParameter& one) { return one.name == parameter; }))
      names.push_back(item.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void describe_parameter(KeyTable& table, const LawMenu& menu, const LawTable& where,
                        const LawParameter& parameter, std::optional<double>& member) {
  std::string text = fmt::format("{}. For {}.", parameter.meaning, laws_with(menu, parameter.name));
  if (!std::isnan(parameter.standard_value))
    text += fmt::format(" Not given: {:g}{}{}.", parameter.standard_value, parameter.unit == "1" ? "" : " ",
                        parameter.unit == "1" ? "" : parameter.unit);
  KeyNotes notes = {.text = text, .unit = parameter.unit, .friendly = friendly_unit(parameter)};
  if (const auto shown = where.parameters.find(parameter.name); shown != where.parameters.end()) {
    notes.need = Need::usual;
    notes.example = shown->second;
  }
  table.quantity(where.section + '.' + parameter.name, member, std::move(notes));
}

void check_value(const std::string& key, const LawParameter& parameter, double value, CaseChecker& checker) {
  if (!std::isfinite(value) || value < parameter.lower || value > parameter.upper)
    checker.error(
        key, "out of range",
        "give " + describe_range(Range::between(parameter.lower, parameter.upper), {parameter.unit, ""}));
  // The thesis' strength, 2e10, is in dyn/cm^2: read as Pa it is ten times that of glass, and the law hides
  // it in its other parameters, since only the ratio of stress and strength enters.
  if (parameter.name == "sigma_u" && (value > 1e10 || value < 1e8))
    checker.warn(
        key,
        fmt::format("{:g} GPa is not the strength of a glass or carbon fiber (2 to 7 GPa)", 1e-9 * value),
        "check the unit: sigma_u and viscosity times rate must be in one (2e10 dyn/cm^2 are 2 GPa)");
}

}  // namespace

std::string friendly_unit(const LawParameter& parameter) {
  if (parameter.name == "d_f") return "um";
  if (parameter.name == "sigma_u" || parameter.name == "E_f") return "GPa";
  if (parameter.unit == "m") return "mm";
  return parameter.unit == "1" ? "" : parameter.unit;
}

const LawMenu& attrition_menu() {
  static const LawMenu menu = menu_of(attrition_laws());
  return menu;
}

const LawMenu& viscosity_menu() {
  static const LawMenu menu = menu_of(viscosity_laws());
  return menu;
}

const LawMenu& orientation_menu() {
  static const LawMenu menu = make_orientation_menu();
  return menu;
}

const std::vector<Choice<Homogenisation>>& stiffness_choices() {
  static const std::vector<Choice<Homogenisation>> choices = [] {
    std::vector<Choice<Homogenisation>> all;
    for (const HomogenisationDescription& one : homogenisations())
      all.push_back({one.model, one.name, one.meaning, one.source});
    return all;
  }();
  return choices;
}

void describe_law(KeyTable& table, const LawMenu& menu, const LawTable& where, LawChoice& choice) {
  table.section(where.section, where.text);
  NamedTexts names;
  for (const LawMenuItem& item : menu) names.push_back({item.name, item.summary, item.source});
  describe_name(table, where.section + ".name", choice.name, std::move(names),
                {.text = "The law.", .need = where.need, .example = where.example});
  std::vector<std::string> described;
  for (const LawMenuItem& item : menu) {
    for (const LawParameter& parameter : item.parameters) {
      if (std::find(described.begin(), described.end(), parameter.name) != described.end()) continue;
      described.push_back(parameter.name);
      describe_parameter(table, menu, where, parameter, choice.parameters[parameter.name]);
    }
  }
}

const LawMenuItem* chosen_law(const LawMenu& menu, const LawChoice& choice) {
  const auto found = std::find_if(menu.begin(), menu.end(),
                                  [&](const LawMenuItem& item) { return item.name == choice.name; });
  return found == menu.end() ? nullptr : &*found;
}

void validate_law(const LawMenu& menu, const std::string& section, const LawChoice& choice,
                  CaseChecker& checker) {
  const LawMenuItem* law = chosen_law(menu, choice);
  if (law == nullptr) return;
  const auto belongs = [&](const std::string& name) {
    return std::any_of(law->parameters.begin(), law->parameters.end(),
                       [&](const LawParameter& one) { return one.name == name; });
  };
  for (const auto& [name, value] : choice.parameters)
    if (value && !belongs(name))
      checker.warn_unused({section + '.' + name}, "the laws " + laws_with(menu, name));
  for (const LawParameter& parameter : law->parameters) {
    const std::string key = section + '.' + parameter.name;
    const auto given = choice.parameters.find(parameter.name);
    const bool is_given = given != choice.parameters.end() && given->second.has_value();
    if (is_given)
      check_value(key, parameter, *given->second, checker);
    else if (std::isnan(parameter.standard_value))
      checker.error(key, fmt::format("not given; the law {} needs it", law->name),
                    fmt::format("add {} under [{}]", parameter.name, section));
  }
}

std::vector<double> law_values(const LawMenu& menu, const LawChoice& choice) {
  std::vector<double> values;
  const LawMenuItem* law = chosen_law(menu, choice);
  if (law == nullptr) return values;
  for (const LawParameter& parameter : law->parameters) {
    const auto given = choice.parameters.find(parameter.name);
    values.push_back(given == choice.parameters.end() ? parameter.standard_value
                                                      : given->second.value_or(parameter.standard_value));
  }
  return values;
}

}  // namespace fiberfate
