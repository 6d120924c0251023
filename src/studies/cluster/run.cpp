// Runs the study cluster: packs fibers and leaves them for others to start from.
#include "studies/cluster/run.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "fibers/observables.hpp"
#include "results/fiber_checkpoint.hpp"
#include "results/fiber_frame.hpp"
#include "studies/cluster/pictures.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/sample/fiber_sections.hpp"
#include "studies/sample/length_comparison.hpp"
#include "studies/sample/start.hpp"
#include "studies/summary_tensors.hpp"

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

void append_kinds(OwnValues& own, const SampleCase& sample, const FiberState& state) {
  if (sample.fibers.more_kinds.empty()) return;
  const std::vector<KindComparison> kinds = compare_kinds(sample, state);
  const auto list = [&](const std::string& key, double KindComparison::*member) {
    std::vector<double> values;
    for (const KindComparison& kind : kinds) values.push_back(kind.*member);
    own.emplace_back(key, values);
  };
  std::vector<double> fibers;
  for (const KindComparison& kind : kinds) fibers.push_back(static_cast<double>(kind.fibers));
  own.emplace_back("kind_fibers", fibers);
  list("kind_L_N_m", &KindComparison::number_average);
  list("kind_L_N_asked_m", &KindComparison::number_average_asked);
  list("kind_L_W_m", &KindComparison::weight_average);
  list("kind_L_W_asked_m", &KindComparison::weight_average_asked);
  list("kind_volume_share", &KindComparison::volume_share);
  list("kind_volume_share_asked", &KindComparison::volume_share_asked);
}

void append_lengths(OwnValues& own, const SampleCase& sample, const FiberState& state) {
  if (sample.cluster.source != ClusterSource::generate) return;
  const LengthComparison lengths = compare_lengths(sample, fiber_lengths(state));
  own.insert(own.end(), {{"L_N_asked_m", lengths.number_average},
                         {"L_W_asked_m", lengths.weight_average},
                         {"length_edges_m", lengths.edges},
                         {"length_fibers", lengths.found},
                         {"length_fibers_asked", lengths.expected},
                         {"length_chi_square", lengths.chi_square},
                         {"length_chi_square_bins", static_cast<std::int64_t>(lengths.chi_square_bins)}});
  append_kinds(own, sample, state);
}

void append_relaxation(OwnValues& own, const std::optional<RelaxedFibers>& relaxed) {
  if (!relaxed) return;
  own.insert(own.end(), {{"relaxation_end", std::string(name(relaxed->end))},
                         {"relaxation_s", relaxed->simulated},
                         {"relaxation_orientation_drift", relaxed->orientation_drift}});
}

const char* name(PackingEnd end) {
  return end == PackingEnd::at_rest ? "at_rest" : "separated";
}

OwnValues own_values(const FiberState& state, const PackingReport& packing) {
  return {{"A2_asked", packing.orientation_asked},
          {"A2_number", orientation_tensor(state, Weighting::number)},
          {"A4", components(packing.orientation4_reached)},
          {"A4_drawn", components(packing.orientation4_drawn)},
          {"orientation_error", packing.orientation_error},
          {"max_overlap_diameters", packing.largest_overlap},
          {"min_radius_m", packing.minimum_radius},
          {"mean_curvature_per_m", packing.mean_curvature},
          {"rms_curvature_per_m", packing.rms_curvature},
          {"sharp_hinges", packing.sharp_hinges},
          {"contacts_per_fiber", packing.contacts_per_fiber},
          {"contacts_per_fiber_random", packing.contacts_random},
          {"packing_end", std::string(name(packing.end))},
          {"max_overlap_at_rest_diameters", packing.overlap_at_rest},
          {"min_radius_at_rest_m", packing.minimum_radius_at_rest},
          {"packing_steps", static_cast<std::int64_t>(packing.steps)},
          {"packing_s", packing.wall_seconds},
          {"lattice_m", state.cell.lattice}};
}

/// Everything that the study made.
struct Cluster {
  FiberState state;
  PackingReport packing;
  std::optional<RelaxedFibers> relaxed;
};

/// Measures the fibers as they are now; what packing told of its course stays.
void measure_again(Cluster& cluster) {
  PackingReport now = measure_packing(cluster.state, cluster.packing.orientation_asked);
  now.orientation4_drawn = cluster.packing.orientation4_drawn;
  now.end = cluster.packing.end;
  now.overlap_at_rest = cluster.packing.overlap_at_rest;
  now.minimum_radius_at_rest = cluster.packing.minimum_radius_at_rest;
  now.steps = cluster.packing.steps;
  now.wall_seconds = cluster.packing.wall_seconds;
  cluster.packing = std::move(now);
}

Cluster make_cluster(const ClusterCase& values, const Session& session) {
  StartingFibers fibers =
      make_fibers(values.sample, {values.contact, values.boundary.y, values.run.seed}, session);
  Cluster cluster;
  cluster.state = std::move(fibers.state);
  cluster.packing =
      fibers.packing ? std::move(*fibers.packing)
                     : measure_packing(cluster.state, orientation_tensor(cluster.state, Weighting::length));
  if (values.relaxation.duration) {
    cluster.relaxed = relax_fibers(values.relaxation, values.contact, cluster.state, session);
    cluster.state = cluster.relaxed->state;
    measure_again(cluster);
  }
  return cluster;
}

void keep_checkpoint(const Cluster& cluster, const Session& session) {
  Checkpoint checkpoint;
  checkpoint.state = cluster.state;
  checkpoint.record.frames = 1;
  checkpoint.record.wall_s = session.wall_s();
  checkpoint.record.cpu_s = session.cpu_s();
  checkpoint.resolved_case = session.recorder().resolved_case();
  save_checkpoint(session.recorder(), checkpoint);
}

std::string headline(const Cluster& cluster) {
  const std::string packed = fmt::format("packed {} fibers, {:.4g} % by volume", cluster.state.fiber_count(),
                                         100 * volume_fraction(cluster.state));
  if (!cluster.relaxed || cluster.relaxed->end != RelaxationEnd::met) return packed;
  return packed + fmt::format(", relaxed in {:.4g} ms", 1e3 * cluster.relaxed->simulated);
}

Outcome outcome_of(const ClusterCase& values, const Cluster& cluster) {
  Outcome outcome;
  outcome.headlines.push_back(headline(cluster));
  RunSummary& summary = outcome.summary;
  describe_fibers(summary, cluster.state);
  summary.breaks.reset();
  if (!cluster.relaxed) {
    summary.simulated_s.reset();
    summary.steps.reset();
  }
  summary.seed = values.run.seed;
  summary.max_overlap = 2 * cluster.packing.largest_overlap;
  summary.own = own_values(cluster.state, cluster.packing);
  append_lengths(summary.own, values.sample, cluster.state);
  append_relaxation(summary.own, cluster.relaxed);
  append_pair_distances(summary.own, cluster.packing);
  outcome.frames.push_back({"result", {fiber_frame(cluster.state)}});
  outcome.tables.push_back({"density", density_table(cluster.state)});
  return outcome;
}

/// Warns of what did not come out as wanted.
void warn_of_shortfalls(const Cluster& cluster, Recorder& log) {
  warn_of_sinking_in(cluster.packing, log);
  if (!cluster.relaxed || cluster.relaxed->end == RelaxationEnd::met) return;
  log.warn(
      fmt::format("relaxing ended ({}) after {:.4g} ms at an overlap of {:.3g} diameters and a radius of "
                  "{:.4g} um",
                  name(cluster.relaxed->end), 1e3 * cluster.relaxed->simulated,
                  cluster.packing.largest_overlap, 1e6 * cluster.packing.minimum_radius));
}

}  // namespace

Outcome compute_cluster(const ClusterCase& values, Session& session) {
  if (session.continues() && session.recorder().has_outcome())
    throw NoOutcome{StopReason::done, "the packing is complete already"};
  session.use_threads(values.run.threads);
  require_sample_memory(values.sample, values.run.seed);
  Recorder& recorder = session.recorder();
  recorder.note("packing");
  try {
    const Cluster cluster = make_cluster(values, session);
    keep_checkpoint(cluster, session);
    warn_of_shortfalls(cluster, recorder);
    return outcome_of(values, cluster);
  } catch (const SimulationFailure& failure) {
    recorder.error(failure.what());
    throw;
  }
}

}  // namespace fiberfate
