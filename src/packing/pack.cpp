// Packs fibers: checks the request, runs the stages and measures the result.
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/threads.hpp"
#include "base/timer.hpp"
#include "packing/densest_fraction.hpp"
#include "packing/packer.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

void require_tolerances(const PackingRequest& request) {
  if (!(request.overlap_tolerance > 0) || !(request.overlap_tolerance < 1))
    throw InputError(fmt::format("the overlap tolerance is {:.4g} diameters", request.overlap_tolerance),
                     "give a number between 0 and 1");
  if (!(request.swelling >= 1) || !(request.swelling <= 10))
    throw InputError(fmt::format("the swelling is {:.4g} diameters", request.swelling),
                     "give a number from 1 to 10");
}

void require_fibers(const PackingRequest& request) {
  if (request.fibers.empty()) throw InputError("there are no fibers to pack", "ask for at least one");
  for (const FiberBlank& fiber : request.fibers) {
    if (fiber.material_id >= request.materials.size())
      throw InputError("a fiber has an unknown material", "name one of the materials that are defined");
    if (!(fiber.length > 0) || fiber.rods < 1)
      throw InputError("a fiber has no length or no rods", "give a length above zero and at least one rod");
    if (!(request.materials[fiber.material_id].radius > 0))
      throw InputError("a fiber has no diameter", "give a diameter above zero");
  }
}

void require_room(const PackingRequest& request) {
  double volume = 0;
  for (const FiberBlank& fiber : request.fibers) {
    const double radius = request.materials[fiber.material_id].radius;
    volume += pi * radius * radius * fiber.length;
  }
  const double fraction = volume / request.cell.volume();
  const bool any_orientation = !request.orientation.directions.empty() || !holds_orientation(request.start);
  const double densest = any_orientation ? densest_parallel : densest_fraction(request.orientation.tensor);
  if (fraction >= densest)
    throw InputError(
        fmt::format("the fibers fill {:.4g} of the cell", fraction),
        fmt::format("fibers with this orientation fill at most {:.4g}, parallel ones {:.4g}: lower the "
                    "concentration, or align them",
                    densest, densest_parallel));
  for (int i = 0; i < 3; ++i) {
    if (request.cell.height(i) < 2 * thickest_diameter(request))
      throw InputError(
          fmt::format("the cell is {:.4g} m high", request.cell.height(i)),
          fmt::format("give at least two fiber diameters, {:.4g} m", 2 * thickest_diameter(request)));
  }
}

constexpr std::int64_t rods_a_thread = 1000;

std::int64_t rod_count(const PackingRequest& request) {
  std::int64_t rods = 0;
  for (const FiberBlank& fiber : request.fibers) rods += fiber.rods;
  return rods;
}

// Straight fibers are packed as one rod, and images are numbered as far as it reaches: 201³ of them take half
// a gigabyte.
constexpr double most_cells = 100;

void require_few_images(const PackingRequest& request) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (request.cell.boundary[i] == Boundary::periodic) lowest = std::min(lowest, request.cell.height(i));
  }
  for (const FiberBlank& fiber : request.fibers) {
    if (fiber.length > most_cells * lowest)
      throw InputError(
          fmt::format("a fiber is {:.4g} times as long as the cell is high", fiber.length / lowest),
          fmt::format("make the cell larger or the fibers shorter: at most {:g} times", most_cells));
  }
}

/// Whether a packing at rest is as good as the request wants.
bool may_rest(const PackingReport& rest, const PackingRequest& request) {
  return rest.largest_overlap < request.overlap_tolerance && rest.minimum_radius >= request.minimum_radius &&
         (!holds_orientation(request.start) || rest.orientation_error < request.orientation_tolerance);
}

/// Replaces the packing by its equilibrium under the contact law where that is admissible, and reports both.
void settle_at_rest(Packer& packer, Chains& chains, const PackingRequest& request, PackingResult& result) {
  packer.rest(chains);
  FiberState state = state_of(chains, request);
  PackingReport rest = measure_packing(state, packer.asked());
  const double overlap = rest.largest_overlap, radius = rest.minimum_radius;
  if (may_rest(rest, request)) {
    rest.end = PackingEnd::at_rest;
    result = {std::move(state), std::move(rest)};
  }
  result.report.overlap_at_rest = overlap;
  result.report.minimum_radius_at_rest = radius;
}

}  // namespace

PackingResult pack(const PackingRequest& request,
                   const std::function<void(const PackingProgress&)>& progress) {
  const double start = wall_seconds();
  require_fibers(request);
  require_tolerances(request);
  require_room(request);
  require_few_images(request);
  const SuitableThreads threads(rod_count(request), rods_a_thread);

  Packer packer(request, progress);
  Chains chains = packer.separate();
  PackingResult result;
  result.state = state_of(chains, request);
  result.report = measure_packing(result.state, packer.asked());
  result.report.overlap_at_rest = result.report.largest_overlap;
  result.report.minimum_radius_at_rest = result.report.minimum_radius;
  // Straight fibers hold no contacts: they are at rest already.
  if (!std::isinf(result.report.minimum_radius)) settle_at_rest(packer, chains, request, result);
  result.report.orientation4_drawn = packer.drawn4();
  result.report.steps = packer.steps();
  result.report.wall_seconds = wall_seconds() - start;
  return result;
}

}  // namespace fiberfate
