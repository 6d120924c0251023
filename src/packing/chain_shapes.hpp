// Makes the chains that are packed from a request, cuts them in other numbers of rods, and makes a state of
// them.
#pragma once

#include <functional>
#include <span>
#include <utility>

#include "packing/chains.hpp"
#include "packing/packing.hpp"

namespace fiberfate {

/// Diameter of the thickest fiber: the unit of length while packing, m.
[[nodiscard]] double thickest_diameter(const PackingRequest& request);

/// Makes the chains of a request's fibers one after another.
class ChainMaker {
 public:
  /// Takes the cell, in units of packing.
  ChainMaker(const PackingRequest& request, const Cell& cell);
  /// Appends the next fiber, cut in the rods between these nodes (units of packing).
  void append(std::span<const Vec3> nodes);
  [[nodiscard]] Chains take() { return std::move(chains_); }

 private:
  const PackingRequest& request_;
  double unit_;
  double stiffest_ = 0;
  Chains chains_;
};

/// Places every fiber as one straight rod with its centre anywhere in the cell.
[[nodiscard]] Chains straight_chains(const PackingRequest& request, std::span<const Vec3> directions);

/// Point at share x of a fiber's length on the Catmull-Rom spline through its nodes, continued beyond the
/// ends.
[[nodiscard]] Vec3 point_along(const Chains& chains, FiberIndex fiber, double x);

/// Cuts the fibers in other numbers of equal rods along point_along(); rod lengths then need
/// ChainConstraints::restore_lengths.
[[nodiscard]] Chains divide_chains(const Chains& chains, const PackingRequest& request,
                                   const std::function<Index(const FiberBlank&)>& rods_of);

/// Makes a state of packed chains: in m, wrapped into the cell, with rods of exactly the lengths that were
/// asked for.
[[nodiscard]] FiberState state_of(const Chains& chains, const PackingRequest& request);

/// Harmonic mean of the hinges' radii of curvature, in units of packing; infinity when all fibers are
/// straight.
[[nodiscard]] double mean_radius(const Chains& chains);

}  // namespace fiberfate
