// Sorts loads by rod.
#include "dynamics/rod_loads.hpp"

namespace fiberfate {

void RodLoads::reset(Index nodes) {
  begin_.assign(static_cast<std::size_t>(nodes) + 1, 0);
}

void RodLoads::allocate() {
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  next_.assign(begin_.begin(), begin_.end() - 1);
  loads_.resize(static_cast<std::size_t>(begin_.back()));
}

}  // namespace fiberfate
