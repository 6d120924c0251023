// Keeps what a study makes in a result folder.
#include "results/folder_recorder.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "io/vtkhdf_file.hpp"
#include "results/checkpoint_file.hpp"

namespace fiberfate {
namespace {

class FileRows final : public RowSink {
 public:
  FileRows(const std::string& path, const std::vector<std::string>& columns, std::int64_t kept)
      : writer_(path, columns, kept) {}
  void append(std::span<const double> row) override { writer_.append(row); }
  void flush() override { writer_.flush(); }
  void sync() override { writer_.sync(); }
  [[nodiscard]] std::int64_t rows() const override { return writer_.rows(); }

 private:
  CsvWriter writer_;
};

class FileFrames final : public FrameSink {
 public:
  FileFrames(const std::string& path, std::int64_t kept) : writer_(path, kept) {}
  void append(const PolyFrame& frame) override { writer_.append(frame); }
  void finish() override { writer_.finish(); }
  [[nodiscard]] std::int64_t frames() const override { return writer_.frames(); }

 private:
  VtkhdfWriter writer_;
};

}  // namespace

std::unique_ptr<RowSink> FolderRecorder::open_rows(const std::string& name,
                                                   const std::vector<std::string>& columns,
                                                   std::int64_t kept) {
  return std::make_unique<FileRows>(folder_.file(name + ".csv"), columns, kept);
}

std::unique_ptr<FrameSink> FolderRecorder::open_frames(const std::string& name, std::int64_t kept) {
  return std::make_unique<FileFrames>(folder_.file(name + ".vtkhdf"), kept);
}

bool FolderRecorder::has_checkpoint() const {
  return std::filesystem::exists(folder_.checkpoint()) ||
         std::filesystem::exists(folder_.previous_checkpoint());
}

void FolderRecorder::save_checkpoint(const CheckpointBody& body) {
  rotate_checkpoints(folder_, body);
}

void FolderRecorder::read_checkpoint(const std::function<void(const std::string& path)>& read) {
  read_newest_checkpoint(
      folder_, [this](const std::string& text) { warn(text); }, read);
}

void FolderRecorder::save_failure(const CheckpointBody& body) {
  write_checkpoint_file(folder_.failure(), body);
  log_.warn("the state at the failure is in " + folder_.failure());
}

std::string FolderRecorder::resolved_case() const {
  return read_file(folder_.resolved_case());
}

void write_outcome(const Outcome& outcome, const ResultFolder& folder) {
  for (const NamedTable& one : outcome.tables) write_csv(folder.file(one.name + ".csv"), one.table);
  for (const NamedFrames& one : outcome.frames) {
    VtkhdfWriter writer(folder.file(one.name + ".vtkhdf"), 0);
    for (const PolyFrame& frame : one.frames) writer.append(frame);
    writer.finish();
  }
  for (const NamedPrisms& one : outcome.prisms) write_prisms(folder.file(one.name + ".vtkhdf"), one.prisms);
  write_summary(folder.summary(), outcome.summary);
}

}  // namespace fiberfate
