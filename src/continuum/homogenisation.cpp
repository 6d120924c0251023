// Evaluates micromechanical models of aligned short fibers.
#include "continuum/homogenisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/entry_by_name.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

/// The two functions of the aspect ratio r that Eshelby's tensor is made of; G/2 is the depolarisation
/// factor across the axis and H = (2 - 3 G)/(r² - 1).
struct ShapeIntegrals {
  double g = 0, h = 0;
};

/// Series in s = 1 - 1/r², for spheroids near the sphere: (1-s) sum s^k/(2k+3) is the factor along the axis.
ShapeIntegrals near_sphere(double s) {
  double along = 0, tail = 0, power = 1;
  for (int k = 0; k < 24; ++k, power *= s) {
    along += power / (2 * k + 3);
    tail += power / ((2 * k + 3.0) * (2 * k + 5.0));
  }
  return {1 - (1 - s) * along, -6 * (1 - s) * tail};
}

ShapeIntegrals shape_integrals(double r) {
  const double s = 1 - 1 / (r * r);
  if (std::abs(s) < 0.2) return near_sphere(s);
  const double u = r * r - 1;
  const double root = std::sqrt(std::abs(u));
  const double angle = r > 1 ? std::acosh(r) : std::acos(r);
  const double along = (r * angle / root - 1) / u;
  const double g = 1 - along;
  return {g, (2 - 3 * g) / u};
}

/// Halpin and Tsai's interpolation M (1 + zeta eta phi)/(1 - eta phi), eta = (F/M - 1)/(F/M + zeta).
double interpolated(double fiber, double matrix, double zeta, double fraction) {
  const double eta = (fiber / matrix - 1) / (fiber / matrix + zeta);
  return matrix * (1 + zeta * eta * fraction) / (1 - eta * fraction);
}

Mat6 halpin_tsai(const CompositeMaterial& material, double r) {
  const double fraction = material.volume_fraction;
  const auto& [fiber_modulus, fiber_poisson] = material.fiber;
  const auto& [matrix_modulus, nu] = material.matrix;
  const double fiber_shear = fiber_modulus / (2 * (1 + fiber_poisson));
  const double matrix_shear = matrix_modulus / (2 * (1 + nu));
  EngineeringConstants c;
  c.e1 = interpolated(fiber_modulus, matrix_modulus, 2 * r, fraction);
  c.e2 = c.e3 = interpolated(fiber_modulus, matrix_modulus, 2, fraction);
  c.g12 = c.g31 = interpolated(fiber_shear, matrix_shear, 1, fraction);
  c.g23 = interpolated(fiber_shear, matrix_shear, (1 + nu) / (3 - nu - 4 * nu * nu), fraction);
  c.nu12 = fiber_poisson * fraction + nu * (1 - fraction);
  c.nu31 = c.nu12 * c.e3 / c.e1;
  c.nu23 = c.e2 / (2 * c.g23) - 1;
  return orthotropic_stiffness(c);
}

/// Strain in the inclusion over strain far away: (I + S : M⁻¹ : (F - M))⁻¹.
Mat6 dilute_concentration(const Mat6& eshelby, const Mat6& inclusion, const Mat6& matrix) {
  const Mat6 contrast = composed(inverse(matrix), inclusion - matrix);
  return inverse(symmetric_identity() + composed(eshelby, contrast));
}

/// Mean stress over mean strain when the strain in the fibers is `concentration` times that in the matrix.
Mat6 averaged_stiffness(const CompositeMaterial& material, const Mat6& concentration) {
  const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
  const double fraction = material.volume_fraction;
  const Mat6 stress = (1 - fraction) * matrix + fraction * composed(fiber, concentration);
  return composed(stress, inverse((1 - fraction) * symmetric_identity() + fraction * concentration));
}

/// Every fiber in the strain of the matrix: the lower bound where fibers are stiffer.
Mat6 lower_concentration(const CompositeMaterial& material, double r) {
  const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
  return dilute_concentration(eshelby_tensor(r, material.matrix.poisson), fiber, matrix);
}

Mat6 mori_tanaka(const CompositeMaterial& material, double r) {
  return averaged_stiffness(material, lower_concentration(material, r));
}

/// The upper bound has the phases exchanged; Lielens' weight interpolates the inverses.
Mat6 lielens(const CompositeMaterial& material, double r) {
  const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
  const Mat6 upper = dilute_concentration(eshelby_tensor(r, material.fiber.poisson), matrix, fiber);
  const double weight = 0.5 * material.volume_fraction * (1 + material.volume_fraction);
  return averaged_stiffness(
      material, inverse((1 - weight) * inverse(lower_concentration(material, r)) + weight * upper));
}

constexpr HomogenisationDescription descriptions[] = {
    {Homogenisation::halpin_tsai, "halpin_tsai",
     "Semi-empirical interpolation; may give a material without energy (stores_energy).",
     "Halpin, Kardos, Polym. Eng. Sci. 16, 344 (1976)", halpin_tsai},
    {Homogenisation::mori_tanaka, "mori_tanaka", "Mean field with Eshelby's tensor.",
     "Benveniste, Mech. Mater. 6, 147 (1987)", mori_tanaka},
    {Homogenisation::lielens, "lielens",
     "Between the two Hashin-Shtrikman-Willis bounds; stiffer at high fractions.",
     "Lielens et al., Composites A 29, 63 (1998)", lielens}};

const HomogenisationDescription& description(Homogenisation model) {
  return *std::ranges::find(descriptions, model, &HomogenisationDescription::model);
}

Mat3 rosen_hashin(const CompositeMaterial& material, const Mat6& stiffness) {
  const Mat3 identity = Mat3::Identity();
  const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
  const Mat3 fiber_stress = contracted(fiber, material.fiber_expansion * identity);
  const Mat3 matrix_stress = contracted(matrix, material.matrix_expansion * identity);
  if ((fiber - matrix).cwiseAbs().maxCoeff() < 1e-12 * matrix.cwiseAbs().maxCoeff()) {
    if (material.fiber_expansion == material.matrix_expansion) return matrix_stress;
    throw InputError("fiber and matrix have the same moduli but different expansions",
                     "Rosen and Hashin's formula needs a contrast of moduli");
  }
  const Mat6 contrast = inverse(fiber - matrix);
  return contracted(fiber - stiffness, contracted(contrast, matrix_stress)) -
         contracted(matrix - stiffness, contracted(contrast, fiber_stress));
}

}  // namespace

std::span<const HomogenisationDescription> homogenisations() {
  return descriptions;
}

const char* name(Homogenisation model) {
  return description(model).name;
}

Homogenisation homogenisation_named(std::string_view wanted) {
  return entry_named(descriptions, "stiffness model", wanted).model;
}

Mat3 thermal_expansion(const ThermoelasticProperties& properties) {
  return contracted(inverse(properties.stiffness), properties.thermal_stress);
}

Mat6 eshelby_tensor(double aspect_ratio, double nu) {
  if (!(aspect_ratio > 0) || !std::isfinite(aspect_ratio) || !(nu > -1) || !(nu < 0.5))
    throw InputError(
        fmt::format("there is no Eshelby tensor for an aspect ratio of {:g} and nu = {:g}", aspect_ratio, nu),
        "the aspect ratio is positive and nu between -1 and 1/2");
  const auto [g, h] = shape_integrals(aspect_ratio);
  const double soft = 1 - 2 * nu;
  Mat6 e = Mat6::Zero();
  e(0, 0) = 2 * ((4 - 2 * nu) * (1 - g) + h);
  e(1, 1) = e(2, 2) = 1.5 + 0.75 * h + soft * g;
  e(1, 2) = e(2, 1) = 0.5 + 0.25 * h - soft * g;
  e(1, 0) = e(2, 0) = -h - 2 + 2 * (1 + nu) * g;
  e(0, 1) = e(0, 2) = -2 * soft * (1 - g) - h;
  e(3, 3) = 0.5 + 0.25 * h + soft * g;
  e(4, 4) = e(5, 5) = 0.5 * (soft * (2 - g) - 2 + 3 * g - 2 * h);
  return e / (4 * (1 - nu));
}

ThermoelasticProperties aligned_composite(const CompositeMaterial& material, double aspect_ratio,
                                          Homogenisation model) {
  if (!(material.volume_fraction >= 0) || !(material.volume_fraction <= 1))
    throw InputError(fmt::format("a fiber volume fraction of {:g} is impossible", material.volume_fraction),
                     "it lies between 0 and 1");
  require_number("fiber_expansion", material.fiber_expansion, any_finite);
  require_number("matrix_expansion", material.matrix_expansion, any_finite);
  if (!(aspect_ratio > 0) || !std::isfinite(aspect_ratio))
    throw InputError(fmt::format("an aspect ratio of {:g} is impossible", aspect_ratio), "it is positive");
  ThermoelasticProperties properties;
  properties.stiffness = description(model).aligned_stiffness(material, aspect_ratio);
  properties.thermal_stress = rosen_hashin(material, properties.stiffness);
  return properties;
}

ThermoelasticProperties length_average(const CompositeMaterial& material,
                                       std::span<const AspectRatioClass> classes, Homogenisation model) {
  ThermoelasticProperties sum;
  double shares = 0;
  for (const AspectRatioClass& one : classes) {
    if (!(one.volume_share >= 0) || !std::isfinite(one.volume_share))
      throw InputError(fmt::format("a volume share of {:g} is impossible", one.volume_share),
                       "shares are not negative");
    if (one.volume_share == 0) continue;
    const ThermoelasticProperties part = aligned_composite(material, one.aspect_ratio, model);
    sum.stiffness += one.volume_share * part.stiffness;
    sum.thermal_stress += one.volume_share * part.thermal_stress;
    shares += one.volume_share;
  }
  if (!(shares > 0))
    throw InputError("there are no fibers to average over", "give at least one class a share");
  return {sum.stiffness / shares, sum.thermal_stress / shares};
}

ThermoelasticProperties orientation_average(const ThermoelasticProperties& aligned, const Mat6& fourth,
                                            const Mat3& second) {
  return {orientation_average(aligned.stiffness, fourth, second),
          orientation_average(aligned.thermal_stress, second)};
}

}  // namespace fiberfate
