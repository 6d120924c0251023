// Foretells what the fibers at the start are and what they need.
#include "studies/sample/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/timer.hpp"
#include "results/memory_recorder.hpp"
#include "results/outcome.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

// Packing takes as long as about so many steps of the dynamics where fibers cannot lie straight, and fewer,
// by a power of how crowded they are, in thin cells; measured on the cases 03 to 09 and on short fibers of up
// to 25 % by volume.
constexpr double packing_steps = 1500, crowded = 17, crowding_power = 1.35;
constexpr double trial_s = 0.2;
constexpr std::int64_t most_rods_to_try = 20000;  // whose first steps fit into a trial
constexpr double bytes_of_output = 10e6;          ///< buffers of the files
constexpr double bytes_a_rod = 2000;              ///< state, step, neighbour lists with some ten pairs

std::string percent(double fraction) {
  return fmt::format("{:.4g} %", 100 * fraction);
}

double usual_seconds(const SampleCase& sample, const SamplePlan& plan, double seconds_a_rod_step) {
  const auto fibers = static_cast<double>(plan.fibers);
  const double volume = plan.volume_fraction * plan.cell_size.prod() / fibers,
               diameter = sample.fibers.diameter;
  // The diameter is that of the first kind of fibers: of thinner ones the rods tell the length.
  const double length =
      std::max(volume / (std::numbers::pi / 4 * diameter * diameter),
               sample.fibers.rod_length.value_or(0) * static_cast<double>(plan.rods) / fibers);
  const double crowding = plan.volume_fraction * length / diameter / crowded;
  return packing_steps * std::min(1.0, std::pow(crowding, crowding_power)) * static_cast<double>(plan.rods) *
         seconds_a_rod_step;
}

/// Packs for a moment; nothing where that is not enough.
std::optional<double> seconds_of_trial(const SampleCase& sample, const StartRequest& start) {
  const Stopwatch watch;
  MemoryRecorder recorder;
  SessionCalls calls;
  calls.stop_requested = [&watch] { return watch.elapsed() > trial_s; };
  try {
    static_cast<void>(make_fibers(sample, start, Session(recorder, {}, calls)));
  } catch (const NoOutcome&) {
    return std::nullopt;
  } catch (const SimulationFailure&) {  // that no packing is found takes its time, too
  }
  return watch.elapsed();
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
  // Fibers that meet their own images are allowed, and move less freely than others.
  const double shortest_edge = plan->cell_size.minCoeff(), length = sample.fibers.length.value_or(0);
  if (length > shortest_edge)
    estimate.facts.emplace_back(
        "fiber length",
        fmt::format("{:.4g} mm, {:.3g} times the shortest edge of the cell: fibers meet their own images",
                    1e3 * length, length / shortest_edge));
  return estimate;
}

double packing_seconds(const SampleCase& sample, const StartRequest& start, const SamplePlan& plan,
                       double seconds_a_rod_step) {
  const double usual = usual_seconds(sample, plan, seconds_a_rod_step);
  if (plan.rods > most_rods_to_try) return usual;
  const std::optional<double> tried = seconds_of_trial(sample, start);
  return tried ? *tried : std::max(usual, 2 * trial_s);
}

}  // namespace fiberfate
