// Measures a population of fibers: lengths, orientation, curvature.
#pragma once

#include <span>
#include <vector>

#include "base/vector.hpp"
#include "fibers/state.hpp"
#include "microstructure/mean_lengths.hpp"

namespace fiberfate {

/// Whether every fiber counts alike or by its length (volume, for equal diameters).
enum class Weighting { number, length };

/// Averages the lengths of a population.
[[nodiscard]] MeanLengths mean_lengths(const FiberState& state);

/// Second-order orientation tensor A2 = <p p>. `length`: every rod by its length. `number`: every fiber
/// counts one, its rods share it by their lengths.
[[nodiscard]] Mat3 orientation_tensor(const FiberState& state, Weighting weighting);

/// Fourth-order orientation tensor A4 = <p p p p> as 6×6 plain components in the order 11, 22, 33, 23,
/// 31, 12.
[[nodiscard]] Eigen::Matrix<double, 6, 6> orientation_tensor4(const FiberState& state, Weighting weighting);

/// Counts fibers by length, or sums their lengths, in bins with the given rising edges (m); the last bin is
/// closed. Raises InputError for fewer than two edges, or some that do not rise.
[[nodiscard]] std::vector<double> length_histogram(const FiberState& state, std::span<const double> edges,
                                                   Weighting weighting);

/// Lists the radius of curvature of every hinge (hinge_radius), m.
[[nodiscard]] std::vector<double> hinge_radii(const FiberState& state);

/// Smallest radius of curvature of all hinges, m; infinity when there is none.
[[nodiscard]] double minimum_radius(const FiberState& state);

/// Counts the hinges with radius in [low, high) (figure 3.31: within 50 µm of critical).
[[nodiscard]] std::int64_t count_hinges(const FiberState& state, double low, double high);

}  // namespace fiberfate
