// Keeps the log of a run with spdlog.
#include "results/run_log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "base/error.hpp"

namespace fiberfate {

RunLog::RunLog(const std::string& path) {
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(path);
    file_ = std::make_shared<spdlog::logger>("run", std::move(sink));
  } catch (const spdlog::spdlog_ex& error) {
    throw StorageError(error.what());
  }
  file_->set_pattern("%Y-%m-%d %H:%M:%S  %l  %v");
  file_->flush_on(spdlog::level::info);
  // A log that cannot be written (full disk) must not hide the error that matters, nor repeat itself.
  file_->set_error_handler([](const std::string&) {});
}

RunLog::~RunLog() = default;

void RunLog::note(const std::string& text) {
  file_->info(text);
}

void RunLog::warn(const std::string& text) {
  file_->warn(text);
  std::fprintf(stderr, "fiberfate: %s\n", text.c_str());
}

void RunLog::error(const std::string& text) {
  file_->error(text);
}

}  // namespace fiberfate
