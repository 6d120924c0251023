// Watches for signals.
#include "app/signals.hpp"

#include <csignal>

namespace fiberfate {
namespace {

volatile std::sig_atomic_t requested = 0;

void take_note(int number) {
  requested = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void watch_for_signals() {
  std::signal(SIGTERM, take_note);
  std::signal(SIGINT, take_note);
}

bool stop_requested() {
  return requested != 0;
}

}  // namespace fiberfate
