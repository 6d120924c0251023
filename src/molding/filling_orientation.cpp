// What a filling tells of its fibers' orientation.
#include "microstructure/tensor.hpp"
#include "molding/filling.hpp"

namespace fiberfate {

Mat3 Filling::orientation(std::size_t node, std::size_t layer) const {
  const std::size_t point = node * layers().count() + layer;
  if (state().orientation[0].empty()) return Mat3::Zero();
  Vec6 a;
  for (std::size_t m = 0; m < 6; ++m) a[static_cast<Eigen::Index>(m)] = state().orientation[m][point];
  return rotated(to_matrix(a), mesh().frame(node));
}

Mat3 Filling::mean_orientation(std::size_t node) const {
  Mat3 sum = Mat3::Zero();
  for (std::size_t k = 0; k < layers().count(); ++k) sum += layers().widths()[k] * orientation(node, k);
  // The other half of the gap is the mirror image: components across it cancel.
  const Mat3& frame = mesh().frame(node);
  Mat3 local = frame.transpose() * sum * frame;
  local(0, 2) = local(2, 0) = local(1, 2) = local(2, 1) = 0;
  return frame * local * frame.transpose();
}

}  // namespace fiberfate
