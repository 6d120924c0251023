// Sorts loads by rod.
#include "dynamics/rod_loads.hpp"

namespace fiberfate {

void RodLoads::arrange(Index nodes, std::span<const Index> rods, std::vector<Index>& slots) {
  begin_.assign(static_cast<std::size_t>(nodes) + 1, 0);
  for (const Index rod : rods) ++begin_[static_cast<std::size_t>(rod) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  next_.assign(begin_.begin(), begin_.end() - 1);
  slots.resize(rods.size());
  for (std::size_t i = 0; i < rods.size(); ++i) slots[i] = next_[static_cast<std::size_t>(rods[i])]++;
  loads_.resize(rods.size());
}

}  // namespace fiberfate
