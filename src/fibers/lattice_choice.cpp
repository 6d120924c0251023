// Finds the axes that the flows of a history share.
#include "fibers/lattice_choice.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr double round_off = 1e-9;  // relative: less counts as nothing
constexpr const char* pack_anew = "pack the fibers anew for this flow: cluster.source = \"generate\"";

using Gradients = std::vector<Mat3>;

Gradients gradients_of(const FlowHistory& flow) {
  Gradients all;
  for (const FlowRow& row : flow.rows()) {
    const Mat3& gradient = row.flow.gradient;
    if (!gradient.isZero(0) && (all.empty() || gradient != all.back())) all.push_back(gradient);
  }
  return all;
}

bool is_simple_shear(const Mat3& gradient) {
  Mat3 rest = gradient;
  rest(0, 1) = 0;
  return rest.isZero(0);
}

bool is_diagonal(const Mat3& gradient) {
  return gradient.isDiagonal(0);
}

void require_volume(const Gradients& gradients) {
  for (const Mat3& gradient : gradients) {
    if (std::abs(gradient.trace()) > round_off * gradient.norm())
      throw InputError(
          fmt::format("a velocity gradient changes the volume: its diagonal adds up to {:.6g} 1/s",
                      gradient.trace()),
          "let the three numbers of the diagonal add up to zero");
  }
}

/// A combination in which no two axes have the same rate unless they have it in all gradients.
Mat3 combined(const Gradients& gradients) {
  Mat3 sum = Mat3::Zero();
  double weight = 1;
  for (const Mat3& gradient : gradients) {
    sum += weight / gradient.norm() * gradient;
    weight *= 0.7548776662466927;  // of no simple ratio
    if (weight < 1e-3) weight += 0.5;
  }
  return sum;
}

/// Turns a basis that is a mirror image.
Mat3 right_handed(Mat3 axes) {
  if (axes.determinant() < 0) axes.col(2) *= -1;
  return axes;
}

/// The real axes of a gradient as columns; nothing where it has none or less than three.
std::optional<Mat3> real_axes(const Mat3& gradient) {
  constexpr double flattest = 1e-5;  // volume of three unit vectors that still span the space
  if (is_diagonal(gradient)) return Mat3(Mat3::Identity());
  if ((gradient - gradient.transpose()).norm() <= round_off * gradient.norm())
    return right_handed(Eigen::SelfAdjointEigenSolver<Mat3>(gradient).eigenvectors());
  const Eigen::EigenSolver<Mat3> solver(gradient);
  if (solver.eigenvalues().imag().cwiseAbs().maxCoeff() > round_off * gradient.norm()) return {};
  const Mat3 axes = solver.eigenvectors().real().colwise().normalized();
  if (std::abs(axes.determinant()) < flattest) return {};
  return right_handed(axes);
}

/// The axis along which no gradient stretches, if there is one.
std::optional<int> unmoved_axis(const Gradients& gradients, const LatticeFrame& frame) {
  Vec3 largest = Vec3::Zero();
  for (const Mat3& gradient : gradients)
    largest = largest.cwiseMax(frame.rates(gradient).cwiseAbs() / gradient.norm());
  for (int axis = 2; axis >= 0; --axis) {
    if (largest[axis] <= round_off) return axis;
  }
  return {};
}

/// Puts an axis last; the others keep their order.
Mat3 with_last(const Mat3& axes, int last) {
  Mat3 ordered;
  int to = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != last) ordered.col(to++) = axes.col(axis);
  }
  ordered.col(2) = axes.col(last);
  return right_handed(ordered);
}

/// The size along axes that are those of space in another order; of others, as it is.
Vec3 size_along(const Mat3& axes, const Vec3& size) {
  const Mat3 order = axes.cwiseAbs();
  return order.isUnitary(round_off) ? Vec3(order.transpose() * size) : size;
}

std::optional<LatticeFrame> stretched(const Gradients& gradients, const Vec3& size) {
  auto axes = real_axes(combined(gradients));
  if (!axes) return {};
  LatticeFrame frame{LatticeKind::spatial, *axes};
  if (const auto unmoved = unmoved_axis(gradients, frame)) {
    frame.kind = LatticeKind::planar;
    frame.axes = with_last(*axes, *unmoved);
  }
  return stretched_frame(frame.kind, frame.axes, size_along(frame.axes, size));
}

/// In axes of its own a planar flow that turns is a rotation: its points move on similar ellipses.
std::optional<LatticeFrame> rotating(const Mat3& gradient, const Vec3& size) {
  Mat3 beside = gradient;
  beside.topLeftCorner<2, 2>().setZero();
  if (beside.norm() > round_off * gradient.norm()) return {};
  const double squared = gradient.topLeftCorner<2, 2>().determinant();  // of the angular rate
  if (squared <= round_off * gradient.squaredNorm()) return {};
  Mat3 axes = Mat3::Identity();
  axes.col(1) = -gradient * axes.col(0) / std::sqrt(squared);
  if (axes.determinant() < 0) axes.col(1) *= -1;
  axes.leftCols<2>() /= std::sqrt(axes.determinant());
  return stretched_frame(LatticeKind::rotating, axes, size);
}

bool follows(const LatticeFrame& frame, const Gradients& gradients) {
  return std::ranges::all_of(gradients, [&](const Mat3& gradient) { return frame.follows(gradient); });
}

bool is_carried(const Gradients& gradients) {
  return std::ranges::all_of(gradients, is_simple_shear);
}

/// How long a box stands a flow before its images are a tenth of its edge apart.
struct Stand {
  double time = 0;    ///< s
  double strain = 0;  ///< integral of the largest principal rate
};
Stand stand_of_a_box(const Gradients& gradients, const FlowHistory& flow, const Vec3& size) {
  constexpr double smallest_share = 0.1, part = 0.02, most_strain = 100;
  double rate = 0;
  for (const Mat3& gradient : gradients) rate = std::max(rate, gradient.norm());
  Cell cell = rectangular_cell(size);
  const double limit = smallest_share * nearest_image(cell), step = part / rate;
  Stand stand;
  while (nearest_image(cell) > limit && stand.time * rate < most_strain) {
    const Flow now = flow.at(stand.time);
    deform(cell, now.gradient, step);
    if (is_skewed(cell)) reduce(cell);
    stand.time += step;
    stand.strain += step * principal_rate(now);
  }
  return stand;
}

/// The frame that stretches or turns with all gradients, if there is one.
std::optional<LatticeFrame> frame_for(const Gradients& gradients, const Vec3& size) {
  for (auto frame : {stretched(gradients, size), rotating(gradients.front(), size)}) {
    if (frame && follows(*frame, gradients)) return frame;
  }
  return {};
}

[[noreturn]] void refuse(const Gradients& gradients, const FlowHistory& flow, const Vec3& size) {
  const bool each_alone = std::ranges::all_of(gradients, [&](const Mat3& gradient) {
    return is_simple_shear(gradient) || frame_for({gradient}, size);
  });
  const char* reason =
      each_alone ? "its gradients have different axes"
                 : "its gradient turns and stretches at once, or shears along an axis that it stretches";
  const Stand stand = stand_of_a_box(gradients, flow, size);
  throw InputError(
      fmt::format("no lattice comes back to itself in this flow: {}; a box would be flat at {:.3g} s, a "
                  "strain of {:.3g}",
                  reason, stand.time, stand.strain),
      "give simple shear u_x(y), elongations along the same axes, or flows in x and y that are multiples of "
      "one");
}

// Strains up to this one visit every shape: the lattice subtracts its returns.
constexpr double widest_strain = 4;

/// How many strains to look at along each axis: the more parallel the axes, the faster a strain shears the
/// cell.
int samples_of(const LatticeFrame& frame) {
  constexpr double samples = 64, most_planar = 1e5, most_spatial = 400;
  const double slant = frame.axes.norm() * frame.axes.inverse().norm() / 3;
  return static_cast<int>(
      std::min(samples * slant, frame.kind == LatticeKind::spatial ? most_spatial : most_planar));
}

LatticeFrame strained_by(LatticeFrame frame, double first, double second) {
  if (frame.kind == LatticeKind::rotating) {
    frame.strain.x() += first;
    return frame;
  }
  const bool is_spatial = frame.kind == LatticeKind::spatial;
  const Vec3 strain = is_spatial ? Vec3(first, second, -first - second) : Vec3(first, -first, 0);
  frame.flow(frame.axes * strain.asDiagonal() * frame.axes.inverse(), 1);
  return frame;
}

}  // namespace

Cell cell_for(const FlowHistory& flow, const Vec3& size) {
  const Gradients gradients = gradients_of(flow);
  require_volume(gradients);
  if (is_carried(gradients)) return rectangular_cell(size);
  const auto frame = frame_for(gradients, size);
  if (!frame) refuse(gradients, flow, size);
  return cell_of(*frame);
}

void require_follows(const Cell& cell, const FlowHistory& flow) {
  const Gradients gradients = gradients_of(flow);
  if (gradients.empty()) return;
  if (cell.frame.kind != LatticeKind::carried) {
    if (follows(cell.frame, gradients)) return;
    throw InputError("the lattice of the cell is made for another flow", pack_anew);
  }
  const auto lies_flat = [&](int i) {
    return std::abs(cell.lattice(1, i)) <= round_off * cell.lattice.col(i).norm();
  };
  if (!is_carried(gradients))
    throw InputError("the cell is a box for simple shear u_x(y), and this flow would make it flat",
                     pack_anew);
  if (lies_flat(0) + lies_flat(1) + lies_flat(2) < 2)
    throw InputError("the layers of the cell's lattice are not those of a shear u_x(y)", pack_anew);
}

double nearest_image_ever(const Cell& cell) {
  if (cell.frame.kind == LatticeKind::carried) return nearest_image(cell);
  const bool is_spatial = cell.frame.kind == LatticeKind::spatial;
  const int samples = samples_of(cell.frame);
  double nearest = nearest_image(cell);
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < (is_spatial ? samples : 1); ++j) {
      const LatticeFrame strained =
          strained_by(cell.frame, widest_strain * i / samples, widest_strain * j / samples);
      nearest = std::min(nearest, nearest_image(cell_of(strained)));
    }
  }
  return nearest;
}

}  // namespace fiberfate
