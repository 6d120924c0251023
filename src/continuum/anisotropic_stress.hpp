// Gives the stress that fibers add to the melt, and the scalar viscosity that stands for it in coupled flow.
#pragma once

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Extra stress tau = 2 eta D + 2 eta phi N_p A4:D (2.12), Pa.
/// `viscosity` eta of the matrix (Pa s), `fiber_term` phi N_p (1), `strain` D (1/s), A4 as [ij][kl].
/// Raises InputError for numbers that are not finite or a negative viscosity or fiber term, as those below.
/// Neglected: Brownian stress, normal stresses of the matrix. Source: Tucker, J. Non-Newton. Fluid Mech. 39,
/// 239 (1991).
[[nodiscard]] Mat3 anisotropic_stress(double viscosity, double fiber_term, const Mat3& strain,
                                      const Mat6& fourth);

/// Share (D:A4:D)/(D:D) of the deformation that stretches fibers, 0 to 1. At D = 0 the mean over all
/// incompressible deformations, which is where a vanishing random motion leads to: (A_ijij - A_iijj/3)/5 =
/// 2/15 for any A4 of unit trace.
[[nodiscard]] double stretching_share(const Mat3& strain, const Mat6& fourth);

/// Informed-isotropic viscosity eta_eff = eta_s (1 + R (D:A4:D)/(D:D)) (2.11), Pa s; positive and finite at D
/// = 0. Source: Favaloro, Tseng, Pipes, Composites A 115, 207 (2018).
[[nodiscard]] double informed_isotropic_viscosity(double viscosity, double trouton_term, const Mat3& strain,
                                                  const Mat6& fourth);

/// Particle number N_p = r²/(3 ln sqrt(pi/phi)) of semi-dilute fibers of aspect ratio r and volume fraction
/// phi. Raises InputError unless r > 1 and 0 < phi < 1. Source: Dinh, Armstrong, J. Rheol. 28, 207 (1984),
/// aligned fibers, as in Tucker (1991).
[[nodiscard]] double particle_number(double aspect_ratio, double volume_fraction);

}  // namespace fiberfate
