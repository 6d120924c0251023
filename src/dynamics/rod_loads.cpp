// Sorts loads by rod.
#include "dynamics/rod_loads.hpp"

#include <utility>

namespace fiberfate {

void RodLoads::arrange(Index nodes, std::span<const Claim> claims, std::vector<Slot>& slots) {
  const auto rods = first_indices<RodIndex>(nodes);
  begin_.assign(nodes + 1, Slot(0));
  for (const Claim& claim : claims) ++begin_[claim.rod + 1];
  for (const RodIndex rod : rods) begin_[rod + 1] = begin_[rod + 1] + begin_[rod].value();
  next_ = begin_;
  claim_.resize(claims.size());
  for (std::size_t i = 0; i < claims.size(); ++i) claim_[next_[claims[i].rod]++] = i;
  for (const RodIndex rod : rods) sort_rod(rod, claims);
  slots.resize(claims.size());
  for (const Slot slot : claim_.indices()) slots[claim_[slot]] = slot;
  loads_.resize(claims.size());
}

void RodLoads::sort_rod(RodIndex rod, std::span<const Claim> claims) {
  const auto key = [&](Slot slot) { return claims[claim_[slot]].key; };
  // Rods carry a few loads at most: insertion is fastest.
  for (Slot i = begin_[rod]; i < begin_[rod + 1]; ++i) {
    for (Slot j = i; j > begin_[rod] && key(j) < key(j - 1); j = j - 1) std::swap(claim_[j], claim_[j - 1]);
  }
}

}  // namespace fiberfate
