// The choices and constants of an orientation law: rotary diffusion, retardation, closure.
#pragma once

#include "continuum/orientation_constants.hpp"
#include "microstructure/closure_kind.hpp"

namespace fiberfate {

/// The rotary diffusion tensor C, of which rate·C is the diffusivity of directions on the sphere: a place in
/// RotaryDiffusions (orientation_laws/orientation_laws.hpp), the first, Jeffery's C = 0, where nobody
/// chooses.
enum class RotaryDiffusion : int {};

/// The way in which the orientation is slower than the theory of dilute suspensions: a place in Retardations,
/// the first, none, where nobody chooses.
enum class Retardation : int {};

/// The choices that make an orientation law.
struct OrientationModel {
  RotaryDiffusion diffusion{};
  Retardation retardation{};
  Closure closure{};
  OrientationConstants constants = {};
};

}  // namespace fiberfate
