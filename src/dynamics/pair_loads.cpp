// Collects the shares of eight fibers in slots, and chooses the kernel that adds them.
#include "dynamics/pair_loads.hpp"

#include <algorithm>
#include <array>

#include "base/kernels.hpp"
#include "dynamics/chain_assembly.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group))

namespace {

constexpr int lanes = 8;

/// Asks the memory for a force long before it is read: forces lie far apart.
void fetch(const PairForce& force) {
  const auto* bytes = reinterpret_cast<const char*>(&force);
  __builtin_prefetch(bytes);
  __builtin_prefetch(bytes + sizeof(PairForce) - 1);
}

}  // namespace

void PairSlots::collect(const PairForces& pairs, const ChainGroup& group) {
  const auto forces = pairs.forces();
  numbers_.clear();
  ends_.clear();
  for (int k = 0; k + 1 < group.nodes; ++k) {
    const std::size_t begin = numbers_.size();
    for (int lane = 0; lane < lanes; ++lane) {
      if (k >= group.used[lane]) continue;
      std::size_t slot = begin;
      for (const PairForces::Share& share : pairs.of_rod(group.first[lane] + k)) {
        if (slot == numbers_.size()) numbers_.resize(slot + lanes, -1);
        numbers_[slot + static_cast<std::size_t>(lane)] = share.number;
        fetch(forces[static_cast<std::size_t>(share.number / 2)]);
        slot += lanes;
      }
    }
    ends_.push_back(static_cast<int>(numbers_.size() / lanes));
  }
}

void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group) {
  return FIBERFATE_KERNEL(add_pair_loads)(query, group);
}

}  // namespace fiberfate
