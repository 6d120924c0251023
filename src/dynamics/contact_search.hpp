// Finds the contacts of rods at the present positions.
#pragma once

#include <vector>

#include "dynamics/contact_set.hpp"
#include "fibers/neighbour_list.hpp"

namespace fiberfate {

/// Finds all contacts that can carry a force in the coming step: pairs whose distance is below `range` plus
/// what both rods may travel. A contact at a hinge, which both its rods see, is kept once. Two ends that a
/// break has just made are exempt until they have separated.
class ContactSearch {
 public:
  /// Evaluates the awake pairs of a list that has looked ahead for the coming step; `range` is the distance
  /// of axes below which a force may act, m.
  void find(const FiberState& state, NeighbourList& neighbours, double range);
  [[nodiscard]] const ContactSet& contacts() const { return contacts_; }

 private:
  ContactSet contacts_;
  PerThread<std::vector<Index>> awake_;  // numbers of pairs
};

}  // namespace fiberfate
