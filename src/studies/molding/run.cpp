// Runs the study molding: fills the cavity, writes what is due, and keeps checkpoints.
#include "studies/molding/run.hpp"

#include <fmt/format.h>

#include <memory>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/threads.hpp"
#include "io/atomic_file.hpp"
#include "studies/molding/checkpoint.hpp"
#include "studies/molding/effort.hpp"
#include "studies/molding/frames.hpp"
#include "studies/molding/observables.hpp"
#include "studies/molding/outcome.hpp"
#include "studies/molding/properties.hpp"

namespace fiberfate {
namespace {

/// What a run begins with, or goes on from.
struct Beginning {
  MoldingSetup setup;
  Filling filling;
  MoldingRecord record = {};
};

/// One filling from its start or its last checkpoint to the next stop.
class MoldingRun {
 public:
  MoldingRun(const MoldingCase& values, Session& session, Beginning from);
  [[nodiscard]] Outcome run();

 private:
  [[nodiscard]] std::optional<StopReason> reason_to_stop(std::int64_t first_step) const;
  void after_step(const FillingMoment& begin);
  void append_row(const FillingMoment& at) { series_->append(measure(observables_, at)); }
  [[nodiscard]] MoldingRecord record() const;
  [[nodiscard]] MoldingCheckpoint checkpoint() const {
    return {filling_.mesh().shell(), filling_.state(), record()};
  }
  void write_checkpoint();
  void show_progress();
  [[nodiscard]] Outcome finish(StopReason reason);
  void tell(StopReason reason) const;

  const MoldingCase& values_;
  Session& session_;
  MoldingSetup setup_;
  Filling filling_;
  MoldingFields fields_;
  MoldingRecord before_;
  Observables<FillingMoment> observables_;
  std::unique_ptr<RowSink> series_;
  std::unique_ptr<FrameSink> frames_;
  double greatest_pressure_;
  double last_checkpoint_ = wall_seconds();
};

MoldingRun::MoldingRun(const MoldingCase& values, Session& session, Beginning from)
    : values_(values),
      session_(session),
      setup_(std::move(from.setup)),
      filling_(std::move(from.filling)),
      fields_(values_, setup_, filling_),
      before_(from.record),
      observables_(filling_observables(setup_.params.gates)),
      series_(session.recorder().open_rows("series", columns_of(observables_), before_.series_rows)),
      frames_(session.recorder().open_frames("result", before_.frames)),
      greatest_pressure_(before_.greatest_pressure) {}

Outcome MoldingRun::run() {
  const std::int64_t first_step = filling_.state().steps;
  try {
    for (;;) {
      if (const auto reason = reason_to_stop(first_step)) return finish(*reason);
      const FillingMoment begin = moment_of(filling_, greatest_pressure_);
      filling_.advance();
      after_step(begin);
    }
  } catch (const SimulationFailure& failure) {
    session_.end_progress();
    session_.recorder().error(failure.what());
    save_failure(session_.recorder(), checkpoint());
    throw;
  }
}

std::optional<StopReason> MoldingRun::reason_to_stop(std::int64_t first_step) const {
  if (filling_.finished()) return StopReason::done;
  const SessionOptions& options = session_.options();
  if (options.until && filling_.state().time >= *options.until) return StopReason::time_reached;
  if (options.steps && filling_.state().steps - first_step >= *options.steps)
    return StopReason::steps_reached;
  if (session_.stop_requested()) return StopReason::signal;
  return std::nullopt;
}

void MoldingRun::after_step(const FillingMoment& begin) {
  greatest_pressure_ = std::max(greatest_pressure_, filling_.state().sprue_pressure);
  append_row(begin);
  if (filling_.finished()) append_row(moment_of(filling_, greatest_pressure_));
  const auto frame_number = [this](double filled) {
    return static_cast<std::int64_t>(filled * static_cast<double>(values_.output.frames));
  };
  if (filling_.finished() || frame_number(filling_.filled_fraction()) > frame_number(begin.filled_fraction))
    frames_->append(
        part_frame(fields_, frames_->frames() == 0 ? FrameGeometry::own : FrameGeometry::as_before));
  if (wall_seconds() - last_checkpoint_ >= values_.output.checkpoint_interval) write_checkpoint();
  show_progress();
}

MoldingRecord MoldingRun::record() const {
  MoldingRecord record;
  record.series_rows = series_->rows();
  record.frames = frames_->frames();
  record.wall_s = before_.wall_s + session_.wall_s();
  record.cpu_s = before_.cpu_s + session_.cpu_s();
  record.greatest_pressure = greatest_pressure_;
  return record;
}

void MoldingRun::write_checkpoint() {
  series_->sync();
  save_checkpoint(session_.recorder(), checkpoint());
  last_checkpoint_ = wall_seconds();
}

void MoldingRun::show_progress() {
  session_.show([this] {
    const FillingState& state = filling_.state();
    return fmt::format("{:.4g} s, {:.1f} % filled, sprue at {:.4g} MPa, {} of about {} steps", state.time,
                       100 * filling_.filled_fraction(), 1e-6 * state.sprue_pressure, state.steps,
                       values_.numerics.steps);
  });
}

Outcome MoldingRun::finish(StopReason reason) {
  session_.end_progress();
  write_checkpoint();
  frames_->finish();
  const FillingState& state = filling_.state();
  Outcome outcome = gather_outcome(fields_, record());
  RunSummary& summary = outcome.summary;
  summary.stop_reason = reason;
  summary.simulated_s = state.time;
  summary.steps = state.steps;
  summary.volume_fraction = values_.fibers.volume_fraction;
  outcome.prisms.push_back({"layers", layer_prisms(fields_)});
  if (has_properties(values_))
    outcome.frames.push_back(
        {"properties", {properties_frame(filling_, triangle_properties(fields_, solid_of(values_)))}});
  const MoldingRecord now = record();
  summary.wall_s = now.wall_s;
  summary.cpu_s = now.cpu_s;
  tell(reason);
  outcome.headlines.push_back(fmt::format("{:.4g} % filled after {:.4g} s, at most {:.4g} MPa at the sprue",
                                          100 * filling_.filled_fraction(), state.time,
                                          1e-6 * greatest_pressure_));
  return outcome;
}

void MoldingRun::tell(StopReason reason) const {
  const FillingState& state = filling_.state();
  session_.recorder().note(fmt::format("stopped ({}, {}) at {:.6g} s after {} steps, {:.4g} % filled",
                                       name(reason), name(state.stop_reason), state.time, state.steps,
                                       100 * filling_.filled_fraction()));
  if (filling_.finished() && state.stop_reason != FillingEnd::filled)
    session_.recorder().warn(fmt::format("the cavity did not fill: {} at {:.7g} %", name(state.stop_reason),
                                         100 * filling_.filled_fraction()));
}

Outcome begin_filling(const MoldingCase& values, Session& session) {
  MoldingSetup setup = molding_setup(values);
  require_memory(filling_bytes(setup), "take a larger part.mesh_size, fewer layers or fewer lengths");
  Filling filling(ShellMesh(setup.part.shell), setup.params);
  session.recorder().note(fmt::format("{} nodes, {} triangles, {:.4g} cm^3, {} threads",
                                      filling.mesh().node_count(), filling.mesh().triangle_count(),
                                      1e6 * filling.mesh().total_volume(), thread_count()));
  return MoldingRun(values, session, {std::move(setup), std::move(filling)}).run();
}

Outcome continue_filling(const MoldingCase& values, Session& session) {
  MoldingCheckpoint from = load_molding(session.recorder());
  const MoldingRecord before = from.record;
  MoldingSetup setup = molding_setup(values, from.shell);
  Filling filling = filling_from(std::move(from), setup.params);
  if (filling.finished()) session.recorder().warn("the filling is at its end already");
  session.recorder().note(fmt::format("continuing at {:.9g} s", filling.state().time));
  return MoldingRun(values, session, {std::move(setup), std::move(filling), before}).run();
}

}  // namespace

Outcome compute_molding(const MoldingCase& values, Session& session) {
  session.use_threads(values.run.threads);
  return session.continues() ? continue_filling(values, session) : begin_filling(values, session);
}

void export_structure(const MoldingCase& values, const ResultFolder& folder, const std::string& out,
                      StructuralSolver solver) {
  if (!has_properties(values))
    throw InputError("this result has no stiffness: the case follows no orientation or gives no lengths",
                     "choose a law in [orientation] and give fibers.length");
  MoldingCheckpoint from = load_molding(folder);
  const MoldingSetup setup = molding_setup(values, from.shell);
  const Filling filling = filling_from(std::move(from), setup.params);
  const MoldingFields fields(values, setup, filling);
  replace_file(out + "/part.inp",
               structural_input(filling.mesh().shell(), plies(fields, solid_of(values)), solver));
}

}  // namespace fiberfate
