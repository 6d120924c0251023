// Draws fiber directions whose second moment is a given orientation tensor.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "microstructure/admissibility.hpp"

namespace fiberfate {

/// The distributions that have a given A2.
enum class OrientationDistribution {
  angular_central_gaussian,  ///< p = B u / |B u|, u isotropic: smooth; B is fitted to A2
  subclusters,               ///< mixture of 3D-random, planar-random and aligned (thesis 3.28, 3.29)
};

/// Draws one direction for each weight (length of the fiber, m) such that sum(w p p) / sum(w) = `tensor`.
///
/// The directions are mapped points of a Fibonacci sphere, turned at random and dealt at random to the
/// fibers, so that the realised tensor is exact to round-off for both laws wherever enough fibers allow it
/// (see .cpp), and within 1 / count otherwise. Raises InputError as require_admissible.
[[nodiscard]] std::vector<Vec3> sample_orientations(const Mat3& tensor, std::span<const double> weights,
                                                    OrientationDistribution law, std::uint64_t seed);

/// Deals given directions (any length but zero) to fibers of these weights (length, m): each is used fibers /
/// directions times, the remainder at random; then all are turned a little, p ← M p / |M p|, so that
/// sum(w p p) / sum(w) is the mean p p of the list, as far as such turns can (two directions, say, keep their
/// shares). Raises InputError for an empty list or a direction of no length.
[[nodiscard]] std::vector<Vec3> deal_orientations(std::span<const Vec3> directions,
                                                  std::span<const double> weights, std::uint64_t seed);

/// Second moment sum(w p p) / sum(w) of unit directions.
[[nodiscard]] Mat3 second_moment(std::span<const Vec3> directions, std::span<const double> weights);

}  // namespace fiberfate
