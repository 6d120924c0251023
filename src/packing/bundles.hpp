// Lays fibers in bundles, as pellets hold them.
#pragma once

#include <cstddef>
#include <vector>

#include "packing/chains.hpp"
#include "packing/packing.hpp"

namespace fiberfate {

/// Bundles as a packing of their own: every bundle is one thick fiber.
struct BundlePlan {
  PackingRequest bundles;
  std::vector<std::vector<std::size_t>> members;  ///< by bundle: the fibers of the request that it holds
  std::vector<double> spacing;                    ///< by bundle: of the fibers' axes, m
};

/// Groups the fibers of a request by material and length, as many a bundle as it asks for, on a hexagonal
/// lattice of spacing D sqrt(pi / (2 sqrt(3) f)), f the volume fraction inside a bundle. Raises InputError
/// when the bundles cannot exist, saying what would be possible.
[[nodiscard]] BundlePlan plan_bundles(const PackingRequest& request);

/// Draws the fibers of a request along packed bundles: parallel to the bundle's axis, in frames that do not
/// turn about it, shorter ones in its middle. Rod lengths then need ChainConstraints::restore_lengths.
[[nodiscard]] Chains fibers_in_bundles(const PackingRequest& request, const BundlePlan& plan,
                                       const Chains& bundles);

}  // namespace fiberfate
