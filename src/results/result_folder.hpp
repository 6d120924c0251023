// Names the files of a result folder and guards those of an earlier run.
#pragma once

#include <string>
#include <vector>

#include "results/run_types.hpp"

namespace fiberfate {

/// Stands for the folder in which a run leaves its files (docs/formats/results.md).
class ResultFolder {
 public:
  /// Makes a folder for a new run. One that holds a result is refused (InputError), or with
  /// Existing::overwrite emptied of the files of that result; other files in it are never touched.
  [[nodiscard]] static ResultFolder create(const std::string& path, Existing existing);
  /// Opens the folder of an earlier run; raises InputError when it holds none.
  [[nodiscard]] static ResultFolder open(const std::string& path);

  /// Removes the files of the result, and the folder where that leaves it empty.
  void remove() const;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string resolved_case() const { return file("case.resolved.toml"); }
  [[nodiscard]] std::string summary() const { return file("summary.json"); }
  [[nodiscard]] std::string series() const { return file("series.csv"); }
  [[nodiscard]] std::string breaks() const { return file("breaks.csv"); }
  [[nodiscard]] std::string frames() const { return file("result.vtkhdf"); }
  [[nodiscard]] std::string checkpoint() const { return file("checkpoint.h5"); }
  [[nodiscard]] std::string previous_checkpoint() const { return file("checkpoint.previous.h5"); }
  [[nodiscard]] std::string failure() const { return file("failure.h5"); }
  [[nodiscard]] std::string log() const { return file("log.txt"); }
  [[nodiscard]] std::string report() const { return file("report.html"); }
  /// Names a file of a study's own.
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + '/' + name; }

 private:
  explicit ResultFolder(std::string path) : path_(std::move(path)) {}
  [[nodiscard]] bool holds_result() const;
  std::string path_;
};

}  // namespace fiberfate
