// Strains lattices along the axes of a flow, and returns them.
#include "fibers/lattice_frame.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

using IntMat3 = Eigen::Matrix3i;

// A gradient counts as having the axes when what is left beside them is below this share of it.
constexpr double round_off = 1e-9;

/// The strains at which a lattice is itself again, in other bases.
struct Returns {
  Mat3 shape;                           ///< first lattice of a cell of volume 1
  std::array<Vec3, 2> strain;           ///< by which it returns
  std::array<IntMat3, 2> automorphism;  ///< F(strain) · shape = shape · automorphism
};

IntMat3 whole(std::array<int, 9> rows) {
  return Eigen::Map<const Eigen::Matrix<int, 3, 3, Eigen::RowMajor>>(rows.data());
}

IntMat3 inverse(const IntMat3& m) {
  return m.cast<double>().inverse().array().round().matrix().cast<int>();
}

IntMat3 power(const IntMat3& m, int exponent) {
  const IntMat3 factor = exponent < 0 ? inverse(m) : m;
  IntMat3 product = IntMat3::Identity();
  for (int i = 0; i < std::abs(exponent); ++i) product = product * factor;
  return product;
}

/// Newton's correction of an orthogonal matrix to the last digit.
Mat3 orthogonal(const Mat3& m) {
  return 0.5 * m * (3 * Mat3::Identity() - m.transpose() * m);
}

/// Makes the returns of commuting symmetric automorphisms: their common eigenvectors are the first lattice.
Returns returns_of(const Mat3& eigenvectors, const std::array<IntMat3, 2>& automorphisms) {
  Returns all{eigenvectors.transpose(), {}, automorphisms};
  if (all.shape.determinant() < 0) all.shape.row(2) *= -1;
  for (std::size_t i = 0; i < 2; ++i) {
    const Mat3 product = all.shape * automorphisms[i].cast<double>() * all.shape.transpose();
    for (int axis = 0; axis < 3; ++axis) all.strain[i][axis] = std::log(product(axis, axis));
  }
  return all;
}

Returns planar_returns() {
  const IntMat3 n = whole({2, 1, 0, 1, 1, 0, 0, 0, 1});
  const double golden = 0.5 * (1 + std::sqrt(5.0)), norm = std::sqrt(1 + golden * golden);
  Mat3 vectors = Mat3::Identity();
  vectors.topLeftCorner<2, 2>() << golden / norm, -1 / norm, 1 / norm, golden / norm;
  Returns all = returns_of(vectors, {n, n});
  all.strain[1] = Vec3(0, 0, 1);  // never: nothing stretches the third axis
  all.automorphism[1] = IntMat3::Identity();
  return all;
}

Returns spatial_returns() {
  const IntMat3 m1 = whole({1, 1, 1, 1, 2, 2, 1, 2, 3});
  const IntMat3 m2 = whole({2, -2, 1, -2, 3, -1, 1, -1, 1});
  const Mat3 vectors = Eigen::SelfAdjointEigenSolver<Mat3>(m1.cast<double>()).eigenvectors();
  // Rising eigenvalues come last to first, so that the first axis is the one that m1 stretches most.
  return returns_of(orthogonal(vectors.rowwise().reverse()), {m1, m2});
}

const Returns& returns_of(LatticeKind kind) {
  static const Returns planar = planar_returns(), spatial = spatial_returns();
  return kind == LatticeKind::planar ? planar : spatial;
}

/// How many times the strain holds either return.
Eigen::Vector2d turns_in(const Returns& returns, const Vec3& strain) {
  Eigen::Matrix2d both;
  for (int i = 0; i < 2; ++i) both.col(i) = returns.strain[i].head<2>();
  if (returns.strain[0].z() == 0) return {strain.x() / returns.strain[0].x(), 0};
  return both.inverse() * strain.head<2>();
}

Mat3 stretch(const LatticeFrame& frame) {
  if (frame.kind != LatticeKind::rotating) return frame.strain.array().exp().matrix().asDiagonal();
  const double cosine = std::cos(frame.strain.x()), sine = std::sin(frame.strain.x());
  Mat3 turn = Mat3::Identity();
  turn.topLeftCorner<2, 2>() << cosine, sine, -sine, cosine;
  return turn;
}

/// Strains sum to nothing: no flow changes the volume.
void keep_volume(LatticeKind kind, Vec3& strain) {
  if (kind == LatticeKind::planar) strain = Vec3(strain.x(), -strain.x(), 0);
  if (kind == LatticeKind::spatial) strain.z() = -strain.x() - strain.y();
}

}  // namespace

const char* name(LatticeKind kind) {
  switch (kind) {
    case LatticeKind::planar:
      return "planar";
    case LatticeKind::spatial:
      return "spatial";
    case LatticeKind::rotating:
      return "rotating";
    default:
      return "carried";
  }
}

Mat3 LatticeFrame::lattice() const {
  return axes * stretch(*this) * first * basis.cast<double>();
}

Vec3 LatticeFrame::rates(const Mat3& gradient) const {
  const Mat3 own = axes.inverse() * gradient * axes;
  if (kind == LatticeKind::rotating) return {0.5 * (own(0, 1) - own(1, 0)), 0, 0};
  return own.diagonal();
}

bool LatticeFrame::follows(const Mat3& gradient) const {
  if (kind == LatticeKind::carried) return true;
  const Vec3 rate = rates(gradient);
  Mat3 own = rate.asDiagonal();
  if (kind == LatticeKind::rotating) {
    own.setZero();
    own(0, 1) = rate.x();
    own(1, 0) = -rate.x();
  }
  const double beside = (gradient - axes * own * axes.inverse()).norm();
  const double unmoved = kind == LatticeKind::planar ? std::abs(rate.z()) : 0;
  return beside + unmoved <= round_off * gradient.norm();
}

void LatticeFrame::flow(const Mat3& gradient, double duration) {
  strain += duration * rates(gradient);
  keep_volume(kind, strain);
  if (kind == LatticeKind::rotating) {
    strain.x() = std::remainder(strain.x(), 2 * pi);
    return;
  }
  const Returns& returns = returns_of(kind);
  const Eigen::Vector2d turns = turns_in(returns, strain);
  for (int i = 0; i < 2; ++i) {
    const int count = static_cast<int>(std::lround(turns[i]));
    if (count == 0) continue;
    strain -= count * returns.strain[i];
    basis = power(returns.automorphism[i], count) * basis;
  }
  keep_volume(kind, strain);
}

LatticeFrame stretched_frame(LatticeKind kind, const Mat3& axes, const Vec3& size) {
  LatticeFrame frame{kind, axes};
  const bool is_planar = kind != LatticeKind::spatial;
  // The axes change the volume; what they stretch is taken from those directions that flow.
  const double share = std::pow(axes.determinant(), is_planar ? -1.0 / 2 : -1.0 / 3);
  const Vec3 scale = is_planar ? Vec3(share, share, 1) : Vec3::Constant(share);
  const Mat3 shape = kind == LatticeKind::rotating ? Mat3::Identity() : returns_of(kind).shape;
  frame.first = scale.cwiseProduct(size).asDiagonal() * shape;
  return frame;
}

}  // namespace fiberfate
