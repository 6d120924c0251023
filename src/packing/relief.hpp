// Takes fibers out that press on others harder than their contact law can bear, and puts them back where
// there is room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "packing/minimiser.hpp"
#include "packing/vacancies.hpp"

namespace fiberfate {

/// Moves fibers with overloaded contacts to other places.
///
/// A fiber that is put back lies straight, in the direction in which its ends lay apart, where the least of
/// it lies in others among several thousand random places.
class Relief {
 public:
  /// What fibers that are put back are for a while, in multiples of what they are.
  struct Alteration {
    double stiffness = 1, swelling = 1, firmness = 1;
  };
  Relief(Chains& chains, Minimiser& minimiser, std::uint64_t seed);
  /// Chooses fibers without which no contact overlaps by more than `overlap` sums of radii, as last measured;
  /// returns their number. Of the two fibers of a contact rather the one that has more of them, and that was
  /// moved less often.
  std::size_t find(double overlap);
  /// Puts the fibers that were found elsewhere.
  void move();
  /// Alters the fibers that were found; what they were altered to before is forgotten.
  void alter(const Alteration& alteration);

 private:
  struct Contact {
    FiberIndex fiber, other;
  };
  [[nodiscard]] std::vector<Contact> overloaded(double overlap) const;
  void put_straight(FiberIndex fiber, const StraightAxis& axis);
  [[nodiscard]] StraightAxis roomiest_place(FiberIndex fiber, const Vacancies& vacancies) const;

  Chains& chains_;
  Minimiser& minimiser_;
  std::uint64_t seed_;
  std::uint32_t round_ = 0;
  std::vector<FiberIndex> found_;
  IndexedVector<FiberIndex, double> stiffness_;  ///< the fibers' own
  IndexedVector<FiberIndex, int> moves_;
};

}  // namespace fiberfate
