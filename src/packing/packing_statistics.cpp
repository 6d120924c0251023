// Measures overlap, curvature, orientation, contacts and pair distances of packed fibers.
#include "packing/packing_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "base/threads.hpp"
#include "fibers/closest_points.hpp"
#include "fibers/observables.hpp"
#include "fibers/state_check.hpp"
#include "packing/chains.hpp"
#include "packing/rod_neighbours.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t bin_count = 40;
constexpr double bin_width = 0.1;          // diameters
constexpr double contact_distance = 1.05;  // diameters
constexpr std::size_t sampled_rods = 1000;

/// The state in diameters of its thickest fiber.
Chains chains_of(const FiberState& state, double unit) {
  Chains chains;
  chains.cell = state.cell;
  chains.cell.lattice /= unit;
  chains.first_node = state.first_node;
  for (const Vec3& x : state.position) chains.position.push_back(x / unit);
  for (const FiberIndex f : state.fibers()) {
    double longest = 0;
    for (const RodIndex rod : state.rods(f)) longest = std::max(longest, state.rod_length[rod]);
    chains.rod_length.push_back(longest / unit);
    chains.radius.push_back(state.material(f).radius / unit);
    chains.swelling.push_back(1);
    chains.firmness.push_back(1);
  }
  return chains;
}

/// The point at share s of a rod, and the way to it from the nearest point of another fiber.
struct NearestPoint {
  RodIndex rod;
  double s;
  Vec3 away;
};

/// Whether a nearest point is nearest among its neighbours along the fiber too; a hinge belongs to the rod
/// that ends there.
bool is_locally_nearest(const Chains& chains, FiberIndex fiber, const NearestPoint& point) {
  if (point.s <= 0) return first_end(point.rod) == chains.begin_node(fiber);
  if (point.s < 1 || second_end(point.rod) == chains.last_node(fiber)) return true;
  return chains.axis(point.rod + 1).dot(point.away) >= 0;
}

/// Mean |sin| of the angle between two rods picked by length, over evenly picked rods.
double mean_sine(const Chains& chains) {
  std::vector<Vec3> rods;
  for (const FiberIndex fiber : chains.fibers()) {
    for (const RodIndex rod : chains.rods(fiber)) rods.push_back(chains.axis(rod));
  }
  const std::size_t stride = std::max<std::size_t>(1, rods.size() / sampled_rods);
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < rods.size(); i += stride) {
    for (std::size_t j = 0; j < i; j += stride) {
      sum += rods[i].cross(rods[j]).norm();
      weight += rods[i].norm() * rods[j].norm();
    }
  }
  return weight > 0 ? sum / weight : 0;
}

struct PairCounts {
  std::array<std::int64_t, bin_count> bins{};
  std::int64_t contacts = 0;
  double largest_overlap = 0;
};

PairCounts count_pairs(const Chains& chains) {
  RodNeighbours neighbours;
  neighbours.build(chains, {bin_count * bin_width, 0, 0});
  IndexedVector<FiberIndex, PairCounts> counts(chains.fiber_count());
  parallel_for(chains.fibers(), [&](FiberIndex fiber) {
    PairCounts& own = counts[fiber];
    for (const RodIndex rod : chains.rods(fiber)) {
      for (const NeighbourRod& other : neighbours.of(rod)) {
        const ClosestPoints p =
            closest_points(chains.segment(rod), shifted(chains.segment(other.rod), other.shift));
        const double touching = chains.radius[fiber] + chains.radius[other.fiber];
        own.largest_overlap = std::max(own.largest_overlap, 1 - p.distance / touching);
        if (!is_locally_nearest(chains, fiber, {rod, p.s, p.separation})) continue;
        if (!is_locally_nearest(chains, other.fiber, {other.rod, p.t, -p.separation})) continue;
        const auto bin = static_cast<std::size_t>(p.distance / touching / bin_width);
        if (bin < bin_count) ++own.bins[bin];
        if (p.distance < contact_distance * touching) ++own.contacts;
      }
    }
  });
  PairCounts total;
  for (const PairCounts& own : counts) {
    for (std::size_t b = 0; b < bin_count; ++b) total.bins[b] += own.bins[b];
    total.contacts += own.contacts;
    total.largest_overlap = std::max(total.largest_overlap, own.largest_overlap);
  }
  return total;
}

/// Expects how many fibers pass a fiber, when all are straight and placed at random: averages over pairs of
/// fibers i, j of 2 L_i L_j h <|sin|> + pi h² (L_i + L_j) + 4/3 pi h³ over the volume for each of N fibers,
/// with h = x (a_i + a_j). For one kind of slender fiber and x = 1 this is Toll's (8/pi) phi (L/D) f + 4 phi
/// (g + 1) (J. Rheol. 37 (1993) 123).
class RandomFibers {
 public:
  explicit RandomFibers(const FiberState& state) : density_(state.fiber_count() / state.cell.volume()) {
    for (const FiberIndex f : state.fibers()) {
      const double share = 1.0 / state.fiber_count(), length = fiber_length(state, f),
                   radius = state.material(f).radius;
      for (std::size_t power = 0; power < 4; ++power) {
        radius_[power] += share * std::pow(radius, static_cast<double>(power));
        length_radius_[power] += share * length * std::pow(radius, static_cast<double>(power));
      }
    }
  }
  /// Number of others a fiber whose axes are nearer than `distance` sums of radii.
  [[nodiscard]] double within(double distance, double sine) const {
    const double crossing = 2 * length_radius_[0] * length_radius_[1];
    const double beside =
        2 * (length_radius_[2] + 2 * length_radius_[1] * radius_[1] + length_radius_[0] * radius_[2]);
    const double ends = 2 * radius_[3] + 6 * radius_[2] * radius_[1];
    return density_ * (2 * distance * sine * crossing + pi * distance * distance * beside +
                       4.0 / 3.0 * pi * std::pow(distance, 3) * ends);
  }

 private:
  double density_;
  std::array<double, 4> radius_{};         // means of a^n
  std::array<double, 4> length_radius_{};  // means of L a^n
};

void measure_curvature(const FiberState& state, PackingReport& report) {
  report.minimum_radius = minimum_radius(state);
  const std::vector<double> radii = hinge_radii(state);
  if (radii.empty()) return;
  constexpr double sharp = 1.1;  // of the smallest radius
  for (const double radius : radii) {
    report.mean_curvature += 1 / radius;
    report.rms_curvature += 1 / (radius * radius);
    if (radius < sharp * report.minimum_radius) report.sharp_hinges += 1;
  }
  const auto count = static_cast<double>(radii.size());
  report.mean_curvature /= count;
  report.rms_curvature = std::sqrt(report.rms_curvature / count);
  report.sharp_hinges /= count;
}

}  // namespace

PackingReport measure_packing(const FiberState& state, const Mat3& asked) {
  require_sound(state);
  PackingReport report;
  report.orientation_asked = asked;
  report.orientation_reached = orientation_tensor(state, Weighting::length);
  report.orientation_error = (report.orientation_reached - asked).cwiseAbs().maxCoeff();
  report.volume_fraction = volume_fraction(state);
  report.orientation4_reached = orientation_tensor4(state, Weighting::length);
  measure_curvature(state, report);

  double unit = 0;
  for (const FiberIndex f : state.fibers()) unit = std::max(unit, state.material(f).diameter());
  const Chains chains = chains_of(state, unit);
  const PairCounts counts = count_pairs(chains);
  report.largest_overlap = counts.largest_overlap;
  const double fibers = state.fiber_count();
  report.contacts_per_fiber = static_cast<double>(counts.contacts) / fibers;
  const double sine = mean_sine(chains);
  const RandomFibers random(state);
  report.contacts_random = random.within(contact_distance, sine);
  for (std::size_t b = 0; b < bin_count; ++b) {
    const double low = bin_width * static_cast<double>(b), high = low + bin_width;
    report.pair_distances.push_back({low, high, static_cast<double>(counts.bins[b]) / fibers,
                                     random.within(high, sine) - random.within(low, sine)});
  }
  return report;
}

}  // namespace fiberfate
