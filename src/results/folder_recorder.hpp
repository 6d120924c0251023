// Keeps what a study makes in a result folder.
#pragma once

#include <map>

#include "results/outcome.hpp"
#include "results/recorder.hpp"
#include "results/result_folder.hpp"
#include "results/run_log.hpp"

namespace fiberfate {

/// Keeps everything in a result folder (docs/formats/results.md).
class FolderRecorder final : public Recorder {
 public:
  /// Opens the folder's log; raises StorageError.
  explicit FolderRecorder(OwnedFolder& owned) : owned_(owned), log_(owned.make("log.txt")) {}

  void note(const std::string& text) override { log_.note(text); }
  void warn(const std::string& text) override { log_.warn(text); }
  void error(const std::string& text) override { log_.error(text); }
  [[nodiscard]] std::unique_ptr<RowSink> open_rows(const std::string& name,
                                                   const std::vector<std::string>& columns,
                                                   std::int64_t kept) override;
  [[nodiscard]] std::unique_ptr<FrameSink> open_frames(const std::string& name, std::int64_t kept) override;
  [[nodiscard]] bool has_checkpoint() const override;
  [[nodiscard]] bool has_outcome() const override { return owned_.was_ended(); }
  void save_checkpoint(const CheckpointBody& body) override;
  void read_checkpoint(const std::function<void(const std::string& path)>& read) override;
  void save_failure(const CheckpointBody& body) override;
  [[nodiscard]] std::string resolved_case() const override;

 private:
  [[nodiscard]] const ResultFolder& folder() const { return owned_.folder(); }
  void save_digests(Hdf5File& file) const;
  void read_digests(const std::string& checkpoint);

  OwnedFolder& owned_;
  RunLog log_;
  std::map<std::string, const RowSink*> open_rows_;
  std::map<std::string, std::uint64_t> kept_digests_;  ///< of the tables at the checkpoint that was read
};

/// Writes an outcome into a folder: its tables, frames and prisms, and summary.json last. Raises
/// StorageError.
void write_outcome(const Outcome& outcome, OwnedFolder& folder);

}  // namespace fiberfate
