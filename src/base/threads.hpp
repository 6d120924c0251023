// Runs loops over threads so that the answer does not depend on how many there are.
#pragma once

#include <omp.h>

#include <cstddef>

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

/// The same for iterations of very different length: threads take them eight at a time as they get free.
template <class Body>
void parallel_for_uneven(std::ptrdiff_t count, const Body& body) {
#pragma omp parallel for schedule(dynamic, 8)
  for (std::ptrdiff_t i = 0; i < count; ++i) body(i);
}

}  // namespace fiberfate
