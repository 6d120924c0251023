// Converts elastic stiffness, compliance and engineering constants, and averages them over orientations.
#pragma once

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// The constants of an isotropic elastic material.
struct IsotropicElasticity {
  double modulus = 0;  ///< Young's modulus E, Pa
  double poisson = 0;  ///< Poisson's ratio nu, -1 to 1/2
};

/// The constants of an orthotropic material along its axes: E_1, E_2, E_3, G_23, G_31, G_12 in Pa, and
/// nu_23, nu_31, nu_12 with nu_ij = -strain_j/strain_i under stress along i.
struct EngineeringConstants {
  double e1 = 0, e2 = 0, e3 = 0;
  double g23 = 0, g31 = 0, g12 = 0;
  double nu23 = 0, nu31 = 0, nu12 = 0;
};

/// Makes C_ijkl = lambda d_ij d_kl + mu (d_ik d_jl + d_il d_jk), Pa. Raises InputError unless E > 0 and -1 <
/// nu < 1/2.
[[nodiscard]] Mat6 isotropic_stiffness(const IsotropicElasticity& material);
/// Makes the stiffness of an orthotropic material, Pa. Its energy may turn out negative (stores_energy
/// tells): Halpin and Tsai's constants, which are independent of each other, do not rule that out.
[[nodiscard]] Mat6 orthotropic_stiffness(const EngineeringConstants& constants);
/// Whether every strain stores energy, as in any real material.
[[nodiscard]] bool stores_energy(const Mat6& stiffness);
/// Young's modulus along a unit vector, 1/(nn : S : nn) with the compliance S, Pa.
[[nodiscard]] double youngs_modulus_along(const Mat6& compliance, const Vec3& direction);
/// Reads the engineering constants along the axes 1, 2, 3 from a stiffness; couplings of shear are ignored.
[[nodiscard]] EngineeringConstants engineering_constants(const Mat6& stiffness);

/// Averages a tensor that is transversely isotropic about axis 1 over orientations:
///   <T>_ijkl = B1 A_ijkl + B2 A_ij d_kl + B2' d_ij A_kl + B3 (A_ik d_jl + A_il d_jk + A_jl d_ik + A_jk d_il)
///            + B4 d_ij d_kl + B5 (d_ik d_jl + d_il d_jk).
/// T may lack the major symmetry (strain concentration). Source: Advani, Tucker, J. Rheol. 31, 751 (1987),
/// eq. 30.
[[nodiscard]] Mat6 orientation_average(const Mat6& unidirectional, const Mat6& fourth, const Mat3& second);
/// Averages a second-order tensor that is transversely isotropic about axis 1: (T_1 - T_2) A + T_2 I.
[[nodiscard]] Mat3 orientation_average(const Mat3& unidirectional, const Mat3& second);

}  // namespace fiberfate
