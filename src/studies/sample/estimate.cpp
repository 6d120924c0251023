// Foretells what the fibers at the start are and what they need.
#include "studies/sample/estimate.hpp"

#include <fmt/format.h>

#include "base/memory.hpp"
#include "base/timer.hpp"

namespace fiberfate {
namespace {

// Packing takes as long as about so many steps of the dynamics; measured on the cases 03 to 09.
constexpr double packing_steps = 4000;
constexpr double bytes_of_output = 10e6;  ///< buffers of the files
constexpr double bytes_a_rod = 2000;      ///< state, step, neighbour lists with some ten pairs

std::string percent(double fraction) {
  return fmt::format("{:.4g} %", 100 * fraction);
}

}  // namespace

double sample_bytes(const std::optional<SamplePlan>& plan) {
  const double rods = plan ? static_cast<double>(plan->rods) : 0;
  return static_cast<double>(peak_memory_bytes()) + bytes_of_output + bytes_a_rod * rods;
}

void require_sample_memory(const SampleCase& sample, std::uint64_t seed) {
  require_memory(sample_bytes(plan_sample(sample, seed)), "take fewer fibers or longer rods");
}

CaseEstimate estimate_sample(const SampleCase& sample, const std::optional<SamplePlan>& plan) {
  CaseEstimate estimate;
  estimate.memory_bytes = sample_bytes(plan);
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
  return estimate;
}

double packing_seconds(const SamplePlan& plan, double seconds_a_rod_step) {
  return packing_steps * static_cast<double>(plan.rods) * seconds_a_rod_step;
}

}  // namespace fiberfate
