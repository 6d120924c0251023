// Runs the study shear_cell: steps the fibers, writes what is due, and keeps checkpoints.
#include "studies/shear_cell/run.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "dynamics/stress_mean.hpp"
#include "results/fiber_checkpoint.hpp"
#include "results/fiber_frame.hpp"
#include "results/output_schedule.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/sample/start.hpp"
#include "studies/shear_cell/observables.hpp"
#include "studies/shear_cell/run_loop.hpp"
#include "studies/shear_cell/status.hpp"
#include "studies/shear_cell/stress_observables.hpp"

namespace fiberfate {
namespace {

/// One run from its start or its last checkpoint to the next stop.
class ShearCellRun {
 public:
  ShearCellRun(const ShearCellCase& values, Session& session, Checkpoint from);
  /// Writes the outputs of the very first moment and a checkpoint of it.
  void begin();
  [[nodiscard]] Outcome run();
  [[nodiscard]] bool has_reached_end() const { return simulation_.state().time >= limits_.end; }

 private:
  void write_outputs();
  void write_checkpoint();
  void take(const StepReport& report);
  void show_progress(const StepReport& report);
  [[nodiscard]] CellMoment moment();
  [[nodiscard]] PolyFrame frame() const;
  void dump(const SimulationFailure& failure);
  [[nodiscard]] Outcome finish(const RunOutcome& outcome);
  [[nodiscard]] RunSummary summarise(const RunOutcome& outcome);
  [[nodiscard]] RunRecord record() const;
  [[nodiscard]] Checkpoint checkpoint();

  const ShearCellCase& values_;
  Session& session_;
  std::string resolved_case_;
  RunRecord before_;  ///< what earlier processes counted
  FlowHistory flow_;
  OutputSchedule series_times_;
  OutputSchedule frame_times_;
  RunLimits limits_;
  Simulation simulation_;
  StressMean stress_;  ///< since the last row
  std::optional<ParticleStress> last_stress_;
  StressHistory stress_history_;
  std::unique_ptr<RowSink> series_;
  std::unique_ptr<RowSink> breaks_;
  std::unique_ptr<FrameSink> frames_;
  StepLimit step_limit_ = StepLimit::control;
  std::int64_t rejections_ = 0;
  double begin_time_;  ///< simulated, s
  double begin_wall_;  ///< of the session, s
};

/// States in a line what became of the fibers.
std::string headline(const RunSummary& summary) {
  const Mat3& a2 = summary.orientation.value();
  return fmt::format("L_N {:.4g} mm, L_W {:.4g} mm, a_11 {:.3f}, {} breaks after {:.6g} s",
                     1e3 * summary.number_average.value(), 1e3 * summary.weight_average.value(), a2(0, 0),
                     summary.breaks.value(), summary.simulated_s.value());
}

OutputSchedule series_schedule(const ShearCellCase& values) {
  return {series_interval(values.run, values.output), values.output.times};
}

OutputSchedule frame_schedule(const ShearCellCase& values) {
  return {frame_interval(values), values.output.histogram_times};
}

RunLimits limits_of(const ShearCellCase& values, const Session& session) {
  const SessionOptions& options = session.options();
  RunLimits limits;
  const OutputSchedule series = series_schedule(values);
  limits.end = series.snapped(options.until.value_or(values.run.duration));
  limits.at_end =
      limits.end == series.snapped(values.run.duration) ? StopReason::done : StopReason::time_reached;
  limits.steps = options.steps;
  limits.checkpoint_interval = values.output.checkpoint_interval;
  limits.stop_requested = [&session] { return session.stop_requested(); };
  return limits;
}

ShearCellRun::ShearCellRun(const ShearCellCase& values, Session& session, Checkpoint from)
    : values_(values),
      session_(session),
      resolved_case_(std::move(from.resolved_case)),
      before_(from.record),
      flow_(flow_history(values.flow)),
      series_times_(series_schedule(values)),
      frame_times_(frame_schedule(values)),
      limits_(limits_of(values, session)),
      simulation_(dynamics_parameters(values), flow_, std::move(from.state)),
      stress_(StressMean::from(from.record.stress)),
      stress_history_(from.record.stress_history),
      series_(
          session.recorder().open_rows("series", columns_of(cell_observables()), from.record.series_rows)),
      breaks_(
          session.recorder().open_rows("breaks", columns_of(break_observables()), from.record.break_rows)),
      frames_(session.recorder().open_frames("result", from.record.frames)),
      begin_time_(simulation_.state().time),
      begin_wall_(session.wall_s()) {
  simulation_.times() = before_.times;
  simulation_.watch_stress(values.output.stress_steps);
}

void ShearCellRun::begin() {
  write_outputs();
  write_checkpoint();
}

Outcome ShearCellRun::run() {
  RunActions actions;
  actions.next_output = [this](double time) {
    return std::min(series_times_.next(time), frame_times_.next(time));
  };
  actions.after_step = [this](const StepReport& report) { take(report); };
  actions.output = [this] { write_outputs(); };
  actions.checkpoint = [this] { write_checkpoint(); };
  actions.progress = [this](const StepReport& report) { show_progress(report); };
  try {
    return finish(run_loop(simulation_, limits_, actions));
  } catch (const SimulationFailure& failure) {
    dump(failure);
    throw;
  }
}

void ShearCellRun::write_outputs() {
  const PhaseTimer timer(simulation_.times(), Phase::output);
  const FiberState& state = simulation_.state();
  const bool last = state.time >= limits_.end;
  if (last || series_times_.includes(state.time)) {
    const CellMoment now = moment();
    series_->append(measure(cell_observables(), now));
    stress_history_.add(now);
    stress_ = {};
    series_->flush();
    breaks_->flush();
  }
  if (last || frame_times_.includes(state.time)) frames_->append(frame());
}

/// The present moment with the mean stress since the last row.
CellMoment ShearCellRun::moment() {
  CellMoment now = moment_of(values_, flow_, simulation_);
  if (!stress_.is_empty()) now.stress = stress_.mean();
  return now;
}

/// The present fibers with the stress of the last step, in the order 11, 22, 33, 12, 13, 23; NaN before the
/// first.
PolyFrame ShearCellRun::frame() const {
  PolyFrame frame = fiber_frame(simulation_.state());
  if (values_.output.stress_steps == 0) return frame;
  const Mat3 s =
      last_stress_ ? last_stress_->stress : Mat3::Constant(std::numeric_limits<double>::quiet_NaN());
  const std::vector<double> components = {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)};
  frame.frame_data.push_back({"particle_stress", "Pa", 6, components});
  return frame;
}

void ShearCellRun::take(const StepReport& report) {
  last_stress_ = report.stress;
  if (report.stress) stress_.add(*report.stress, report.step_size);
  for (const BreakEvent& event : simulation_.take_break_events())
    breaks_->append(measure(break_observables(), event));
}

RunRecord ShearCellRun::record() const {
  RunRecord record;
  record.series_rows = series_->rows();
  record.break_rows = breaks_->rows();
  record.frames = frames_->frames();
  record.rejections = before_.rejections + rejections_;
  record.wall_s = before_.wall_s + session_.wall_s();
  record.cpu_s = before_.cpu_s + session_.cpu_s();
  record.stress = stress_.numbers();
  record.stress_history = stress_history_.numbers();
  return record;
}

Checkpoint ShearCellRun::checkpoint() {
  Checkpoint now{simulation_.state(), record(), resolved_case_};
  now.record.times = simulation_.times();
  return now;
}

void ShearCellRun::write_checkpoint() {
  const PhaseTimer timer(simulation_.times(), Phase::output);
  series_->sync();
  breaks_->sync();
  save_checkpoint(session_.recorder(), checkpoint());
}

void ShearCellRun::show_progress(const StepReport& report) {
  rejections_ += report.rejections;
  if (report.limit != StepLimit::event) step_limit_ = report.limit;
  session_.show([this] {
    const FiberState& state = simulation_.state();
    const MeanLengths lengths = mean_lengths(state);
    return describe(RunStatus{state.time, begin_time_, limits_.end, session_.wall_s() - begin_wall_,
                              lengths.number_average, lengths.weight_average, state.step_size,
                              name(step_limit_)});
  });
}

void ShearCellRun::dump(const SimulationFailure& failure) {
  session_.end_progress();
  session_.recorder().error(failure.what());
  save_failure(session_.recorder(), checkpoint());
}

Outcome ShearCellRun::finish(const RunOutcome& outcome) {
  session_.end_progress();
  write_checkpoint();
  frames_->finish();
  const FiberState& state = simulation_.state();
  session_.recorder().note(fmt::format("stopped ({}) at {:.9g} s after {} steps, {} breaks",
                                       name(outcome.reason), state.time, state.step, state.breaks));
  Outcome found{summarise(outcome)};
  found.headlines.push_back(headline(found.summary));
  return found;
}

RunSummary ShearCellRun::summarise(const RunOutcome& outcome) {
  const FiberState& state = simulation_.state();
  const RunRecord now = record();
  RunSummary summary;
  summary.timings = simulation_.times();
  const CellMoment last = moment_of(values_, flow_, simulation_);
  describe_fibers(summary, state);
  summary.stop_reason = outcome.reason;
  summary.seed = values_.run.seed;
  summary.wall_s = now.wall_s;
  summary.cpu_s = now.cpu_s;
  summary.segment_steps_per_s = outcome.speed();
  summary.max_overlap = last.contacts.max_overlap;
  fiberfate::summarise(cell_observables(), last, summary);
  summarise_stress(stress_history_, stationary_from(values_), summary);
  summary.own.insert(summary.own.end(), {{"A2_number", last.a2_number},
                                         {"rejected_steps", now.rejections},
                                         {"stepping_s", outcome.stepping_seconds},
                                         {"lattice_m", state.cell.lattice}});
  return summary;
}

Outcome begin_run(const ShearCellCase& values, Session& session) {
  Recorder& recorder = session.recorder();
  require_sample_memory(values.sample, values.run.seed);
  recorder.note("making the fibers");
  Checkpoint start;
  start.resolved_case = recorder.resolved_case();
  const FlowHistory flow = flow_history(values.flow);
  StartingFibers fibers = make_fibers(
      values.sample, {values.dynamics.contact, values.boundary.y, values.run.seed, &flow}, session);
  start.state = std::move(fibers.state);
  if (fibers.packing) warn_of_sinking_in(*fibers.packing, recorder);
  recorder.note(fmt::format("{} fibers of {} rods in all, {:.4g} % by volume, {} threads",
                            start.state.fiber_count(), start.state.rod_count(),
                            100 * volume_fraction(start.state), thread_count()));
  ShearCellRun run(values, session, std::move(start));
  run.begin();
  return run.run();
}

Outcome continue_run(const ShearCellCase& values, Session& session) {
  Checkpoint from = load_checkpoint(session.recorder());
  session.recorder().note(fmt::format("continuing at {:.9g} s", from.state.time));
  ShearCellRun run(values, session, std::move(from));
  if (run.has_reached_end() && session.recorder().has_outcome())
    throw NoOutcome{StopReason::done, "the run is at its end already; give a later --until to continue"};
  return run.run();
}

}  // namespace

Outcome compute_shear_cell(const ShearCellCase& values, Session& session) {
  session.use_threads(values.run.threads);
  return session.continues() ? continue_run(values, session) : begin_run(values, session);
}

}  // namespace fiberfate
