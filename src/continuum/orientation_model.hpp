// The choices and constants of an orientation law: rotary diffusion, retardation, closure.
#pragma once

#include "microstructure/closure_kind.hpp"

namespace fiberfate {

/// The rotary diffusion tensors C; rate·C is the diffusivity of directions on the sphere.
enum class RotaryDiffusion {
  none,           ///< Jeffery: C = 0
  folgar_tucker,  ///< C_I I
  ard,            ///< b1 I + b2 A + b3 A² + b4 D/rate + b5 D²/rate²
  iard,           ///< C_I (I - C_M D²/‖D²‖), ‖X‖ = sqrt(X:X/2)
  pard,           ///< C_I R diag(1, Omega, 1 - Omega) Rᵀ, R the axes of A
  mrd,            ///< C_I R diag(D1, D2, D3) Rᵀ
  wpt             ///< b1 I + b3 A²
};

/// The ways in which the orientation is slower than the theory of dilute suspensions.
enum class Retardation {
  none,
  rsc,  ///< reduced strain closure: the rates of the principal values times kappa
  rpr,  ///< retarding principal rate: r_i -> r_i - alpha (r_i - beta (r_i² + 2 r_j r_k))
  srf   ///< strain reduction factor: the whole rate times srf; not objective
};

/// Whether a retardation takes the rates of the principal values apart from the turning of the axes.
[[nodiscard]] inline bool acts_on_principal_values(Retardation retardation) {
  return retardation == Retardation::rsc || retardation == Retardation::rpr;
}

/// The constants of all laws; each law reads its own.
struct OrientationConstants {
  double xi = 1;     ///< shape factor (r²-1)/(r²+1), r the aspect ratio; 1 for slender fibers
  double c_i = 0;    ///< interaction coefficient C_I
  double c_m = 0;    ///< matrix interaction C_M of iARD
  double omega = 1;  ///< Omega of pARD
  double d1 = 1;     ///< D1 of MRD
  double d2 = 0;     ///< D2 of MRD
  double d3 = 0;     ///< D3 of MRD
  double b1 = 0;     ///< ARD and WPT
  double b2 = 0;     ///< ARD
  double b3 = 0;     ///< ARD and WPT
  double b4 = 0;     ///< ARD
  double b5 = 0;     ///< ARD
  double kappa = 1;  ///< RSC
  double alpha = 0;  ///< RPR
  double beta = 0;   ///< RPR, s
  double srf = 1;    ///< SRF
  double u0 = 0;     ///< Maier-Saupe potential U_0, with every diffusion
};

/// The choices that make an orientation law.
struct OrientationModel {
  RotaryDiffusion diffusion = RotaryDiffusion::none;
  Retardation retardation = Retardation::none;
  Closure closure = Closure::ibof;
  OrientationConstants constants = {};
};

}  // namespace fiberfate
