// Keeps what a study makes in memory, for programs that use studies as a library.
#pragma once

#include <map>
#include <utility>

#include "results/outcome.hpp"
#include "results/recorder.hpp"

namespace fiberfate {

/// One line of the log.
struct LogLine {
  enum class Level { note, warning, error } level;
  std::string text;
};

/// Keeps rows, frames and log lines in memory, and no checkpoints: a study in memory ends where it is
/// stopped.
class MemoryRecorder final : public Recorder {
 public:
  explicit MemoryRecorder(std::string resolved_case = {}) : resolved_case_(std::move(resolved_case)) {}

  void note(const std::string& text) override { log_.push_back({LogLine::Level::note, text}); }
  void warn(const std::string& text) override { log_.push_back({LogLine::Level::warning, text}); }
  void error(const std::string& text) override { log_.push_back({LogLine::Level::error, text}); }
  [[nodiscard]] std::unique_ptr<RowSink> open_rows(const std::string& name,
                                                   const std::vector<std::string>& columns,
                                                   std::int64_t kept) override;
  [[nodiscard]] std::unique_ptr<FrameSink> open_frames(const std::string& name, std::int64_t kept) override;
  [[nodiscard]] bool has_checkpoint() const override { return false; }
  [[nodiscard]] bool has_outcome() const override { return false; }
  void save_checkpoint(const CheckpointBody&) override {}
  void read_checkpoint(const std::function<void(const std::string& path)>& read) override;
  void save_failure(const CheckpointBody&) override {}
  [[nodiscard]] std::string resolved_case() const override { return resolved_case_; }

  [[nodiscard]] const std::vector<LogLine>& log() const { return log_; }
  /// Moves what was streamed into an outcome, before the tables and frames that it has already.
  void hand_over(Outcome& outcome);

 private:
  std::string resolved_case_;
  std::vector<LogLine> log_;
  std::map<std::string, std::shared_ptr<CsvTable>> tables_;
  std::map<std::string, std::shared_ptr<std::vector<PolyFrame>>> frames_;
};

}  // namespace fiberfate
