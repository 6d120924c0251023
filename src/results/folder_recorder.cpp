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
  [[nodiscard]] std::uint64_t digest() const override { return writer_.digest(); }

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

void write_digest(Hdf5File& file, const std::string& table, std::uint64_t digest) {
  const auto number = static_cast<std::int64_t>(digest);
  file.write("digests/" + table, std::span<const std::int64_t>(&number, 1));
}

}  // namespace

std::unique_ptr<RowSink> FolderRecorder::open_rows(const std::string& name,
                                                   const std::vector<std::string>& columns,
                                                   std::int64_t kept) {
  const std::string path = owned_.make(name + ".csv");
  auto rows = std::make_unique<FileRows>(path, columns, kept);
  const auto known = kept_digests_.find(name);
  if (kept > 0 && known != kept_digests_.end() && known->second != rows->digest())
    throw StorageError("cannot continue " + path +
                       ": its rows are not those that the checkpoint knows; put the file back as it was");
  open_rows_[name] = rows.get();
  return rows;
}

std::unique_ptr<FrameSink> FolderRecorder::open_frames(const std::string& name, std::int64_t kept) {
  owned_.make(name + ".vtkhdf.next");
  return std::make_unique<FileFrames>(owned_.make(name + ".vtkhdf"), kept);
}

bool FolderRecorder::has_checkpoint() const {
  return std::filesystem::exists(folder().checkpoint()) ||
         std::filesystem::exists(folder().previous_checkpoint());
}

void FolderRecorder::save_checkpoint(const CheckpointBody& body) {
  owned_.make("checkpoint.h5");
  owned_.make("checkpoint.previous.h5");
  rotate_checkpoints(folder(), [&](Hdf5File& file) {
    body(file);
    save_digests(file);
  });
}

void FolderRecorder::read_checkpoint(const std::function<void(const std::string& path)>& read) {
  const auto read_all = [&](const std::string& path) {
    read(path);
    read_digests(path);
  };
  const auto warn_of = [this](const std::string& text) { warn(text); };
  // The next checkpoint must not push the only sound one out.
  if (read_newest_checkpoint(folder(), warn_of, read_all) == CheckpointAge::previous)
    rename_file(folder().previous_checkpoint(), folder().checkpoint());
}

void FolderRecorder::save_failure(const CheckpointBody& body) {
  write_checkpoint_file(owned_.make("failure.h5"), body);
  log_.warn("the state at the failure is in " + folder().failure());
}

std::string FolderRecorder::resolved_case() const {
  return read_file(folder().resolved_case());
}

void FolderRecorder::save_digests(Hdf5File& file) const {
  file.make_group("digests");
  for (const auto& [name, rows] : open_rows_) write_digest(file, name, rows->digest());
}

void FolderRecorder::read_digests(const std::string& checkpoint) {
  const Hdf5File file = Hdf5File::open(checkpoint, Hdf5File::Access::read);
  if (!file.contains("digests")) return;  // of an earlier version
  for (const std::string& name : file.members("digests"))
    kept_digests_[name] = static_cast<std::uint64_t>(file.read<std::int64_t>("digests/" + name).at(0));
}

void write_outcome(const Outcome& outcome, OwnedFolder& folder) {
  for (const NamedTable& one : outcome.tables) write_csv(folder.make(one.name + ".csv"), one.table);
  for (const NamedFrames& one : outcome.frames) {
    folder.make(one.name + ".vtkhdf.next");
    VtkhdfWriter writer(folder.make(one.name + ".vtkhdf"), 0);
    for (const PolyFrame& frame : one.frames) writer.append(frame);
    writer.finish();
  }
  for (const NamedPrisms& one : outcome.prisms) write_prisms(folder.make(one.name + ".vtkhdf"), one.prisms);
  write_summary(folder.make("summary.json"), outcome.summary);
}

}  // namespace fiberfate
