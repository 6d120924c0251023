// Evaluates micromechanical models of aligned short fibers.
#include "continuum/homogenisation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/entry_by_name.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/homogenisation_laws/halpin_tsai.hpp"
#include "continuum/homogenisation_laws/lielens.hpp"
#include "continuum/homogenisation_laws/mori_tanaka.hpp"

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

template <class... Laws>
std::vector<HomogenisationDescription> descriptions_of() {
  int number = 0;
  return {
      {Homogenisation{number++}, Laws::text.name, Laws::text.meaning, Laws::text.source, Laws::stiffness}...};
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

const std::vector<HomogenisationDescription>& homogenisations() {
  static const std::vector<HomogenisationDescription> all = descriptions_of<  //
      MoriTanaka,                                                             //
      HalpinTsai,                                                             //
      Lielens>();
  return all;
}

const HomogenisationDescription& description_of(Homogenisation model) {
  return homogenisations()[static_cast<std::size_t>(model)];
}

const char* name(Homogenisation model) {
  return description_of(model).name;
}

Homogenisation homogenisation_named(std::string_view wanted) {
  return entry_named(homogenisations(), "stiffness model", wanted).model;
}

Mat3 thermal_expansion(const ThermoelasticProperties& properties) {
  return contracted(inverse(properties.stiffness), properties.thermal_stress);
}

bool is_finite(const ThermoelasticProperties& properties) {
  const Mat6 compliance = inverse(properties.stiffness);
  return properties.stiffness.allFinite() && properties.thermal_stress.allFinite() &&
         compliance.allFinite() && (compliance.diagonal().array() != 0).all() &&
         thermal_expansion(properties).allFinite();
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
  properties.stiffness = description_of(model).aligned_stiffness(material, aspect_ratio);
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
