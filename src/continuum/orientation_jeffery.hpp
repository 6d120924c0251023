// Gives Jeffery's motion without approximation: of one fiber, and of an initially isotropic population.
#pragma once

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Rate of a fiber's direction, dp/dt = W·p + xi (D·p - (p·D·p) p), 1/s.
/// Source: Jeffery, Proc. R. Soc. A 102, 161 (1922).
[[nodiscard]] Vec3 jeffery_rate(const Vec3& direction, const Mat3& gradient, double xi);

/// Effective deformation F = exp((W + xi D) t): material lines that move with it turn as the fibers do. A
/// negative duration goes back: F(-t) = F(t)⁻¹.
[[nodiscard]] Mat3 fiber_deformation(const Mat3& gradient, double xi, double duration);

/// Direction after a deformation, F·p/|F·p|: exact for constant gradients, and for histories with F the
/// product of those of its intervals, the latest on the left.
[[nodiscard]] Vec3 carried_direction(const Vec3& direction, const Mat3& deformation);

/// A2 after a deformation from an isotropic state without diffusion, exact: psi = (1/4 pi) (p·C·p)^(-3/2)
/// with C = (F·Fᵀ)⁻¹, and A2 has the axes of C and the principal values R_D(b_j, b_k, b_i)/3, b those of C.
/// Requires det F = 1 (an incompressible flow). Source: Montgomery-Smith et al., J.
/// Fluid Mech. 680, 321 (2011).
[[nodiscard]] Mat3 carried_isotropic_state(const Mat3& deformation);

/// Period after which a fiber in simple shear points along its first direction again (half an orbit's turn is
/// pi (r + 1/r)/rate): 2 pi (r + 1/r)/rate, s.
[[nodiscard]] double jeffery_period(double aspect_ratio, double rate);

}  // namespace fiberfate
