// Decomposes symmetric tensors with Eigen's symmetric solver.
#include "microstructure/eigenframe.hpp"

#include <Eigen/Eigenvalues>

namespace fiberfate {
namespace {

/// Turns `count` axes from column `first` on so that the guide is diagonal in their space.
void turn_to_guide(Mat3& axes, const Mat3& guide, int first, int count) {
  const Eigen::MatrixXd space = axes.middleCols(first, count);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> inside(space.transpose() * guide * space);
  axes.middleCols(first, count) = space * inside.eigenvectors().rowwise().reverse();
}

void make_proper(Mat3& axes) {
  if (axes.col(0).cross(axes.col(1)).dot(axes.col(2)) < 0) axes.col(2) = -axes.col(2);
}

}  // namespace

Eigenframe eigenframe(const Mat3& tensor) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor);
  Eigenframe frame{solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
  make_proper(frame.axes);
  return frame;
}

Eigenframe eigenframe(const Mat3& tensor, const Mat3& guide) {
  Eigenframe frame = eigenframe(tensor);
  const bool first_two = frame.values[0] - frame.values[1] < equal_principal_values;
  const bool last_two = frame.values[1] - frame.values[2] < equal_principal_values;
  if (first_two && last_two) {
    turn_to_guide(frame.axes, guide, 0, 3);
  } else if (first_two) {
    turn_to_guide(frame.axes, guide, 0, 2);
  } else if (last_two) {
    turn_to_guide(frame.axes, guide, 1, 2);
  }
  make_proper(frame.axes);
  return frame;
}

}  // namespace fiberfate
