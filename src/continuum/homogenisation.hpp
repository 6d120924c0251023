// Predicts stiffness and thermal expansion of short-fiber composites.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "continuum/stiffness.hpp"

namespace fiberfate {

/// A model of aligned fibers: a place in homogenisations(), the first where nobody chooses.
enum class Homogenisation : int {};

/// Describes fiber and matrix.
struct CompositeMaterial {
  IsotropicElasticity fiber;
  IsotropicElasticity matrix;
  double fiber_expansion = 0;   ///< linear thermal expansion of the fiber, 1/K
  double matrix_expansion = 0;  ///< of the matrix, 1/K
  double volume_fraction = 0;   ///< of fibers, 0 to 1
};

/// Describes one model. To add one: its file in homogenisation_laws, a row in homogenisation.cpp, a test
/// (docs/develop/adding_a_point_law.md).
struct HomogenisationDescription {
  Homogenisation model;
  const char* name;     ///< as in case files, "mori_tanaka"
  const char* meaning;  ///< one sentence
  const char* source;   ///< author, year
  /// Stiffness (Pa) of fibers along axis 1 of one aspect ratio.
  Mat6 (*aligned_stiffness)(const CompositeMaterial& material, double aspect_ratio);
};

/// All models.
[[nodiscard]] const std::vector<HomogenisationDescription>& homogenisations();
[[nodiscard]] const HomogenisationDescription& description_of(Homogenisation model);
[[nodiscard]] const char* name(Homogenisation model);
/// Finds a model by name; raises InputError with the nearest name.
[[nodiscard]] Homogenisation homogenisation_named(std::string_view name);

/// The properties of a composite: C in Pa, thermal stress beta = C : alpha in Pa/K.
struct ThermoelasticProperties {
  Mat6 stiffness = Mat6::Zero();
  Mat3 thermal_stress = Mat3::Zero();
};

/// Thermal expansion alpha = C⁻¹ : beta, 1/K.
[[nodiscard]] Mat3 thermal_expansion(const ThermoelasticProperties& properties);

/// Whether stiffness, compliance and expansion are finite numbers: models far out of their range give others.
[[nodiscard]] bool is_finite(const ThermoelasticProperties& properties);

/// Eshelby's tensor of a spheroid about axis 1 with aspect ratio r in an isotropic matrix; spheres, fibers
/// and discs by one formula without cancellation. Raises InputError unless r > 0 and -1 < nu < 1/2. Source:
/// Taya, Arsenault, Metal Matrix Composites (1989), p. 250, rewritten with H = (2 - 3 G)/(r² - 1).
[[nodiscard]] Mat6 eshelby_tensor(double aspect_ratio, double matrix_poisson);

/// Predicts aligned fibers (along axis 1) of one aspect ratio. The thermal stress is that of Rosen and
/// Hashin, beta = (C_f - C) : (C_f - C_m)⁻¹ : beta_m + (C_m - C) : (C_m - C_f)⁻¹ : beta_f, exact for two
/// phases once C is given (Int. J. Eng. Sci. 8, 157 (1970)). Raises InputError for impossible input, or for
/// equal fiber and matrix moduli with different expansions, for which it is singular.
[[nodiscard]] ThermoelasticProperties aligned_composite(const CompositeMaterial& material,
                                                        double aspect_ratio, Homogenisation model);

/// A class of fibers of one length.
struct AspectRatioClass {
  double aspect_ratio = 0;
  double volume_share = 0;  ///< of the fibers' volume, any scale: N_i L_i for one diameter
};

/// Averages the aligned properties over a distribution of lengths, weighted by the fibers' volume: every
/// class is an aligned composite of the whole volume fraction (uniform strain between the classes).
[[nodiscard]] ThermoelasticProperties length_average(const CompositeMaterial& material,
                                                     std::span<const AspectRatioClass> classes,
                                                     Homogenisation model);

/// Averages aligned properties over orientations (uniform strain between the directions).
[[nodiscard]] ThermoelasticProperties orientation_average(const ThermoelasticProperties& aligned,
                                                          const Mat6& fourth, const Mat3& second);

}  // namespace fiberfate
