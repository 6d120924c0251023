// Finds the contacts of rods at the present positions.
#pragma once

#include <span>
#include <vector>

#include "dynamics/parameters.hpp"
#include "fibers/neighbour_list.hpp"

namespace fiberfate {

/// Holds one contact of two rods.
struct Contact {
  Index first = 0;
  Index second = 0;
  double s = 0;                           ///< place on the first rod, in [0, 1]
  double t = 0;                           ///< place on the second rod, in [0, 1]
  Vec3 normal = Vec3::UnitX();            ///< from the second rod to the first
  double distance = 0;                    ///< of the axes, m
  std::array<std::int8_t, 3> image = {};  ///< of the second rod
  std::uint16_t first_material = 0;
  std::uint16_t second_material = 0;
};

/// Says which contacts are wanted.
struct ContactDemand {
  double range = 0;  ///< distance of axes below which a force may act, m
  double strain_share =
      0;  ///< what strain adds to the approach of a pair in the coming step, a rod's share, m
  std::span<const double> ahead;  ///< how far each rod may travel in the coming step relative to the fluid, m
};

/// Finds all contacts that can carry a force in the coming step: pairs whose distance is below `range` plus
/// what both fibers may travel. A contact at a hinge, which both its rods see, is kept once. Two ends that a
/// break has just made are exempt until they have separated.
class ContactSearch {
 public:
  void find(const FiberState& state, NeighbourList& neighbours, const ContactDemand& demand);
  /// Contacts in the order of the neighbour list.
  [[nodiscard]] std::span<const Contact> contacts() const { return contacts_; }

 private:
  std::vector<std::vector<Contact>> by_chunk_;
  std::vector<Contact> contacts_;
};

}  // namespace fiberfate
