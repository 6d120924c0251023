// Adds contacts to a chunk one by one, as a test states them.
#pragma once

#include "dynamics/contact_set.hpp"

namespace fiberfate::reference {

inline void append_contact(ContactChunk& chunk, const Contact& contact) {
  chunk.reserve(chunk.count + 1);
  const int i = chunk.count++;
  chunk.first[i] = contact.first;
  chunk.second[i] = contact.second;
  chunk.image[i] = contact.image;
  chunk.first_material[i] = contact.first_material;
  chunk.second_material[i] = contact.second_material;
  chunk.s[i] = contact.s;
  chunk.t[i] = contact.t;
  chunk.normal_x[i] = contact.normal.x();
  chunk.normal_y[i] = contact.normal.y();
  chunk.normal_z[i] = contact.normal.z();
  chunk.distance[i] = contact.distance;
}

}  // namespace fiberfate::reference
