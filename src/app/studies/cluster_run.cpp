// Runs the study cluster: packs fibers and leaves them for others to start from.
#include "app/studies/cluster_run.hpp"

#include <fmt/format.h>

#include <thread>

#include "app/checkpoint.hpp"
#include "app/fiber_frame.hpp"
#include "app/run_log.hpp"
#include "app/signals.hpp"
#include "app/studies/sample_start.hpp"
#include "app/summary.hpp"
#include "base/error.hpp"
#include "base/threads.hpp"
#include "fibers/observables.hpp"
#include "io/atomic_file.hpp"
#include "io/vtkhdf_file.hpp"

namespace fiberfate {
namespace {

using OwnValues = std::vector<std::pair<std::string, SummaryValue>>;

void append_pair_distances(OwnValues& own, const PackingReport& packing) {
  std::vector<double> low, high, found, random;
  for (const PairDistanceBin& bin : packing.pair_distances) {
    low.push_back(bin.low);
    high.push_back(bin.high);
    found.push_back(bin.per_fiber);
    random.push_back(bin.random);
  }
  own.insert(own.end(), {{"pair_distance_low_diameters", low},
                         {"pair_distance_high_diameters", high},
                         {"pair_distance_per_fiber", found},
                         {"pair_distance_per_fiber_random", random}});
}

OwnValues own_values(const FiberState& state, const PackingReport& packing) {
  OwnValues own = {{"A2_asked", packing.orientation_asked},
                   {"A2_number", orientation_tensor(state, Weighting::number)},
                   {"orientation_error", packing.orientation_error},
                   {"max_overlap_diameters", packing.largest_overlap},
                   {"min_radius_m", packing.minimum_radius},
                   {"mean_curvature_per_m", packing.mean_curvature},
                   {"contacts_per_fiber", packing.contacts_per_fiber},
                   {"contacts_per_fiber_random", packing.contacts_random},
                   {"packing_steps", static_cast<std::int64_t>(packing.steps)},
                   {"packing_s", packing.wall_seconds},
                   {"lattice_m", state.cell.lattice}};
  append_pair_distances(own, packing);
  return own;
}

void write_results(const ClusterCase& values, const ResultFolder& folder, const StartingFibers& fibers,
                   double begin_wall) {
  const PackingReport packing =
      fibers.packing ? *fibers.packing : measure_packing(fibers.state, values.sample.cluster.orientation);
  VtkhdfWriter frames(folder.frames(), 0);
  frames.append(fiber_frame(fibers.state));
  frames.finish();
  Checkpoint checkpoint;
  checkpoint.state = fibers.state;
  checkpoint.record.frames = 1;
  checkpoint.record.wall_s = wall_seconds() - begin_wall;
  checkpoint.record.cpu_s = cpu_seconds();
  checkpoint.resolved_case = read_file(folder.resolved_case());
  save_checkpoint(folder, checkpoint);
  RunSummary summary;
  describe_fibers(summary, fibers.state);
  summary.study = "cluster";
  summary.seed = values.seed;
  summary.wall_s = checkpoint.record.wall_s;
  summary.cpu_s = checkpoint.record.cpu_s;
  summary.max_overlap = 2 * packing.largest_overlap;
  summary.own = own_values(fibers.state, packing);
  write_summary(folder.summary(), summary);
}

}  // namespace

StopReason run_cluster(const ClusterCase& values, const RunOptions& options, ResultFolder& folder) {
  const SignalWatch watch;
  const double begin_wall = wall_seconds();
  RunLog log(folder);
  const int threads = options.threads.value_or(values.threads);
  use_threads(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency()));
  log.note("packing");
  try {
    Progress progress(options.progress);
    const StartingFibers fibers =
        make_fibers(values.sample, {values.contact, Boundary::periodic, values.seed}, progress);
    write_results(values, folder, fibers, begin_wall);
    log.note(fmt::format("packed {} fibers, {:.4g} % by volume", fibers.state.fiber_count(),
                         100 * volume_fraction(fibers.state)));
  } catch (const PackingStopped&) {
    log.warn("stopped while packing; resuming will pack again");
    return StopReason::signal;
  } catch (const SimulationFailure& failure) {
    log.error(failure.what());
    throw;
  }
  return StopReason::done;
}

StopReason resume_cluster(const ClusterCase& values, const RunOptions& options, ResultFolder& folder) {
  if (!has_checkpoint(folder)) return run_cluster(values, options, folder);
  RunLog(folder).warn("the packing is complete already");
  return StopReason::done;
}

}  // namespace fiberfate
