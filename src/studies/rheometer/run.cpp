// Runs the study rheometer: point after point, replica after replica.
#include "studies/rheometer/run.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>

#include "base/error.hpp"
#include "studies/rheometer/cell_run.hpp"
#include "studies/rheometer/curves.hpp"
#include "studies/rheometer/progress.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/sample/start.hpp"

namespace fiberfate {
namespace {

/// Packings of the replicas, kept while points start from the same ones.
class Packings {
 public:
  /// The fibers with which the cell of a point and replica starts; raises as make_fibers.
  FiberState fibers(const ShearCellCase& cell, const RheometerPoint& point, const RunPlace& place,
                    Session& session) {
    const Kind kind = {point.flow, point.fibers, constant_rate(cell) < 0};
    if (kind != kind_) packed_.clear();
    kind_ = kind;
    const auto found = packed_.find(place.replica);
    if (found != packed_.end()) return found->second;
    require_sample_memory(cell.sample, cell.run.seed);
    const FlowHistory flow = flow_history(cell.flow);
    StartingFibers made =
        make_fibers(cell.sample, {cell.dynamics.contact, cell.boundary.y, cell.run.seed, &flow}, session);
    if (made.packing) warn_of_sinking_in(*made.packing, session.recorder());
    session.recorder().note(fmt::format("packed {} fibers of {} rods in all, {:.4g} % by volume, seed {}",
                                        made.state.fiber_count(), made.state.rod_count(),
                                        100 * volume_fraction(made.state), cell.run.seed));
    return packed_.emplace(place.replica, std::move(made.state)).first->second;
  }

 private:
  /// The flow's type, the fibers, and whether it goes backwards: lattices may differ then.
  using Kind = std::tuple<std::optional<std::size_t>, std::size_t, bool>;
  std::optional<Kind> kind_;
  std::map<std::int64_t, FiberState> packed_;
};

/// All runs, from the first or the last checkpoint to the next stop.
class RheometerRun {
 public:
  RheometerRun(const RheometerCase& values, Session& session, RheometerProgress from);
  [[nodiscard]] bool has_reached_end() const { return done() == total_; }
  [[nodiscard]] Outcome run();

 private:
  [[nodiscard]] std::size_t done() const { return progress_.readings.rows(); }
  [[nodiscard]] RunPlace next_place() const;
  void begin();
  [[nodiscard]] StopReason follow();
  void finish_run();
  void save();
  void show() const;
  [[nodiscard]] Outcome outcome(StopReason reason) const;

  const RheometerCase& values_;
  Session& session_;
  std::vector<RheometerPoint> points_;
  std::size_t total_;
  RheometerProgress progress_;
  std::unique_ptr<RowSink> sink_;
  Packings packings_;
  std::optional<CellRun> going_;
  std::int64_t steps_ = 0;  ///< of this process
  double wall_before_, cpu_before_;
};

RheometerRun::RheometerRun(const RheometerCase& values, Session& session, RheometerProgress from)
    : values_(values),
      session_(session),
      points_(points(values.sweep)),
      total_(points_.size() * static_cast<std::size_t>(values.sweep.replicas)),
      progress_(std::move(from)),
      sink_(session.recorder().open_rows("rheometer", reading_columns(),
                                         static_cast<std::int64_t>(progress_.readings.rows()))),
      wall_before_(progress_.wall_s),
      cpu_before_(progress_.cpu_s) {
  if (!progress_.going) return;
  const RunPlace place = next_place();
  going_.emplace(cell_at(values_, points_[place.point], place.replica), *progress_.state, *progress_.going);
}

RunPlace RheometerRun::next_place() const {
  const auto replicas = static_cast<std::size_t>(values_.sweep.replicas);
  return {done() / replicas, static_cast<std::int64_t>(done() % replicas)};
}

/// Begins the next run.
void RheometerRun::begin() {
  const RunPlace place = next_place();
  const RheometerPoint& point = points_[place.point];
  const ShearCellCase cell = cell_at(values_, point, place.replica);
  going_.emplace(cell, packings_.fibers(cell, point, place, session_));
  save();
}

Outcome RheometerRun::run() {
  StopReason reason = StopReason::done;
  while (reason == StopReason::done && !has_reached_end()) {
    try {
      if (!going_) begin();
    } catch (const NoOutcome& stop) {
      if (!progress_.state) throw;  // nothing is saved yet
      session_.recorder().note(stop.message);
      return outcome(stop.reason);
    }
    reason = follow();
    if (reason == StopReason::done) finish_run();
    save();
  }
  return outcome(reason);
}

/// Follows the run that is going until it ends or has to stop.
StopReason RheometerRun::follow() {
  RunLimits limits;
  limits.checkpoint_interval = values_.cell.output.checkpoint_interval;
  limits.stop_requested = [this] { return session_.stop_requested(); };
  if (const auto& most = session_.options().steps) limits.steps = *most - steps_;
  const std::int64_t before = going_->state().step;
  try {
    const RunOutcome found = going_->run(
        limits, [this] { save(); }, [this] { show(); });
    steps_ += going_->state().step - before;
    return found.reason;
  } catch (const SimulationFailure& failure) {
    session_.end_progress();
    session_.recorder().error(fmt::format("run {} of {}: {}", done() + 1, total_, failure.what()));
    progress_.take(*going_);
    save_failure(session_.recorder(), progress_);
    throw;
  }
}

/// Adds the row of the run that has ended.
void RheometerRun::finish_run() {
  const std::vector<double> row = going_->row(next_place());
  progress_.readings.append(row);
  sink_->append(row);
  sink_->flush();
  progress_.take(*going_);
  progress_.going.reset();
  going_.reset();
  session_.recorder().note(fmt::format("run {} of {} has ended", done(), total_));
}

void RheometerRun::save() {
  if (going_) progress_.take(*going_);
  progress_.wall_s = wall_before_ + session_.wall_s();
  progress_.cpu_s = cpu_before_ + session_.cpu_s();
  sink_->sync();
  save_checkpoint(session_.recorder(), progress_);
}

void RheometerRun::show() const {
  session_.show([this] {
    return fmt::format("run {} of {}: {:.4g} of {:.4g} s, step {:.2g} s", done() + 1, total_,
                       going_->state().time, going_->end(), going_->state().step_size);
  });
}

Outcome RheometerRun::outcome(StopReason reason) const {
  session_.end_progress();
  Outcome outcome = evaluate(values_, progress_.readings);
  const std::string drift = words_of_drift(outcome.table("curves"));
  if (reason == StopReason::done && !drift.empty())
    session_.recorder().warn(drift + "; a larger sweep.strain or run.duration would show what it comes to");
  outcome.summary.stop_reason = reason;
  outcome.summary.seed = values_.cell.run.seed;
  outcome.summary.wall_s = wall_before_ + session_.wall_s();
  outcome.summary.cpu_s = cpu_before_ + session_.cpu_s();
  return outcome;
}

}  // namespace

Outcome compute_rheometer(const RheometerCase& values, Session& session) {
  session.use_threads(values.cell.run.threads);
  RheometerProgress from;
  if (session.continues()) from = load_progress(session.recorder());
  if (from.resolved_case.empty()) from.resolved_case = session.recorder().resolved_case();
  RheometerRun run(values, session, std::move(from));
  if (session.continues() && run.has_reached_end() && session.recorder().has_outcome())
    throw NoOutcome{StopReason::done, "the run is at its end already"};
  return run.run();
}

}  // namespace fiberfate
