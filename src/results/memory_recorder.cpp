// Keeps what a study makes in memory.
#include "results/memory_recorder.hpp"

#include "base/error.hpp"

namespace fiberfate {
namespace {

class MemoryRows final : public RowSink {
 public:
  explicit MemoryRows(std::shared_ptr<CsvTable> table) : table_(std::move(table)) {}
  void append(std::span<const double> row) override { table_->append(row); }
  void flush() override {}
  void sync() override {}
  [[nodiscard]] std::int64_t rows() const override { return static_cast<std::int64_t>(table_->rows()); }

 private:
  std::shared_ptr<CsvTable> table_;
};

class MemoryFrames final : public FrameSink {
 public:
  explicit MemoryFrames(std::shared_ptr<std::vector<PolyFrame>> frames) : frames_(std::move(frames)) {}
  void append(const PolyFrame& frame) override { frames_->push_back(frame); }
  void finish() override {}
  [[nodiscard]] std::int64_t frames() const override { return static_cast<std::int64_t>(frames_->size()); }

 private:
  std::shared_ptr<std::vector<PolyFrame>> frames_;
};

void require_nothing_kept(const std::string& name, std::int64_t kept) {
  if (kept > 0) throw StorageError("memory keeps nothing of an earlier run's " + name);
}

}  // namespace

std::unique_ptr<RowSink> MemoryRecorder::open_rows(const std::string& name,
                                                   const std::vector<std::string>& columns,
                                                   std::int64_t kept) {
  require_nothing_kept(name, kept);
  const auto table = std::make_shared<CsvTable>(CsvTable{columns});
  tables_[name] = table;
  return std::make_unique<MemoryRows>(table);
}

std::unique_ptr<FrameSink> MemoryRecorder::open_frames(const std::string& name, std::int64_t kept) {
  require_nothing_kept(name, kept);
  const auto frames = std::make_shared<std::vector<PolyFrame>>();
  frames_[name] = frames;
  return std::make_unique<MemoryFrames>(frames);
}

void MemoryRecorder::read_checkpoint(const std::function<void(const std::string& path)>&) {
  throw StorageError("memory keeps no checkpoint");
}

void MemoryRecorder::hand_over(Outcome& outcome) {
  std::vector<NamedTable> tables;
  for (auto& [name, table] : tables_) tables.push_back({name, std::move(*table)});
  std::vector<NamedFrames> frames;
  for (auto& [name, list] : frames_) frames.push_back({name, std::move(*list)});
  outcome.tables.insert(outcome.tables.begin(), std::make_move_iterator(tables.begin()),
                        std::make_move_iterator(tables.end()));
  outcome.frames.insert(outcome.frames.begin(), std::make_move_iterator(frames.begin()),
                        std::make_move_iterator(frames.end()));
  tables_.clear();
  frames_.clear();
}

}  // namespace fiberfate
