// Loops over threads whose answer does not depend on how many there are.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <span>
#include <vector>

#include "base/index.hpp"

namespace fiberfate {

/// How many threads a parallel loop uses.
[[nodiscard]] inline int thread_count() {
  return omp_get_max_threads();
}

/// Sets how many threads the parallel loops of this process use (at least 1).
inline void use_threads(int count) {
  omp_set_num_threads(count < 1 ? 1 : count);
}

/// Uses no more threads than a piece of work keeps busy, for as long as it lives: waiting for one another
/// costs small work more than it saves, and much more where others want the cores.
class SuitableThreads {
 public:
  /// Takes the work, and how much of it a thread is worth.
  SuitableThreads(std::int64_t work, std::int64_t work_a_thread) : before_(thread_count()) {
    use_threads(static_cast<int>(std::min<std::int64_t>(before_, 1 + work / work_a_thread)));
  }
  ~SuitableThreads() { use_threads(before_); }
  SuitableThreads(const SuitableThreads&) = delete;
  SuitableThreads& operator=(const SuitableThreads&) = delete;

 private:
  int before_;
};

/// Carries out of a parallel region what is thrown in it; elsewhere it would end the program. Of several
/// threads that fail the first one counts: as threads take consecutive items, that is the failure of the
/// first item that fails, whatever the number of threads.
class ThreadFailure {
 public:
  /// Runs the share of a thread.
  template <class Work>
  void guard(int thread, const Work& work) noexcept {
    try {
      work();
    } catch (...) {
      keep(thread, std::current_exception());
    }
  }
  /// Throws what was kept; to be called after the region.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void keep(int thread, std::exception_ptr failure) noexcept {
#pragma omp critical(fiberfate_thread_failure)
    if (thread < thread_) {
      thread_ = thread;
      failure_ = failure;
    }
  }

  int thread_ = std::numeric_limits<int>::max();
  std::exception_ptr failure_;
};

/// Calls body(i) for i in [0, count) on all threads. Iterations must not write what another one reads:
/// each then does the same arithmetic wherever it runs, and the result is bitwise the same for any thread
/// count. Throws what the first iteration throws that does; which of the later ones have run is then open.
template <class Body>
void parallel_for(std::ptrdiff_t count, const Body& body) {
  ThreadFailure failure;
#pragma omp parallel
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    failure.guard(thread, [&] {
      const std::ptrdiff_t end = count * (thread + 1) / threads;
      for (std::ptrdiff_t i = count * thread / threads; i < end; ++i) body(i);
    });
  }
  failure.rethrow();
}

/// The same for the things of a kind.
template <class I, class Body>
void parallel_for(IndexRange<I> range, const Body& body) {
  parallel_for(range.size(), [&](std::ptrdiff_t i) { body(range.front() + static_cast<Index>(i)); });
}

/// The first of consecutive items that belongs to a share, when `shares` of about equal weight are made;
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
  ThreadFailure failure;
#pragma omp parallel
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    failure.guard(thread, [&] {
      const std::ptrdiff_t end = share_begin(running, thread + 1, threads);
      for (std::ptrdiff_t i = share_begin(running, thread, threads); i < end; ++i) body(i);
    });
  }
  failure.rethrow();
}

/// The same for things of a kind that own those of another, numbered in order: fibers weigh what they have
/// nodes.
template <class I, class Kind, class Body>
void parallel_for_weighted(const IndexedVector<I, IndexOf<Kind>>& running, const Body& body) {
  parallel_for_weighted(numbers(running), [&](std::ptrdiff_t i) { body(I(i)); });
}

/// Scratch of every thread, each on cache lines of its own: threads that write into one line wait for
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
