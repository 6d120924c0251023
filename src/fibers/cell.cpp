// Moves, reduces and queries the flowing cell.
#include "fibers/cell.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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

/// A lattice vector that gets shorter by whole multiples of the two others.
struct Shortening {
  int vector;
  std::array<int, 3> multiples;  // of all three; 0 of itself
};

std::optional<Shortening> shortening_by_one(const Cell& cell) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!may_shorten(cell, i, j)) continue;
      Shortening found{i, {}};
      found.multiples[j] = static_cast<int>(std::lround(tilt(cell, i, j)));
      return found;
    }
  }
  return std::nullopt;
}

/// Once no vector can be shortened by one other, all that is left are the four diagonals.
std::optional<Shortening> shortening_by_both(const Cell& cell) {
  if (std::ranges::count(cell.boundary, Boundary::periodic) < 3) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (const auto& [p, q] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      const Vec3 shorter = cell.lattice.col(i) - p * cell.lattice.col(j) - q * cell.lattice.col(k);
      if (shorter.squaredNorm() >= (1 - tilt_tolerance) * cell.lattice.col(i).squaredNorm()) continue;
      Shortening found{i, {}};
      found.multiples[j] = p;
      found.multiples[k] = q;
      return found;
    }
  }
  return std::nullopt;
}

std::optional<Shortening> shortening(const Cell& cell) {
  const auto by_one = shortening_by_one(cell);
  return by_one ? by_one : shortening_by_both(cell);
}

}  // namespace

Cell rectangular_cell(const Vec3& size) {
  Cell cell;
  cell.lattice = size.asDiagonal();
  return cell;
}

Cell cell_of(const LatticeFrame& frame) {
  Cell cell;
  cell.frame = frame;
  cell.lattice = frame.lattice();
  reduce(cell);
  return cell;
}

Mat3 flow_map(const Mat3& gradient, double duration) {
  const Mat3 strain = gradient * duration;
  const bool nilpotent = (strain * strain).isZero(0);
  return nilpotent ? Mat3(Mat3::Identity() + strain) : Mat3(strain.exp());
}

void deform(Cell& cell, const Mat3& gradient, double duration) {
  if (cell.frame.kind != LatticeKind::carried) {
    cell.frame.flow(gradient, duration);
    cell.lattice = cell.frame.lattice();
    return;
  }
  const Mat3 deformation = flow_map(gradient, duration);
  for (int i = 0; i < 3; ++i) {
    if (cell.boundary[i] == Boundary::periodic) cell.lattice.col(i) = deformation * cell.lattice.col(i);
  }
}

bool is_skewed(const Cell& cell) {
  return shortening(cell).has_value();
}

Eigen::Matrix3i reduce(Cell& cell) {
  Eigen::Matrix3i change = Eigen::Matrix3i::Identity();
  while (const auto next = shortening(cell)) {
    for (int j = 0; j < 3; ++j) {
      cell.lattice.col(next->vector) -= next->multiples[j] * cell.lattice.col(j);
      change.col(next->vector) -= next->multiples[j] * change.col(j);
    }
  }
  if (cell.frame.kind != LatticeKind::carried) {
    cell.frame.basis = cell.frame.basis * change;
    cell.lattice = cell.frame.lattice();
  }
  return change;
}

double nearest_image(const Cell& cell) {
  return cell.lattice.colwise().norm().minCoeff();
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
