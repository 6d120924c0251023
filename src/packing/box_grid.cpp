// Divides a periodic or walled cell into boxes, for finding the rods near a rod.
#include "packing/box_grid.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace fiberfate {
namespace {

// Boxes per largest centre distance of two listed rods: finer ones test fewer pairs but are more to walk.
constexpr double refinement = 1;

int floor_divide(int a, int b) {
  return (a >= 0 ? a : a - b + 1) / b;
}

// Most boxes for each rod: a cell that is nearly empty needs no finer ones.
constexpr double boxes_a_rod = 64;

/// Number of boxes in each direction that are about `farthest` wide; wider where there would be too many.
IntVec3 box_count(const Chains& chains, double farthest) {
  Vec3 count;
  for (int i = 0; i < 3; ++i) count[i] = std::max(1.0, chains.cell.height(i) * refinement / farthest);
  const double most = boxes_a_rod * std::max(chains.rod_count(), 1);
  for (int i = 0; count.prod() > most && i < 3; ++i) {
    Eigen::Index widest = 0;
    const double largest = count.maxCoeff(&widest);
    count[widest] = std::max({1.0, std::cbrt(most), largest * most / count.prod()});
  }
  return count.cast<int>();
}

/// Largest centre distance of two rods that may be listed.
double farthest_centres(const Chains& chains, const NeighbourRange& range) {
  double longest = 0, thickest = 0;
  for (const FiberIndex fiber : chains.fibers()) {
    longest = std::max(longest, chains.rod_length[fiber]);
    thickest = std::max(thickest, chains.radius[fiber] * chains.swelling[fiber]);
  }
  return longest + 2 * thickest * range.swelling + range.reach + range.skin;
}

}  // namespace

BoxGrid::BoxGrid(const Chains& chains, const NeighbourRange& range)
    : to_fraction_(chains.cell.lattice.inverse()) {
  const double farthest = farthest_centres(chains, range);
  count_ = box_count(chains, farthest);
  for (int i = 0; i < 3; ++i) {
    const double height = chains.cell.height(i);
    periodic_[i] = chains.cell.boundary[i] == Boundary::periodic;
    span_[i] = static_cast<int>(std::ceil(farthest * count_[i] / height));
    if (periodic_[i]) farthest_image_ = std::max(farthest_image_, (span_[i] + count_[i] - 1) / count_[i]);
  }
}

IntVec3 BoxGrid::box(const Vec3& point) const {
  const Vec3 fraction = to_fraction_ * point;
  IntVec3 at;
  for (int i = 0; i < 3; ++i)
    at[i] = std::clamp(static_cast<int>(std::floor(fraction[i] * count_[i])), 0, count_[i] - 1);
  return at;
}

BoxIndex BoxGrid::number(const IntVec3& box) const {
  return BoxIndex((box[2] * count_[1] + box[1]) * count_[0] + box[0]);
}

IntVec3 BoxGrid::image(const IntVec3& box) const {
  return {floor_divide(box[0], count_[0]), floor_divide(box[1], count_[1]), floor_divide(box[2], count_[2])};
}

ImageIndex BoxGrid::number_of_image(const IntVec3& image) const {
  const int side = 2 * farthest_image_ + 1;
  return ImageIndex(((image[2] + farthest_image_) * side + image[1] + farthest_image_) * side + image[0] +
                    farthest_image_);
}

BoxRange BoxGrid::around(const IntVec3& box, int i) const {
  if (periodic_[i]) return {box[i] - span_[i], box[i] + span_[i]};
  return {std::max(0, box[i] - span_[i]), std::min(count_[i] - 1, box[i] + span_[i])};
}

}  // namespace fiberfate
