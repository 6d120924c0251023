// Lets a signal end a run in good order instead of at once.
#pragma once

namespace fiberfate {

/// From now on SIGTERM and SIGINT only leave a note that stop_requested() tells; a second one of a kind ends
/// the program at once. One that comes when the last run is over changes nothing.
void watch_for_signals();

/// Whether a signal has asked the program to stop.
[[nodiscard]] bool stop_requested();

}  // namespace fiberfate
