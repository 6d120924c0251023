// Lists the orientation laws: rotary diffusions, retardations, their constants, and the names of common
// combinations.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
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

struct RotaryDiffusionRow : OrientationChoice<RotaryDiffusion> {
  bool depends_on_orientation;  ///< C changes with A
};

struct RetardationRow : OrientationChoice<Retardation> {
  /// Factor by which small changes of the principal values are slower near a steady state.
  double (*slowness)(const OrientationConstants& constants);
  /// What is left of the rates of the principal values, 1/s; null where the law acts on the whole rate.
  Vec3 (*left)(const OrientationConstants& constants, const Vec3& rates);
};

/// A combination as the literature names it, "iard_rpr".
struct NamedOrientationModel {
  std::string name;
  RotaryDiffusion diffusion;
  Retardation retardation;
};

/// Every constant.
[[nodiscard]] const std::vector<OrientationConstant>& orientation_constants();
/// The laws of orientation_laws/orientation_laws.hpp; to add one: docs/develop/adding_an_orientation_law.md.
[[nodiscard]] const std::vector<RotaryDiffusionRow>& rotary_diffusions();
[[nodiscard]] const std::vector<RetardationRow>& retardations();
/// The combinations that have a name; every diffusion is one by itself.
[[nodiscard]] const std::vector<NamedOrientationModel>& named_orientation_models();

[[nodiscard]] const RotaryDiffusionRow& description_of(RotaryDiffusion diffusion);
[[nodiscard]] const RetardationRow& description_of(Retardation retardation);
[[nodiscard]] const char* name(RotaryDiffusion diffusion);
[[nodiscard]] const char* name(Retardation retardation);

/// Whether a retardation takes the rates of the principal values apart from the turning of the axes.
[[nodiscard]] bool acts_on_principal_values(Retardation retardation);

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
