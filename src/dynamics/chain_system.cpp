// Provides aligned storage for the systems of eight fibers.
#include "dynamics/chain_system.hpp"

#include <new>

namespace fiberfate {
namespace {

double* allocate_aligned(std::size_t count) {
  void* memory = std::aligned_alloc(64, count * sizeof(double));
  if (memory == nullptr) throw std::bad_alloc();
  return static_cast<double*>(memory);
}

}  // namespace

void ChainSystem::reserve(int nodes) {
  if (nodes <= capacity_) return;
  const auto count = static_cast<std::size_t>(nodes) * lanes;
  records_.reset(allocate_aligned(count * size));
  factors_.reset(allocate_aligned(count * kept));
  capacity_ = nodes;
}

}  // namespace fiberfate
