// Viscosity laws of polymer melts, by name.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "continuum/law_parameter.hpp"
#include "continuum/melt_state.hpp"

namespace fiberfate {

/// Gives the viscosity of a melt, at one state or at many.
class ViscosityLaw {
 public:
  ViscosityLaw() = default;
  ViscosityLaw(const ViscosityLaw&) = delete;
  ViscosityLaw& operator=(const ViscosityLaw&) = delete;
  virtual ~ViscosityLaw() = default;

  /// The viscosity, Pa s. Raises InputError for a state that no melt has (a negative rate, NaN,
  /// Cross-WLF without temperature), as `evaluate` does.
  [[nodiscard]] virtual double at(const MeltState& melt) const = 0;
  /// Evaluates n states; `temperatures` (K) and `pressures` (Pa) are used by Cross-WLF only and may be empty
  /// otherwise.
  virtual void evaluate(std::span<const double> rates, std::span<const double> temperatures,
                        std::span<const double> pressures, std::span<double> viscosities) const = 0;
};

/// Describes a law of the registry, as AttritionLawEntry does.
struct ViscosityLawEntry {
  std::string name;
  std::string summary;
  std::string source;  ///< author, journal, year; empty where there is none
  std::vector<LawParameter> parameters;
  std::unique_ptr<ViscosityLaw> (*make)(std::span<const double> values);
};

/// Gives all viscosity laws. To add one: a header like viscosity_cross.hpp, a row in viscosity_registry.cpp,
/// a test.
[[nodiscard]] const std::vector<ViscosityLawEntry>& viscosity_laws();
/// Finds a law by name; raises InputError with the nearest name when there is none.
[[nodiscard]] const ViscosityLawEntry& find_viscosity_law(std::string_view name);
/// Makes a law from the values of its parameters; raises InputError for a missing value or one outside its
/// bounds.
[[nodiscard]] std::unique_ptr<ViscosityLaw> make_viscosity_law(std::string_view name,
                                                               std::span<const double> values);

}  // namespace fiberfate
