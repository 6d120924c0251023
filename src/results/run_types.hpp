// Words for how a run begins and ends.
#pragma once

#include <array>
#include <cstddef>

namespace fiberfate {

/// Why a run ended; the names go to summary.json as stop_reason.
enum class StopReason { done, time_reached, steps_reached, signal };

[[nodiscard]] constexpr const char* name(StopReason reason) {
  constexpr std::array names = {"done", "time_reached", "steps_reached", "signal"};
  return names[static_cast<std::size_t>(reason)];
}

/// What becomes of an existing result where a new one is to be written.
enum class Existing { refuse, overwrite };

}  // namespace fiberfate
