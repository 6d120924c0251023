// Adds and reads contacts.
#include "dynamics/contact_set.hpp"

#include <algorithm>

#include "base/kernels.hpp"
#include "dynamics/contact_arrays.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(int add_contacts(const SegmentBlock& block, int count, const ContactColumns& to))

namespace {

constexpr int pack_size = 8;

}  // namespace

void ContactChunk::reserve(int contacts) {
  const std::size_t room = contacts + pack_size - 1;
  if (first.size() >= room) return;
  for (auto* array : {&first, &second}) array->resize(2 * room);
  for (auto* array : {&first_material, &second_material}) array->resize(2 * room, 0);
  for (auto* array : {&s, &t, &normal_x, &normal_y, &normal_z, &distance}) array->resize(2 * room, 0.0);
  image.resize(2 * room, 0);
}

void ContactChunk::add(const SegmentBlock& block, int pairs) {
  const ContactColumns to = {numbers(first).data() + count,
                             numbers(second).data() + count,
                             image.data() + count,
                             s.data() + count,
                             t.data() + count,
                             {normal_x.data() + count, normal_y.data() + count, normal_z.data() + count},
                             distance.data() + count};
  count += FIBERFATE_KERNEL(add_contacts)(block, pairs, to);
}

Contact ContactChunk::at(int i) const {
  return {first[i],
          second[i],
          s[i],
          t[i],
          {normal_x[i], normal_y[i], normal_z[i]},
          distance[i],
          image[i],
          first_material[i],
          second_material[i]};
}

}  // namespace fiberfate
