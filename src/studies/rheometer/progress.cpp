// Saves and restores how far a rheometer is.
#include "studies/rheometer/progress.hpp"

#include <span>
#include <utility>

#include "base/error.hpp"
#include "results/fiber_checkpoint.hpp"

namespace fiberfate {
namespace {

/// Writes the progress as a checkpoint of fibers, whose stress_history holds 1 where a run is going (else 0),
/// the rows of rheometer.csv, and what the run that is going has averaged.
Checkpoint checkpoint_of(const RheometerProgress& progress) {
  Checkpoint checkpoint;
  checkpoint.state = progress.state.value();
  checkpoint.resolved_case = progress.resolved_case;
  RunRecord& record = checkpoint.record;
  record.series_rows = static_cast<std::int64_t>(progress.readings.rows());
  record.wall_s = progress.wall_s;
  record.cpu_s = progress.cpu_s;
  record.stress_history = {progress.going ? 1.0 : 0.0};
  for (std::size_t row = 0; row < progress.readings.rows(); ++row)
    for (const std::vector<double>& column : progress.readings.values)
      record.stress_history.push_back(column[row]);
  if (progress.going) {
    record.stress = progress.going->stress;
    record.stress_history.insert(record.stress_history.end(), progress.going->history.begin(),
                                 progress.going->history.end());
  }
  return checkpoint;
}

RheometerProgress progress_of(Checkpoint checkpoint) {
  RheometerProgress progress;
  const std::vector<double>& numbers = checkpoint.record.stress_history;
  const std::size_t columns = progress.readings.columns.size(),
                    rows = static_cast<std::size_t>(checkpoint.record.series_rows);
  const std::size_t width = averaged_observables().size() + 1;
  if (numbers.size() < 1 + rows * columns || (numbers.size() - 1 - rows * columns) % width != 0)
    throw StorageError("cannot continue from the checkpoint: its rows are not those of this study");
  for (std::size_t row = 0; row < rows; ++row)
    progress.readings.append(std::span(numbers).subspan(1 + row * columns, columns));
  if (numbers.front() != 0)
    progress.going =
        RunNotes{checkpoint.record.stress,
                 {numbers.begin() + static_cast<std::ptrdiff_t>(1 + rows * columns), numbers.end()}};
  progress.state = std::move(checkpoint.state);
  progress.wall_s = checkpoint.record.wall_s;
  progress.cpu_s = checkpoint.record.cpu_s;
  progress.resolved_case = std::move(checkpoint.resolved_case);
  return progress;
}

}  // namespace

void RheometerProgress::take(const CellRun& run) {
  state = run.state();
  going = run.notes();
}

void save_checkpoint(Recorder& recorder, const RheometerProgress& progress) {
  save_checkpoint(recorder, checkpoint_of(progress));
}

void save_failure(Recorder& recorder, const RheometerProgress& progress) {
  save_failure(recorder, checkpoint_of(progress));
}

RheometerProgress load_progress(Recorder& recorder) {
  return progress_of(load_checkpoint(recorder));
}

}  // namespace fiberfate
