// Lists the laws of fiber attrition by name, with their parameters: what case files choose and calibration
// varies.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "continuum/attrition_law.hpp"
#include "continuum/law_parameter.hpp"

namespace fiberfate {

/// How a law changes lengths: classes of fibers approach a length, or the fibers of bins break.
enum class AttritionForm { relaxation, fragmentation };

/// Describes a law of the registry.
struct AttritionLawEntry {
  std::string name;     ///< as in case files, "stress_induced"
  std::string summary;  ///< one sentence with the equations
  std::string source;   ///< author, journal, year; empty where there is none
  std::vector<LawParameter> parameters;
  AttritionForm form;
  /// Makes the law from the values of its parameters, SI, in the order of `parameters`.
  std::unique_ptr<AttritionLaw> (*make)(std::span<const double> values);
};

/// Gives all laws. To add one: a header like unbreakable_length.hpp or durin_breakage.hpp, a row in
/// length_registry.cpp, a test (docs/develop/adding_a_point_law.md).
[[nodiscard]] const std::vector<AttritionLawEntry>& attrition_laws();

/// Finds a law by name; raises InputError with the nearest name when there is none.
[[nodiscard]] const AttritionLawEntry& find_attrition_law(std::string_view name);

/// Makes the law `name` from as many values as it has parameters; raises InputError when a value is NaN or
/// outside of its parameter's bounds.
[[nodiscard]] std::unique_ptr<AttritionLaw> make_attrition_law(std::string_view name,
                                                               std::span<const double> values);

}  // namespace fiberfate
