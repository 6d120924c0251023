// What a study computes, in memory.
#pragma once

#include <string>
#include <vector>

#include "io/csv_table.hpp"
#include "io/poly_frame.hpp"
#include "io/prism_file.hpp"
#include "results/summary.hpp"

namespace fiberfate {

/// A table and its name: "histogram" is written as histogram.csv.
struct NamedTable {
  std::string name;
  CsvTable table;
};

/// Frames over time and their name: "result" is written as result.vtkhdf.
struct NamedFrames {
  std::string name;
  std::vector<PolyFrame> frames;
};

/// A stack of prisms and its name: "layers" is written as layers.vtkhdf.
struct NamedPrisms {
  std::string name;
  PrismMesh prisms;
};

/// Everything that a study computes. What a study streams goes to a Recorder row by row instead, and comes
/// back here where that is a MemoryRecorder.
struct Outcome {
  RunSummary summary;
  std::vector<NamedTable> tables = {};
  std::vector<NamedFrames> frames = {};
  std::vector<NamedPrisms> prisms = {};
  std::vector<std::string> headlines = {};  ///< what came out, a line each: "L_N 1.2 mm, L_W 2.1 mm"

  /// Finds a table by name; raises StorageError when there is none.
  [[nodiscard]] const CsvTable& table(const std::string& name) const;
};

/// What ends a run that has nothing to show: it was stopped where nothing can be kept, or had nothing to do.
struct NoOutcome {
  StopReason reason = StopReason::signal;
  std::string message;  ///< "stopped while packing; resuming will pack again"
};

}  // namespace fiberfate
