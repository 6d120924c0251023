// Projects node vectors on the motions that stretch no rod and restores rod lengths.
#include "packing/chains.hpp"

namespace fiberfate {

void ChainConstraints::factorise(std::span<const Vec3> nodes, double rod_length) {
  rods_ = nodes.size() - 1;
  rod_length_ = rod_length;
  if (direction_.size() < rods_) {
    direction_.resize(rods_);
    reciprocal_pivot_.resize(rods_);
    ratio_.resize(rods_);
    unknown_.resize(rods_);
  }
  for (std::size_t i = 0; i < rods_; ++i) direction_[i] = (nodes[i + 1] - nodes[i]) / rod_length;
  reciprocal_pivot_[0] = 0.5;
  for (std::size_t i = 1; i < rods_; ++i) {
    const double off = -direction_[i - 1].dot(direction_[i]);
    ratio_[i] = off * reciprocal_pivot_[i - 1];
    reciprocal_pivot_[i] = 1 / (2 - ratio_[i] * off);
  }
}

void ChainConstraints::solve() {
  for (std::size_t i = 1; i < rods_; ++i) unknown_[i] -= ratio_[i] * unknown_[i - 1];
  unknown_[rods_ - 1] *= reciprocal_pivot_[rods_ - 1];
  for (std::size_t i = rods_ - 1; i-- > 0;)
    unknown_[i] = unknown_[i] * reciprocal_pivot_[i] - ratio_[i + 1] * unknown_[i + 1];
}

void ChainConstraints::project(Vec3* vectors) {
  for (std::size_t i = 0; i < rods_; ++i) unknown_[i] = direction_[i].dot(vectors[i + 1] - vectors[i]);
  solve();
  for (std::size_t i = 0; i < rods_; ++i) {
    vectors[i] += unknown_[i] * direction_[i];
    vectors[i + 1] -= unknown_[i] * direction_[i];
  }
}

void ChainConstraints::restore_lengths(Vec3* position, int corrections) {
  for (int correction = 0; correction < corrections; ++correction) {
    for (std::size_t i = 0; i < rods_; ++i) {
      const Vec3 rod = position[i + 1] - position[i];
      unknown_[i] = 0.5 * (rod.squaredNorm() / rod_length_ - rod_length_);
    }
    solve();
    for (std::size_t i = 0; i < rods_; ++i) {
      position[i] += unknown_[i] * direction_[i];
      position[i + 1] -= unknown_[i] * direction_[i];
    }
  }
}

}  // namespace fiberfate
