// Chains the forces of contacts to their rods.
#include "dynamics/pair_forces.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/threads.hpp"
#include "fibers/rod_pairs.hpp"

namespace fiberfate {
namespace {

std::int64_t key_of(Index other, std::int32_t image) {
  return static_cast<std::int64_t>(other) << 24 | image;
}

}  // namespace

void PairForces::reset(Index nodes, Index forces) {
  head_.assign(static_cast<std::size_t>(nodes), -1);
  forces_.resize(static_cast<std::size_t>(forces));
  links_.resize(2 * forces_.size());
}

void PairForces::link(Index begin, const ContactChunk& contacts) {
  const bool alone = thread_count() == 1;
  const auto put = [&](Index rod, Index share, std::int64_t key) {
    Index& head = head_[static_cast<std::size_t>(rod)];
    const Index next = alone ? std::exchange(head, share)
                             : std::atomic_ref<Index>(head).exchange(share, std::memory_order_relaxed);
    links_[static_cast<std::size_t>(share)] = {key, next};
  };
  for (Index c = 0; c < contacts.count; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const std::int32_t image = contacts.image[i];
    const std::int32_t back = image == 0 ? 0 : pack_image(-unpack_image(image));
    put(contacts.first[i], 2 * (begin + c), key_of(contacts.second[i], image));
    put(contacts.second[i], 2 * (begin + c) + 1, key_of(contacts.first[i], back));
  }
}

void PairForces::of_rod(Index rod, std::vector<Share>& shares) const {
  const auto begin = static_cast<std::ptrdiff_t>(shares.size());
  for (Index share = head_[static_cast<std::size_t>(rod)]; share >= 0;) {
    const Link& link = links_[static_cast<std::size_t>(share)];
    shares.push_back({link.key, share / 2, share % 2 == 0});
    share = link.next;
  }
  std::sort(shares.begin() + begin, shares.end(),
            [](const Share& a, const Share& b) { return a.key < b.key; });
}

}  // namespace fiberfate
