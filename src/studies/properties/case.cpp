// Describes the keys of the study properties, checks a case, and makes from it what the models take.
#include "studies/properties/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "keys/key_rows.hpp"
#include "keys/law_choice.hpp"
#include "microstructure/closure.hpp"
#include "packing/population.hpp"
#include "studies/length_choices.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

/// Keys that fibers and matrix share.
template <class Material>
KeyRows<Material> material_rows() {
  return {
      key("youngs_modulus", &Material::youngs_modulus, {"Pa", "GPa"}, Range::positive(1e13),
          "Young's modulus."),
      key("poisson_ratio", &Material::poisson_ratio, {}, Range::inside(-1, 0.5), "Poisson's ratio."),
      key("expansion", &Material::expansion, {"1/K"}, Range::between(-1e-2, 1e-2),
          "Linear thermal expansion."),
      key("density", &Material::density, {"kg/m3"}, Range::positive(1e5),
          "Density; it matters only with fibers.weight_fraction."),
  };
}

KeyGroup<CompositeFiberChoices> fiber_keys() {
  using Fibers = CompositeFiberChoices;
  const std::vector<Column> classes = {{"length", {"m", "mm"}, Range::positive(10)},
                                       {"number", {"1", "1"}, Range::not_negative()}};
  const KeyRows<Fibers> own = {
      key("volume_fraction", &Fibers::volume_fraction, {}, Range::between(0, 1),
          "Volume of the fibers over that of the part.", usual("\"13.2 %\"")),
      key("weight_fraction", &Fibers::weight_fraction, {}, Range::between(0, 1),
          "Weight of the fibers over that of the part, instead of volume_fraction.", optional("\"30 %\"")),
      key("aspect_ratio", &Fibers::aspect_ratio, {}, Range::positive(1e9), "Length over diameter.",
          usual("25")),
      key("length", &Fibers::length, {"m", "mm"}, Range::positive(10),
          "One length of all fibers, instead of aspect_ratio.", optional("\"2 mm\"")),
      rows_key("distribution", &Fibers::distribution, classes,
               "Rows [length, number of fibers], or the path of a text file with such rows in SI, "
               "distribution.csv of a measurement, say; the properties are averaged by volume.",
               optional(R"([["0.5 mm", 120], ["1 mm", 60], ["5 mm", 4]])")),
      key("diameter", &Fibers::diameter, {"m", "um"}, Range::positive(1e-2),
          "Diameter, which makes an aspect ratio of a length."),
      orientation_key("orientation", &Fibers::orientation, "Orientation tensor A2."),
  };
  return {"fibers", "The fibers; give one fraction, and an aspect ratio, a length or a distribution.",
          joined<Fibers>({own, material_rows<Fibers>()})};
}

KeyGroup<SolutionChoices> solution_keys() {
  return {"solution",
          "How properties are predicted (docs/theory/properties.md).",
          {
              key("model", &SolutionChoices::model, stiffness_choices(), "Stiffness of aligned fibers."),
              name_key("closure", &SolutionChoices::closure, closure_names(),
                       "How A4 is made from A2 (docs/theory/closures.md)."),
          }};
}

void validate_fraction(const CompositeFiberChoices& fibers, CaseChecker& checker) {
  if (fibers.volume_fraction.has_value() != fibers.weight_fraction.has_value()) return;
  if (checker.is_sound("fibers.volume_fraction") && checker.is_sound("fibers.weight_fraction"))
    checker.error(
        "fibers.volume_fraction",
        fibers.volume_fraction ? "contradicts " + checker.cite("fibers.weight_fraction")
                               : std::string("not given, nor is weight_fraction"),
        fibers.volume_fraction ? "remove one of the two" : "add volume_fraction = \"13.2 %\" under [fibers]");
}

constexpr int angle_steps = 72;

CsvTable modulus_table(const Mat6& stiffness) {
  const Mat6 compliance = inverse(stiffness);
  CsvTable table{{"angle_deg", "modulus_12_Pa", "modulus_13_Pa"}};
  for (int k = 0; k <= angle_steps; ++k) {
    const double angle = pi * k / angle_steps;
    table.append({180.0 * k / angle_steps,
                  youngs_modulus_along(compliance, {std::cos(angle), std::sin(angle), 0}),
                  youngs_modulus_along(compliance, {std::cos(angle), 0, std::sin(angle)})});
  }
  return table;
}

/// Whether every modulus is finite and positive.
bool is_real(const CsvTable& modulus) {
  for (std::size_t i = 1; i < modulus.columns.size(); ++i)
    for (const double value : modulus.values[i])
      if (!(value > 0) || !std::isfinite(value)) return false;
  return true;
}

void validate_lengths(const CompositeFiberChoices& fibers, CaseChecker& checker) {
  const int given =
      (fibers.aspect_ratio ? 1 : 0) + (fibers.length ? 1 : 0) + (fibers.distribution.empty() ? 0 : 1);
  const bool sound = checker.is_sound("fibers.aspect_ratio") && checker.is_sound("fibers.length") &&
                     checker.is_sound("fibers.distribution");
  if (given != 1 && sound)
    checker.error(
        "fibers.aspect_ratio",
        given == 0 ? "not given, nor is length or distribution" : "lengths are given in more than one way",
        "give one of aspect_ratio, length and distribution");
  validate_distribution(fibers.distribution, checker);
  if (fibers.aspect_ratio)
    checker.warn_unused({"fibers.diameter"}, "a case with fibers.length or fibers.distribution");
}

}  // namespace

void describe_properties(KeyTable& table, PropertiesCase& values) {
  describe(table, fiber_keys(), values.fibers);
  const KeyGroup<CompositeMatrixChoices> matrix = {"matrix", "The matrix; the defaults are polypropylene.",
                                                   material_rows<CompositeMatrixChoices>()};
  describe(table, matrix, values.matrix);
  describe(table, solution_keys(), values.solution);
}

void validate_properties(const PropertiesCase& values, CaseChecker& checker) {
  validate_fraction(values.fibers, checker);
  validate_lengths(values.fibers, checker);
  if (!values.fibers.weight_fraction)
    checker.warn_unused({"fibers.density", "matrix.density"}, "a case with fibers.weight_fraction");
  if (!checker.is_sound()) return;
  try {
    if (!stores_energy(predict(values).aligned.stiffness))
      checker.warn("solution.model", "gives a material that some strain would take energy from",
                   "take mori_tanaka or lielens, or other Poisson's ratios");
  } catch (const InputError& error) {
    const InputProblem& problem = error.problems().front();
    checker.error("fibers.youngs_modulus", problem.complaint, problem.remedy);
  }
}

CaseEstimate estimate_properties(const PropertiesCase& values) {
  CaseEstimate estimate;
  const std::vector<AspectRatioClass> classes = aspect_ratios(values.fibers);
  double shares = 0, ratio = 0;
  for (const AspectRatioClass& one : classes) {
    shares += one.volume_share;
    ratio += one.volume_share * one.aspect_ratio;
  }
  estimate.facts = {{"volume fraction", fmt::format("{:.6g}", composite_material(values).volume_fraction)},
                    {"aspect ratio, averaged by volume", fmt::format("{:.6g}", ratio / shares)}};
  estimate.memory_bytes = 1e7;
  Pace trial;
  static_cast<void>(predict(values));
  trial.reached(1);
  estimate.wall_seconds = trial.whole();
  estimate.assumption = "measured";
  return estimate;
}

PredictedProperties predict(const PropertiesCase& values) {
  PredictedProperties predicted{composite_material(values), {}, {}, {}};
  const Mat3& second = values.fibers.orientation;
  predicted.aligned = length_average(predicted.material, aspect_ratios(values.fibers), values.solution.model);
  predicted.part =
      orientation_average(predicted.aligned, close(second, closure_named(values.solution.closure)), second);
  if (!is_finite(predicted.aligned) || !is_finite(predicted.part))
    throw InputError("the model gives no finite stiffness or compliance",
                     "check the moduli (in Pa), Poisson's ratios and lengths");
  predicted.modulus = modulus_table(predicted.part.stiffness);
  if (!is_real(predicted.modulus))
    throw InputError(
        "the model gives a part that yields without a force in some direction",
        "take solution.model = \"mori_tanaka\", and check the moduli (in Pa) and Poisson's ratios");
  return predicted;
}

CompositeMaterial composite_material(const PropertiesCase& values) {
  const CompositeFiberChoices& fibers = values.fibers;
  const double fraction =
      fibers.weight_fraction
          ? volume_from_weight_fraction(*fibers.weight_fraction, fibers.density, values.matrix.density)
          : fibers.volume_fraction.value_or(0);
  const CompositeMatrixChoices& matrix = values.matrix;
  return {{fibers.youngs_modulus, fibers.poisson_ratio},
          {matrix.youngs_modulus, matrix.poisson_ratio},
          fibers.expansion,
          matrix.expansion,
          fraction};
}

std::vector<AspectRatioClass> aspect_ratios(const CompositeFiberChoices& fibers) {
  if (fibers.aspect_ratio) return {{*fibers.aspect_ratio, 1}};
  if (fibers.length) return {{*fibers.length / fibers.diameter, 1}};
  std::vector<AspectRatioClass> classes;
  for (const std::vector<double>& row : fibers.distribution)
    classes.push_back({row[0] / fibers.diameter, row[0] * row[1]});
  return classes;
}

}  // namespace fiberfate
