// Sorts loads by rod.
#include "dynamics/rod_loads.hpp"

#include <utility>

namespace fiberfate {

void RodLoads::arrange(Index nodes, std::span<const Claim> claims, std::vector<Index>& slots) {
  begin_.assign(static_cast<std::size_t>(nodes) + 1, 0);
  for (const Claim& claim : claims) ++begin_[static_cast<std::size_t>(claim.rod) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  next_.assign(begin_.begin(), begin_.end() - 1);
  order_.resize(claims.size());
  for (std::size_t i = 0; i < claims.size(); ++i)
    order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(claims[i].rod)]++)] =
        static_cast<Index>(i);
  for (std::size_t rod = 0; rod + 1 < begin_.size(); ++rod) sort_rod(rod, claims);
  slots.resize(claims.size());
  for (std::size_t slot = 0; slot < order_.size(); ++slot)
    slots[static_cast<std::size_t>(order_[slot])] = static_cast<Index>(slot);
  loads_.resize(claims.size());
}

void RodLoads::sort_rod(std::size_t rod, std::span<const Claim> claims) {
  const auto key = [&](Index place) {
    return claims[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])].key;
  };
  // Rods carry a few loads at most: insertion is fastest.
  for (Index i = begin_[rod] + 1; i < begin_[rod + 1]; ++i) {
    for (Index j = i; j > begin_[rod] && key(j) < key(j - 1); --j)
      std::swap(order_[static_cast<std::size_t>(j)], order_[static_cast<std::size_t>(j - 1)]);
  }
}

}  // namespace fiberfate
