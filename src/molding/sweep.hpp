// Visits nodes down the flow, a level at a time.
#pragma once

#include <algorithm>
#include <span>

#include "base/threads.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// Calls body(nodes) for parts of each level in turn, on all threads: what a node takes from upstream is
/// final. The parts are the same for any number of threads.
template <class Body>
void sweep_down_the_flow(const StepFlow& step, const Body& body) {
  constexpr std::size_t part = 16;
  for (std::size_t level = 0; level + 1 < step.level_begin.size(); ++level) {
    const std::size_t begin = step.level_begin[level], size = step.level_begin[level + 1] - begin;
    const auto nodes = std::span(step.order).subspan(begin, size);
    const std::size_t parts = (size + part - 1) / part;
    const auto visit = [&](std::ptrdiff_t p) {
      const std::size_t first = static_cast<std::size_t>(p) * part;
      body(nodes.subspan(first, std::min(part, size - first)));
    };
    if (parts == 1) {
      visit(0);
    } else {
      parallel_for(static_cast<std::ptrdiff_t>(parts), visit);
    }
  }
}

}  // namespace fiberfate
