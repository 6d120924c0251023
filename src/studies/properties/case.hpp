// A case of the study properties: the materials, lengths and orientation of a part made of short
// fibers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuum/homogenisation.hpp"
#include "io/csv_table.hpp"
#include "keys/case_checker.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// [fibers].
struct CompositeFiberChoices {
  double youngs_modulus = 73e9;  ///< Pa
  double poisson_ratio = 0.22;
  double expansion = 5e-6;  ///< 1/K
  double density = 2550;    ///< kg/m³
  double diameter = 19e-6;  ///< m
  std::optional<double> volume_fraction;
  std::optional<double> weight_fraction;
  std::optional<double> aspect_ratio;
  std::optional<double> length;                   ///< m
  std::vector<std::vector<double>> distribution;  ///< rows (length m, number)
  Mat3 orientation = Mat3::Identity() / 3;
};

/// [matrix].
struct CompositeMatrixChoices {
  double youngs_modulus = 1.5e9;  ///< Pa
  double poisson_ratio = 0.4;
  double expansion = 1e-4;  ///< 1/K
  double density = 905;     ///< kg/m³
};

/// [solution].
struct SolutionChoices {
  Homogenisation model{};
  std::string closure = "exact";  ///< at no cost here, and right for aligned, planar and isotropic fibers
};

struct PropertiesCase {
  CompositeFiberChoices fibers;
  CompositeMatrixChoices matrix;
  SolutionChoices solution;
};

void describe_properties(KeyTable& table, PropertiesCase& values);
void validate_properties(const PropertiesCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_properties(const PropertiesCase& values);

/// What a case predicts.
struct PredictedProperties {
  CompositeMaterial material;
  ThermoelasticProperties aligned;  ///< of fibers along axis 1
  ThermoelasticProperties part;     ///< of fibers with the case's orientation
  CsvTable modulus;                 ///< Young's modulus of the part over direction
};
/// Predicts; raises InputError where the models give no finite numbers.
[[nodiscard]] PredictedProperties predict(const PropertiesCase& values);

/// Makes what a valid case asks for.
[[nodiscard]] CompositeMaterial composite_material(const PropertiesCase& values);
[[nodiscard]] std::vector<AspectRatioClass> aspect_ratios(const CompositeFiberChoices& fibers);

}  // namespace fiberfate
