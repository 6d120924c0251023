// Pushes rods apart that are nearer than a given distance: the soft contact of packing.
#pragma once

#include <cstdint>

namespace fiberfate {

/// Describes a rod to the kernels: one cache line.
struct alignas(64) RodRecord {
  double centre[3] = {0, 0, 0};
  double half[3] = {0, 0, 0};  ///< from the centre to the end
  double radius = 0;
  double firmness = 1;  ///< F0 of a pair is multiplied by the smaller one of its rods
};

/// Displacement of one image of the cell, laid out like a record so that record + shift is the image's
/// record.
struct alignas(64) ImageShift {
  double shift[3] = {0, 0, 0};
  double unused[5] = {0, 0, 0, 0, 0};
};

/// The law F = min(k g, F0 (1 + x + x²/2)) + h (core r − d)₊, g = swelling r + reach − d > 0, x = decay
/// (1 − d/r)₊, where d is the distance of the axes and r the sum of the two radii; lengths in units of
/// packing (see chains.hpp).
struct RepulsionLaw {
  double swelling = 1;      ///< contact at this many times the sum of the radii
  double reach = 0;         ///< added to the contact distance
  double stiffness = 1;     ///< k
  double saturation = 1e9;  ///< F0: beyond it the force rises only slowly
  double decay = 0;         ///< of the rise beyond saturation, per sum of radii
  double hardness = 0;      ///< h, of the core
  double core = 1;          ///< of that many times the sum of the radii
};

/// The load on the two ends of a rod.
struct alignas(64) RepulsionLoad {
  double on_begin[3] = {0, 0, 0};
  double on_end[3] = {0, 0, 0};
  double largest_overlap =
      0;  ///< (sum of the radii − d) / sum of the radii, at most over the neighbours; may be negative
  double energy = 0;  ///< half of the energy of each of the rod's pairs (harmonic part)
};

/// The arrays that a kernel reads: [begin[i], begin[i + 1]) of `rod` and `image` are the neighbours of
/// rod i, padded to full packs with a dummy rod far away. Both rods of a pair list it, so that loads are
/// gathered, never scattered.
struct RepulsionInput {
  const RodRecord* records;
  const std::int32_t* begin;
  const std::int32_t* rod;
  const std::int32_t* image;
  const ImageShift* shifts;
};

/// The centres of rods in order of their slots, and how far each reaches from its centre (half length +
/// swollen radius).
struct CentreArrays {
  const double* x;
  const double* y;
  const double* z;
  const double* reach;
};

/// Describes the rod whose neighbourhood is searched.
struct SearchRod {
  double centre[3];     ///< in the image of the cell that is searched
  double direction[3];  ///< unit vector
  double sphere;        ///< half length + tube, see below
  double tube;          ///< swollen radius + everything that is added to the contact distance
};

/// Writes the slots in [first, last) whose rods may be near `rod` to `near` (room for last − first + 8) and
/// returns how many: those that reach both the sphere about its centre and the tube about its line.
using SearchKernel = int (*)(const CentreArrays& centres, const SearchRod& rod, int first, int last,
                             std::int32_t* near);
/// Computes the loads on the rods [first, last).
using RepulsionKernel = void (*)(const RepulsionInput& input, const RepulsionLaw& law, int first, int last,
                                 RepulsionLoad* loads);
/// Computes the axis distances from rod `subject` to `count` (a multiple of eight) others.
using DistanceKernel = void (*)(const RepulsionInput& input, int subject, int count, double* distances);

/// Chooses the kernel for this processor.
[[nodiscard]] RepulsionKernel repulsion_kernel();
[[nodiscard]] DistanceKernel distance_kernel();
[[nodiscard]] SearchKernel search_kernel();

}  // namespace fiberfate
