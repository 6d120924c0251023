// Foretells what the fibers at the start are and what they need.
#include "studies/sample/estimate.hpp"

#include <fmt/format.h>

namespace fiberfate {
namespace {

constexpr double bytes_a_program = 50e6;  ///< code, libraries, buffers of the output
constexpr double bytes_a_rod = 2000;      ///< state, step, neighbour lists with some ten pairs

std::string percent(double fraction) {
  return fmt::format("{:.4g} %", 100 * fraction);
}

}  // namespace

CaseEstimate estimate_sample(const SampleCase& sample, const std::optional<SamplePlan>& plan) {
  CaseEstimate estimate;
  estimate.memory_bytes = bytes_a_program;
  if (!plan) {
    estimate.facts.emplace_back("fibers", "as in " + sample.cluster.file);
    return estimate;
  }
  const Vec3 edges = 1e3 * plan->cell_size;
  estimate.facts = {
      {"fibers", fmt::format("{}", plan->fibers)},
      {"rods", fmt::format("{}", plan->rods)},
      {"cell", fmt::format("{:.6g} x {:.6g} x {:.6g} mm", edges.x(), edges.y(), edges.z())},
      {"volume fraction", percent(plan->volume_fraction)},
      {"weight fraction", plan->weight_fraction
                              ? percent(*plan->weight_fraction)
                              : std::string("unknown (needs fibers.density and matrix.density)")}};
  estimate.memory_bytes += bytes_a_rod * static_cast<double>(plan->rods);
  return estimate;
}

}  // namespace fiberfate
