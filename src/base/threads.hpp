// Runs loops over threads so that the answer does not depend on how many there are.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Tells how many threads a parallel loop uses.
[[nodiscard]] inline int thread_count() {
  return omp_get_max_threads();
}

/// Sets how many threads the parallel loops of this process use (at least 1).
inline void use_threads(int count) {
  omp_set_num_threads(count < 1 ? 1 : count);
}

/// Calls body(i) for i in [0, count) on all threads. Iterations must not write what another one reads:
/// each then does the same arithmetic wherever it runs, and the result is bitwise the same for any thread
/// count.
template <class Body>
void parallel_for(std::ptrdiff_t count, const Body& body) {
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < count; ++i) body(i);
}

/// Tells which of consecutive items is the first of a share, when `shares` of about equal weight are made;
/// item i weighs running[i + 1] − running[i].
[[nodiscard]] inline std::ptrdiff_t share_begin(std::span<const Index> running, int share, int shares) {
  const auto items = static_cast<std::ptrdiff_t>(running.size()) - 1;
  if (share >= shares) return items;
  const auto weight = static_cast<std::ptrdiff_t>(running.back()) * share / shares;
  return std::min(items, std::lower_bound(running.begin(), running.end(), weight) - running.begin());
}

/// The same for items of known weight: every thread takes one share of them, and the same one each time, so
/// that what it wrote is near when it comes back.
template <class Body>
void parallel_for_weighted(std::span<const Index> running, const Body& body) {
#pragma omp parallel
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    const std::ptrdiff_t end = share_begin(running, thread + 1, threads);
    for (std::ptrdiff_t i = share_begin(running, thread, threads); i < end; ++i) body(i);
  }
}

/// Holds scratch for every thread, each on cache lines of its own: threads that write into one line wait for
/// one another.
template <class Scratch>
class PerThread {
 public:
  /// Sees to it that all threads have theirs; call before a parallel loop.
  void fit() { slots_.resize(std::max(slots_.size(), static_cast<std::size_t>(thread_count()))); }
  /// Scratch of the calling thread.
  [[nodiscard]] Scratch& mine() { return slots_[static_cast<std::size_t>(omp_get_thread_num())].scratch; }

 private:
  struct alignas(128) Slot {
    Scratch scratch;
  };
  std::vector<Slot> slots_;
};

}  // namespace fiberfate
