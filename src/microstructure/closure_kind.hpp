// The closure approximations.
#pragma once

namespace fiberfate {

/// How A4 is made from A2.
enum class Closure {
  linear,     ///< exact for isotropic states; unstable in flow
  quadratic,  ///< exact for aligned states
  hybrid,     ///< linear and quadratic mixed with f = 1 - 27 det A
  ibof,       ///< invariant-based optimal fitting
  orf,        ///< orthotropic fitted, C_I = 0.01
  orw,        ///< orthotropic, wide range of C_I
  orw3,       ///< orthotropic, wide range, third order
  ore,        ///< orthotropic equivalent of the natural closure
  ors,        ///< orthotropic smooth
  orl,        ///< orthotropic fitted, low C_I
  orp,        ///< orthotropic peaked
  bingham,    ///< Bingham distribution, fitted
  exact       ///< exact for Jeffery's equation from an isotropic state (Carlson's R_D)
};

}  // namespace fiberfate
