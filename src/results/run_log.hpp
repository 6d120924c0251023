// Keeps the log of a run.
#pragma once

#include <memory>
#include <string>

namespace spdlog {
class logger;
}

namespace fiberfate {

/// Writes dated lines to log.txt of a result folder; warnings go to standard error too.
class RunLog {
 public:
  /// Opens the log, after what it already holds; raises StorageError.
  explicit RunLog(const std::string& path);
  ~RunLog();
  void note(const std::string& text);
  void warn(const std::string& text);
  void error(const std::string& text);

 private:
  std::shared_ptr<spdlog::logger> file_;
};

}  // namespace fiberfate
