// Watches for signals.
#include "app/signals.hpp"

#include <csignal>
#include <initializer_list>

namespace fiberfate {
namespace {

volatile std::sig_atomic_t requested = 0;

void take_note(int number) {
  requested = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

SignalWatch::SignalWatch() {
  requested = 0;
  std::signal(SIGTERM, take_note);
  std::signal(SIGINT, take_note);
}

SignalWatch::~SignalWatch() {
  for (const int number : {SIGTERM, SIGINT}) std::signal(number, SIG_DFL);
}

bool stop_requested() {
  return requested != 0;
}

}  // namespace fiberfate
