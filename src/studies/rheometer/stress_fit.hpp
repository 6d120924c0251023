// Fits laws of the stress that fibers add to readings of it.
#pragma once

#include <cstddef>
#include <span>

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// The stationary means of one run.
struct StressReading {
  double viscosity = 0;             ///< eta of the matrix, Pa s
  double volume_fraction = 0;       ///< phi
  Mat3 strain_rate = Mat3::Zero();  ///< D, 1/s
  Mat6 fourth = Mat6::Zero();       ///< A4 as [ij][kl]
  Mat3 stress = Mat3::Zero();       ///< that the fibers add, Pa
  double relative_viscosity = 1;    ///< 1 + sigma:D/(2 eta D:D)
};

/// A number with its standard error and its interval of 95 %; NaN where there are too few readings.
struct FittedNumber {
  double value = 0, error = 0, lower = 0, upper = 0;
};

/// N_p of the stress 2 eta phi N_p A4:D (2.12).
struct ParticleNumberFit {
  FittedNumber particle_number;
  double explained = 0;  ///< share of the sum of squares of the stresses that the law explains
};

/// Fits N_p by least squares over the components of all readings. Stress and law are taken without their
/// isotropic parts, which the pressure hides, and over 2 eta phi |D|, so that every reading counts alike:
///   N_p = sum s_i : m_i / sum m_i : m_i,  s = dev sigma/(2 eta phi |D|),  m = dev(A4:D)/|D|.
/// The error comes from the scatter between the readings, with h_i = m_i : m_i / sum m : m the weight of one:
///   error² = sum (s_i : m_i − N_p m_i : m_i)²/(1 − h_i) / (sum m : m)²,
/// for equal weights that of the mean of n values. The interval is Student's with 1/sum h_i² − 1 degrees of
/// freedom. Neglected: that readings of one packing belong together. Readings at rest, without fibers or not
/// finite are left out. Source of the law: Tucker, J. Non-Newton. Fluid Mech. 39, 239 (1991); of the error:
/// MacKinnon, White, J. Econometrics 29, 305 (1985), HC2; of the degrees of freedom: Kish, Survey Sampling,
/// Wiley 1965, section 11.7.
[[nodiscard]] ParticleNumberFit fit_particle_number(std::span<const StressReading> readings);

/// eta_S and R_T of the viscosity eta_S (1 + R_T (D:A4:D)/(D:D)) (2.11).
struct TroutonFit {
  FittedNumber viscosity_ratio;               ///< eta_S over the viscosity of the matrix
  FittedNumber trouton_term;                  ///< R_T
  double scatter = 0;                         ///< standard deviation of the relative viscosity about the law
  double least_share = 0, largest_share = 0;  ///< x of the readings
  std::size_t readings = 0;
  /// Whether the interval of R_T is narrower than R_T itself.
  [[nodiscard]] bool is_told() const;
  /// The relative viscosity at a stretching share x.
  [[nodiscard]] double at(double share) const;
};

/// Fits the informed-isotropic law by linear regression of the relative viscosity on x = (D:A4:D)/(D:D), all
/// readings alike: eta_S/eta is the ordinate at x = 0 and R_T the slope over it, whose error is propagated to
/// first order from the covariance of both. Student's intervals with n − 2 degrees of freedom. NaN for less
/// than three readings, or where x does not vary. Source of the law: Favaloro, Tseng, Pipes, Composites A
/// 115, 207 (2018).
[[nodiscard]] TroutonFit fit_trouton_term(std::span<const StressReading> readings);

}  // namespace fiberfate
