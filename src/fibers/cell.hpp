// Describes the cell that holds the fibers: a lattice that flows with the fluid, periodic or walled.
#pragma once

#include <Eigen/LU>
#include <array>

#include "base/vector.hpp"
#include "fibers/lattice_frame.hpp"

namespace fiberfate {

/// How the cell ends in the direction of one lattice vector.
enum class Boundary { periodic, walls };

/// The cell {lattice · s : 0 <= s_i < 1}.
struct Cell {
  Mat3 lattice = Mat3::Identity();  ///< H; its columns are the lattice vectors, m
  std::array<Boundary, 3> boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  LatticeFrame frame;  ///< how the lattice follows the flow; H = frame.lattice() but where it is carried

  [[nodiscard]] double volume() const { return lattice.determinant(); }
  /// Displacement of the image `image` (integers): H · image, m.
  [[nodiscard]] Vec3 shift(const IntVec3& image) const { return lattice * image.cast<double>(); }
  /// Distance between the faces that direction `i` separates, m.
  [[nodiscard]] double height(int i) const { return 1.0 / lattice.inverse().row(i).norm(); }
};

/// Makes a rectangular cell.
[[nodiscard]] Cell rectangular_cell(const Vec3& size);
/// Makes the cell of a lattice that reproduces itself, in a compact basis.
[[nodiscard]] Cell cell_of(const LatticeFrame& frame);

/// How fluid points move in `duration`: exp(kappa · duration).
[[nodiscard]] Mat3 flow_map(const Mat3& gradient, double duration);

/// Carries the lattice with the flow, dH/dt = kappa · H, exactly over `duration`: H ← exp(kappa · duration) ·
/// H. Walled directions keep their lattice vector (only simple shear along the walls is admissible there).
void deform(Cell& cell, const Mat3& gradient, double duration);

/// Whether some lattice vector can be shortened by adding one other, or both: for simple shear, whether the
/// tilt exceeds ±1/2.
[[nodiscard]] bool is_skewed(const Cell& cell);

/// Replaces a skewed basis by a reduced one of the same lattice and returns the unimodular matrix U with
/// H_new = H_old · U. For simple shear this is the Lees-Edwards reset. Images transform as n_new = U⁻¹ ·
/// n_old.
Eigen::Matrix3i reduce(Cell& cell);

/// Length of the shortest lattice vector of a compact basis, m: the distance of a point from its nearest
/// image.
[[nodiscard]] double nearest_image(const Cell& cell);

/// The image of the cell in which the point lies (0 in walled directions).
[[nodiscard]] IntVec3 image_of(const Cell& cell, const Vec3& point);

}  // namespace fiberfate
