// Lets a case choose a law of a registry and give its parameters: [law], [melt] and the like.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continuum/homogenisation.hpp"
#include "continuum/law_parameter.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_table.hpp"
#include "keys/text_keys.hpp"

namespace fiberfate {

/// Describes one law that may be chosen.
struct LawMenuItem {
  std::string name;
  std::string summary;
  std::string source;
  std::vector<LawParameter> parameters;
};
using LawMenu = std::vector<LawMenuItem>;

/// Lists the attrition, viscosity and orientation laws of their registries.
[[nodiscard]] const LawMenu& attrition_menu();
[[nodiscard]] const LawMenu& viscosity_menu();
[[nodiscard]] const LawMenu& orientation_menu();

/// Lists the models of the stiffness of aligned fibers.
[[nodiscard]] const std::vector<Choice<Homogenisation>>& stiffness_choices();

/// The name of a law and the parameters that the case gives, of whatever law.
struct LawChoice {
  std::string name;
  std::map<std::string, std::optional<double>> parameters;
};

/// The unit in which people write a parameter; empty for a pure number.
[[nodiscard]] std::string friendly_unit(const LawParameter& parameter);

/// Under which table a law is chosen and what it is for.
struct LawTable {
  std::string section;  ///< "law"
  std::string text;
  std::string example;  ///< name that a template shows
  Need need = Need::required;
  std::map<std::string, std::string> parameters = {};  ///< TOML values that a template shows, by name
};

/// Adds the key `name` and one for each parameter of any law of the menu.
void describe_law(KeyTable& table, const LawMenu& menu, const LawTable& where, LawChoice& choice);
/// Finds parameters that are missing, out of bounds, or of another law, and units that look mistaken.
void validate_law(const LawMenu& menu, const std::string& section, const LawChoice& choice,
                  CaseChecker& checker);

/// Finds the chosen law; null where the name is empty or unknown.
[[nodiscard]] const LawMenuItem* chosen_law(const LawMenu& menu, const LawChoice& choice);
/// Gives the values of the chosen law's parameters, in its order, standard values where the case gives none.
[[nodiscard]] std::vector<double> law_values(const LawMenu& menu, const LawChoice& choice);

}  // namespace fiberfate
