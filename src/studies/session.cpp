// How one study runs.
#include "studies/session.hpp"

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

#include "base/threads.hpp"
#include "base/timer.hpp"

namespace fiberfate {
namespace {

/// Starts so many threads for a moment and tells how many that could be; the library of parallel loops would
/// end the program instead.
int startable_threads(int wanted) {
  std::atomic<bool> over = false;
  std::vector<std::thread> threads;
  threads.reserve(wanted);
  try {
    while (static_cast<int>(threads.size()) + 1 < wanted) threads.emplace_back([&over] { over.wait(false); });
  } catch (const std::exception&) {  // std::system_error, or no memory for it
  }
  over = true;
  over.notify_all();
  for (std::thread& one : threads) one.join();
  return static_cast<int>(threads.size()) + 1;
}

}  // namespace

Session::Session(Recorder& recorder, SessionOptions options, SessionCalls calls, Begin begin)
    : recorder_(recorder),
      options_(options),
      calls_(std::move(calls)),
      begin_(begin),
      begin_wall_(wall_seconds()),
      begin_cpu_(cpu_seconds()) {}

bool Session::continues() const {
  return begin_ == Begin::where_it_stopped && recorder_.has_checkpoint();
}

bool Session::stop_requested() const {
  return calls_.stop_requested && calls_.stop_requested();
}

void Session::end_if_stopped(const std::string& message) const {
  if (stop_requested()) throw NoOutcome{StopReason::signal, message};
}

void Session::show(const std::function<std::string()>& text) const {
  if (calls_.progress) calls_.progress(text);
}

void Session::end_progress() const {
  if (calls_.progress_ended) calls_.progress_ended();
}

int Session::use_threads(int of_case) const {
  const int chosen = options_.threads.value_or(of_case);
  const int wanted = chosen > 0 ? chosen : static_cast<int>(std::thread::hardware_concurrency());
  const int possible = startable_threads(wanted);
  if (possible < wanted)
    recorder_.warn(
        fmt::format("only {} of {} threads can be started: memory or the number of processes is limited",
                    possible, wanted));
  fiberfate::use_threads(possible);
  return thread_count();
}

double Session::wall_s() const {
  return wall_seconds() - begin_wall_;
}

double Session::cpu_s() const {
  return cpu_seconds() - begin_cpu_;
}

}  // namespace fiberfate
