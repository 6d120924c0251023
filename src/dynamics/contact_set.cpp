// Adds and reads contacts.
#include "dynamics/contact_set.hpp"

#include <algorithm>

namespace fiberfate {
namespace {

constexpr int pack_size = 8;

}  // namespace

void ContactChunk::reserve(int contacts) {
  const std::size_t room = static_cast<std::size_t>(contacts) + pack_size - 1;
  if (first.size() >= room) return;
  for (auto* array : {&first, &second}) array->resize(2 * room, 0);
  for (auto* array : {&first_material, &second_material}) array->resize(2 * room, 0);
  for (auto* array : {&s, &t, &normal_x, &normal_y, &normal_z, &distance}) array->resize(2 * room, 0.0);
  image.resize(2 * room, 0);
}

void ContactChunk::add(const Contact& contact) {
  const auto i = static_cast<std::size_t>(count++);
  first[i] = contact.first;
  second[i] = contact.second;
  image[i] = contact.image;
  first_material[i] = contact.first_material;
  second_material[i] = contact.second_material;
  s[i] = contact.s;
  t[i] = contact.t;
  normal_x[i] = contact.normal.x();
  normal_y[i] = contact.normal.y();
  normal_z[i] = contact.normal.z();
  distance[i] = contact.distance;
}

Contact ContactChunk::at(int number) const {
  const auto i = static_cast<std::size_t>(number);
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
