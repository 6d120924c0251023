// Lists the orientation laws: rotary diffusions, retardations, their constants, and the names of common
// combinations.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "continuum/law_parameter.hpp"
#include "continuum/orientation_model.hpp"

namespace fiberfate {

/// Describes a constant of the orientation laws and where it is kept.
struct OrientationConstant {
  LawParameter parameter;
  double OrientationConstants::*member;
};

/// Describes one rotary diffusion or retardation; `constants` are those that it reads.
template <class Choice>
struct OrientationChoice {
  Choice choice;
  std::string name;
  std::string meaning;
  std::string source;
  std::vector<std::string> constants;
};

/// A combination as the literature names it, "iard_rpr".
struct NamedOrientationModel {
  std::string name;
  RotaryDiffusion diffusion;
  Retardation retardation;
};

/// Every constant. To add a diffusion or a retardation: its enumerator (orientation_model.hpp), its
/// formula in the compiled kernel (orientation_pack.hpp) and, for a diffusion, in rotary_diffusion, a row
/// here, a test (docs/develop/adding_a_point_law.md).
[[nodiscard]] const std::vector<OrientationConstant>& orientation_constants();
[[nodiscard]] const std::vector<OrientationChoice<RotaryDiffusion>>& rotary_diffusions();
[[nodiscard]] const std::vector<OrientationChoice<Retardation>>& retardations();
[[nodiscard]] const std::vector<NamedOrientationModel>& named_orientation_models();

[[nodiscard]] const char* name(RotaryDiffusion diffusion);
[[nodiscard]] const char* name(Retardation retardation);

/// Finds a choice by name; raises InputError with the nearest name.
[[nodiscard]] RotaryDiffusion rotary_diffusion_named(std::string_view name);
[[nodiscard]] Retardation retardation_named(std::string_view name);
/// Makes a model of neutral constants (OrientationConstants) from the name of a combination, "iard_rpr", and
/// that of a closure, "ibof".
[[nodiscard]] OrientationModel orientation_model_named(std::string_view name, std::string_view closure);

/// Sets one constant by its symbol, capitals and underscores aside ("C_I", "c_i"); raises InputError for a
/// name that no law knows.
void set_constant(OrientationModel& model, std::string_view name, double value);

/// Checks that every constant that the model reads is finite and admissible, and that what it does not read
/// is left alone; raises InputError with a problem for each fault, whose key is the constant, "C_I".
void require_admissible(const OrientationModel& model);

}  // namespace fiberfate
