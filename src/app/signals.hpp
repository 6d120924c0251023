// Lets a signal end a run in good order instead of at once.
#pragma once

namespace fiberfate {

/// While it lives, SIGTERM and SIGINT only leave a note that stop_requested() tells; a second one ends the
/// program at once.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
};

/// Whether a signal has asked the run to stop.
[[nodiscard]] bool stop_requested();

}  // namespace fiberfate
