// Visits nodes down the flow, a level at a time.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <span>
#include <thread>
#include <vector>

#include "molding/step_flow.hpp"

namespace fiberfate {

/// How many nodes a part of a level has: an even number of parts that keeps two threads busy in small
/// levels, of at most 16 nodes in large ones. The same for any number of threads.
[[nodiscard]] inline std::size_t nodes_of_a_part(std::size_t nodes_of_the_level) {
  constexpr std::size_t most = 16;
  const std::size_t parts = 2 * ((nodes_of_the_level + 2 * most - 1) / (2 * most));
  return (nodes_of_the_level + parts - 1) / parts;
}

/// Lets the other thread of a core go ahead for a moment, where there may be one.
inline void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// Calls body(nodes) for parts of each level in turn, on all threads: what a node takes from upstream is
/// final. `body` must not throw.
///
/// Threads take parts in order and wait only until the level before is complete. There is no barrier: levels
/// are many and small, and a thread that has lost its processor must not stop the others. A thread that waits
/// looks again for as long as a part takes before it offers its processor to other programs, from which it
/// would get it back a thousand times later.
template <class Body>
void sweep_down_the_flow(const StepFlow& step, const Body& body) {
  struct Part {
    std::span<const Index> nodes;
    std::size_t before;  ///< parts of the levels before
  };
  constexpr int looks_before_yielding = 2000;  // some 50 µs
  std::vector<Part> parts;
  for (std::size_t level = 0; level + 1 < step.level_begin.size(); ++level) {
    const std::size_t before = parts.size(), end = step.level_begin[level + 1];
    const std::size_t size = nodes_of_a_part(end - step.level_begin[level]);
    for (std::size_t first = step.level_begin[level]; first < end; first += size)
      parts.push_back({std::span(step.order).subspan(first, std::min(size, end - first)), before});
  }
  std::atomic<std::size_t> taken = 0, done = 0;
#pragma omp parallel
  {
    for (std::size_t p = taken++; p < parts.size(); p = taken++) {
      for (int looks = 0; done.load(std::memory_order_acquire) < parts[p].before; ++looks) {
        if (looks < looks_before_yielding)
          pause_briefly();
        else
          std::this_thread::yield();
      }
      body(parts[p].nodes);
      done.fetch_add(1, std::memory_order_acq_rel);
    }
  }
}

}  // namespace fiberfate
