// Finds neighbouring rods on the grid and keeps account of how long they remain valid.
#include "fibers/neighbour_list.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/threads.hpp"
#include "fibers/closest_points.hpp"

namespace fiberfate {
namespace {

// Grid entries a chunk: small enough to balance threads, large enough to amortise their start.
constexpr Index chunk_size = 512;
// Coordinates in single precision cull with this much allowance, relative to the largest coordinate.
constexpr float rounding = 4e-7F;

float squared(const std::array<float, 3>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/// Square of the distance from a midpoint, `offset` away from the rod's, to the rod's segment.
float squared_distance(const std::array<float, 3>& offset, const RodGrid::Entry& rod) {
  const auto& h = rod.half_axis;
  const float along = offset[0] * h[0] + offset[1] * h[1] + offset[2] * h[2];
  const float place = std::clamp(along / (rod.half_length * rod.half_length), -1.0F, 1.0F);
  return squared({offset[0] - place * h[0], offset[1] - place * h[1], offset[2] - place * h[2]});
}

bool is_later_image(const IntVec3& image) {
  return std::tie(image[0], image[1], image[2]) > std::make_tuple(0, 0, 0);
}

Segment segment_of(const FiberState& state, Index rod) {
  const auto n = static_cast<std::size_t>(rod);
  return {state.position[n], state.position[n + 1]};
}

}  // namespace

double principal_rate(const Flow& flow) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(flow.rate_of_strain(), Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

void NeighbourList::build(const FiberState& state, const Reach& reach) {
  const auto fibers = static_cast<std::size_t>(state.fiber_count());
  margin_.assign(reach.margin.begin(), reach.margin.end());
  travel_.assign(fibers, 0.0);
  origin_ = state.position;
  deformation_.setIdentity();
  strain_ = 0;
  range_ = reach.range;
  farthest_ = range_ + 2 * *std::max_element(margin_.begin(), margin_.end());

  fiber_of_.resize(static_cast<std::size_t>(state.node_count()));
  double longest = 0;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k) {
      fiber_of_[static_cast<std::size_t>(k)] = fiber;
      longest = std::max(longest, state.rod_length[static_cast<std::size_t>(k)]);
    }
  }
  const double widest = (longest + farthest_) * (1 + 1e-6);
  grid_.fill(state, 0.5 * widest);
  chunks_.resize(static_cast<std::size_t>((state.rod_count() + chunk_size - 1) / chunk_size));
  parallel_for(static_cast<std::ptrdiff_t>(chunks_.size()),
               [&](std::ptrdiff_t chunk) { collect(state, static_cast<std::size_t>(chunk), widest); });
}

void NeighbourList::collect(const FiberState& state, std::size_t chunk, double widest) {
  std::vector<RodPair>& pairs = chunks_[chunk];
  pairs.clear();
  const auto entries = grid_.entries();
  const Index first_entry = static_cast<Index>(chunk) * chunk_size;
  const Index last_entry = std::min(first_entry + chunk_size, static_cast<Index>(entries.size()));
  // Rods are taken in order of their number, so that pairs come out sorted by the first rod.
  Index rod = 0;
  Index fiber = 0;
  const auto fiber_with = [&](Index entry) {
    while (state.begin_node(fiber + 1) - (fiber + 1) <= entry) ++fiber;
    return fiber;
  };
  const Mat3& lattice = state.cell.lattice;
  for (Index e = first_entry; e < last_entry; ++e) {
    fiber = fiber_with(e);
    rod = e + fiber;
    const RodGrid::Entry& mine = entries[static_cast<std::size_t>(grid_.place_of(rod))];
    const double my_margin = margin_[static_cast<std::size_t>(fiber)];
    const std::size_t begin = pairs.size();
    grid_.visit_around(
        grid_.bin_of(mine), widest, [&](std::span<const RodGrid::Entry> others, const IntVec3& shift) {
          const Vec3 displaced = lattice * shift.cast<double>();
          const std::array<float, 3> s = {static_cast<float>(displaced[0]), static_cast<float>(displaced[1]),
                                          static_cast<float>(displaced[2])};
          for (const RodGrid::Entry& other : others) {
            if (other.rod < rod) continue;
            const std::array<float, 3> offset = {other.midpoint[0] + s[0] - mine.midpoint[0],
                                                 other.midpoint[1] + s[1] - mine.midpoint[1],
                                                 other.midpoint[2] + s[2] - mine.midpoint[2]};
            const double keep = range_ + my_margin + margin_[static_cast<std::size_t>(fiber_of(other.rod))];
            const float slack =
                static_cast<float>(keep) +
                rounding * static_cast<float>(widest + displaced.cwiseAbs().maxCoeff() + mine.half_length);
            const float sphere = slack + mine.half_length + other.half_length;
            if (squared(offset) > sphere * sphere) continue;
            const float capsule = slack + other.half_length;
            if (squared_distance(offset, mine) > capsule * capsule) continue;
            const IntVec3 image(mine.image[0] - other.image[0] + shift[0],
                                mine.image[1] - other.image[1] + shift[1],
                                mine.image[2] - other.image[2] + shift[2]);
            const bool same_image = image.isZero();
            if (other.rod == rod && !is_later_image(image)) continue;
            const bool same_fiber = fiber_of(other.rod) == fiber;
            if (same_fiber && same_image && other.rod <= rod + 1) continue;
            Segment moved = segment_of(state, other.rod);
            const Vec3 translation = lattice * image.cast<double>();
            moved.begin += translation;
            moved.end += translation;
            if (closest_points(segment_of(state, rod), moved).distance > keep) continue;
            pairs.push_back({rod,
                             other.rod,
                             {static_cast<std::int8_t>(image[0]), static_cast<std::int8_t>(image[1]),
                              static_cast<std::int8_t>(image[2])},
                             0.0});
          }
        });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end(),
              [](const RodPair& a, const RodPair& b) {
                return std::tie(a.second, a.image) < std::tie(b.second, b.image);
              });
  }
}

void NeighbourList::carry(const Flow& flow, double step, std::span<const double> travelled) {
  const double share = strain_share(flow, step);
  for (std::size_t f = 0; f < travel_.size(); ++f) travel_[f] += travelled[f] + share;
  Cell fluid;
  fluid.lattice = deformation_;
  deform(fluid, flow.gradient, step);
  deformation_ = fluid.lattice;
  strain_ += principal_rate(flow) * step;
}

bool NeighbourList::covers(const FiberState& state, const Flow& flow, double step,
                           std::span<const double> ahead) const {
  if (travel_.size() != static_cast<std::size_t>(state.fiber_count())) return false;
  const double shrunk = std::exp(-strain_ - principal_rate(flow) * step);
  std::vector<std::uint8_t> left(travel_.size(), 0);
  parallel_for(state.fiber_count(), [&](std::ptrdiff_t f) {
    const Index fiber = static_cast<Index>(f);
    const auto i = static_cast<std::size_t>(f);
    const double allowed = 0.5 * (shrunk * (range_ + 2 * margin_[i]) - range_) - ahead[i];
    double moved = 0;
    for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k) {
      const auto n = static_cast<std::size_t>(k);
      moved = std::max(moved, (state.position[n] - deformation_ * origin_[n]).squaredNorm());
    }
    left[i] = allowed <= 0 || moved > allowed * allowed ? 1 : 0;
  });
  return std::find(left.begin(), left.end(), 1) == left.end();
}

double NeighbourList::strain_share(const Flow& flow, double step) const {
  return 0.5 * std::expm1(principal_rate(flow) * step) * farthest_;
}

std::size_t NeighbourList::pair_count() const {
  std::size_t count = 0;
  for (const auto& chunk : chunks_) count += chunk.size();
  return count;
}

}  // namespace fiberfate
