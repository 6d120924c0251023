// Collects the shares of eight fibers in slots, and chooses the kernel that adds them.
#include "dynamics/pair_loads.hpp"

#include <algorithm>
#include <array>

#include "base/kernels.hpp"
#include "dynamics/chain_assembly.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group))

namespace {

constexpr std::size_t lanes = 8;

/// Asks the memory for a force long before it is read: forces lie far apart.
void fetch(const PairForce& force) {
  const auto* bytes = reinterpret_cast<const char*>(&force);
  __builtin_prefetch(bytes);
  __builtin_prefetch(bytes + sizeof(PairForce) - 1);
}

}  // namespace

void PairSlots::collect(const PairForces& pairs, const ChainGroup& group) {
  const auto forces = pairs.forces();
  ends_.clear();
  std::size_t begin = 0;
  for (int k = 0; k + 1 < group.nodes; ++k) {
    std::array<std::span<const PairForces::Share>, lanes> shares;
    std::size_t most = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (k < group.used[lane]) shares[lane] = pairs.of_rod(RodIndex(group.first[lane] + k));
      most = std::max(most, shares[lane].size());
    }
    if (numbers_.size() < begin + most * lanes) numbers_.resize(2 * (begin + most * lanes));
    Index* const slots = numbers_.data() + begin;
    std::fill_n(slots, most * lanes, -1);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      Index* slot = slots + lane;
      for (const PairForces::Share& share : shares[lane]) {
        *slot = share.number;
        slot += lanes;
        fetch(forces[share.number / 2]);
      }
    }
    begin += most * lanes;
    ends_.push_back(static_cast<int>(begin / lanes));
  }
}

void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group) {
  return FIBERFATE_KERNEL(add_pair_loads)(query, group);
}

}  // namespace fiberfate
