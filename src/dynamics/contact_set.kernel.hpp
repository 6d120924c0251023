// Adds measured pairs to the arrays of contacts, eight at a time.
#include "base/simd_rows.hpp"
#include "dynamics/contact_arrays.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate::FIBERFATE_ISA {

int add_contacts(const SegmentBlock& block, int count, const ContactColumns& to) {
  int added = 0;
  for (int i = 0; i < count; i += lanes) {
    const std::uint32_t bits = block.near[i / lanes];
    if (bits == 0) continue;
    write_selected(to.first + added, read_indices(block.first + i), bits);
    write_selected(to.second + added, read_indices(block.second + i), bits);
    write_selected(to.image + added, read_indices(block.image + i), bits);
    write_selected(to.s + added, load(block.s + i), bits);
    write_selected(to.t + added, load(block.t + i), bits);
    const Pack distance = load(block.distance + i);
    write_selected(to.distance + added, distance, bits);
    const Pack length = choose(distance > 0.0, distance, broadcast(1));
    for (int d = 0; d < 3; ++d)
      write_selected(to.normal[d] + added, load(block.separation[d] + i) / length, bits);
    added += __builtin_popcount(bits);
  }
  return added;
}

}  // namespace fiberfate::FIBERFATE_ISA
