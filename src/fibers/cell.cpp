// Moves, reduces and queries the flowing cell.
#include "fibers/cell.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace fiberfate {
namespace {

// A basis vector counts as shortenable only beyond this excess over 1/2, so that a tilt of exactly 1/2 is
// stable.
constexpr double tilt_tolerance = 1e-9;

double tilt(const Cell& cell, int i, int j) {
  const Vec3 vector = cell.lattice.col(i);
  const Vec3 other = cell.lattice.col(j);
  return vector.dot(other) / other.squaredNorm();
}

bool may_shorten(const Cell& cell, int i, int j) {
  const bool periodic = cell.boundary[i] == Boundary::periodic && cell.boundary[j] == Boundary::periodic;
  return i != j && periodic && std::abs(tilt(cell, i, j)) > 0.5 + tilt_tolerance;
}

}  // namespace

Cell rectangular_cell(const Vec3& size) {
  Cell cell;
  cell.lattice = size.asDiagonal();
  return cell;
}

void deform(Cell& cell, const Mat3& gradient, double duration) {
  const Mat3 strain = gradient * duration;
  const bool nilpotent = (strain * strain).isZero(0);
  const Mat3 deformation = nilpotent ? Mat3(Mat3::Identity() + strain) : Mat3(strain.exp());
  for (int i = 0; i < 3; ++i) {
    if (cell.boundary[i] == Boundary::periodic) cell.lattice.col(i) = deformation * cell.lattice.col(i);
  }
}

bool is_skewed(const Cell& cell) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (may_shorten(cell, i, j)) return true;
    }
  }
  return false;
}

Eigen::Matrix3i reduce(Cell& cell) {
  Eigen::Matrix3i change = Eigen::Matrix3i::Identity();
  bool changed = true;
  while (changed) {
    changed = false;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (!may_shorten(cell, i, j)) continue;
        const int multiple = static_cast<int>(std::lround(tilt(cell, i, j)));
        cell.lattice.col(i) -= multiple * cell.lattice.col(j);
        change.col(i) -= multiple * change.col(j);
        changed = true;
      }
    }
  }
  return change;
}

IntVec3 image_of(const Cell& cell, const Vec3& point) {
  const Vec3 fraction = cell.lattice.inverse() * point;
  IntVec3 image = IntVec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (cell.boundary[i] == Boundary::periodic) image[i] = static_cast<int>(std::floor(fraction[i]));
  }
  return image;
}

}  // namespace fiberfate
