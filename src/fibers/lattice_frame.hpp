// Lattices that come back to a compact shape however far a flow stretches them.
#pragma once

#include <Eigen/Core>

#include "base/vector.hpp"

namespace fiberfate {

/// How the lattice of a cell follows the flow for ever.
enum class LatticeKind {
  carried,   ///< its vectors move with the fluid: simple shear, along which its layers slide (Lees-Edwards)
  planar,    ///< stretched within a plane (Kraynik and Reinelt)
  spatial,   ///< stretched along three axes (Dobson)
  rotating,  ///< turned within a plane by a flow that turns more than it stretches
};
[[nodiscard]] const char* name(LatticeKind kind);

/// A lattice that reproduces itself, as a function of the strain alone, so that round-off never grows:
///   H = axes · F(strain) · first · basis
/// with F = diag(exp(strain)) where the lattice is stretched, and the turn by the angle strain_0 about the
/// third axis where it rotates. Once F(strain) reaches F(period) the lattice is the first one again, in
/// another basis: F(period) · first = first · N with whole numbers N. Sources: Kraynik and Reinelt, Int. J.
/// Multiphase Flow 18, 1045 (1992); Dobson, J. Chem. Phys. 141, 184103 (2014).
struct LatticeFrame {
  LatticeKind kind = LatticeKind::carried;
  Mat3 axes =
      Mat3::Identity();  ///< S: the flow's own axes, kappa = S · diag · S⁻¹, or S · (angular rate) · S⁻¹
  Mat3 first = Mat3::Identity();  ///< S⁻¹ · H before any strain, m
  Vec3 strain = Vec3::Zero();     ///< logarithmic along the axes, since the last return; or an angle
  Eigen::Matrix3i basis = Eigen::Matrix3i::Identity();  ///< which basis of the lattice is used

  [[nodiscard]] Mat3 lattice() const;
  /// The rates of the strain under a velocity gradient that has these axes, 1/s.
  [[nodiscard]] Vec3 rates(const Mat3& gradient) const;
  /// Whether a velocity gradient has these axes, so that it only strains along them; always for `carried`,
  /// which asks for none.
  [[nodiscard]] bool follows(const Mat3& gradient) const;
  /// Strains the lattice, and subtracts whole returns; the lattice itself does not notice them.
  void flow(const Mat3& gradient, double duration);
};

/// Makes the frame of a lattice stretched along `axes` whose cell is `size` large along them; size is taken
/// as it is where the axes are at right angles, else the volume is.
[[nodiscard]] LatticeFrame stretched_frame(LatticeKind kind, const Mat3& axes, const Vec3& size);

}  // namespace fiberfate
