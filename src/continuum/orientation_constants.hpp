// The constants of orientation laws.
#pragma once

namespace fiberfate {

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

}  // namespace fiberfate
