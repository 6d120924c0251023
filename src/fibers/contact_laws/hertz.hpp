// The elastic normal force of crossed cylinders.
#pragma once

#include <cmath>

#include "base/law_text.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"

namespace fiberfate {

/// Crossed cylinders of radius a whose axes, at the angle alpha, are nearer than 2a by the overlap delta:
///   F_N = (4/3) E* sqrt(a) delta^(3/2) / sin(alpha)^(3/4),   1/E* = (1 − nu²)/E_1 + (1 − nu²)/E_2
/// exact at right angles; elsewhere the power of the sine stands for the elliptic integrals of Hertz'
/// solution, within 5 % from 90 down to 5 degrees.
///
/// Towards parallel rods the patch grows into a line whose length the fibers set, which a force at one point
/// cannot tell: below 5.7 degrees sin alpha counts as 0.1. That keeps the force bounded and steady through
/// parallelism, but the force between parallel fibers depends on the number of their rods.
///
/// A wall is met as if the fiber crossed its own mirror image at right angles: sqrt(2) times Hertz' force of
/// a round end on a rigid plane. Radii that differ enter by their mean. Neglects adhesion and the length of
/// rods; valid for delta up to about a/10. Source: Johnson, Contact Mechanics (1985), (4.30) and section 4.2.
template <class Math>
struct HertzContact {
  using Number = typename Math::Number;

  static constexpr LawText text = {"hertz",
                                   "elastic cylinders that cross: the overlap to the power 3/2",
                                   "Johnson 1985, Contact Mechanics, section 4.2",
                                   {"poisson_ratio"}};
  /// Rods nearer to parallel than this sine push each other as if they were not.
  static constexpr double least_sine = 0.1;
  /// Pairs are held from this share of the radius before they touch, and the stiffness is that of as much
  /// more overlap: a step of the default tolerance moves nodes by a fourth of it.
  static constexpr double guard_share = 0.02;
  /// Packing takes the chord of the law up to this overlap, in diameters: what it tolerates.
  static constexpr double resting_overlap = 0.01;

  Number factor;  ///< (4/3) E* sqrt(a), N/m^(3/2)
  Number touch;   ///< 2a, m
  Number guard;   ///< m

  [[nodiscard]] static HertzContact make(const ContactParameters& contact, const ContactPair& pair) {
    const double radius = pair.mean_radius();
    const double nu = contact.poisson_ratio;
    const double modulus =
        1 / ((1 - nu * nu) * (1 / pair.first.youngs_modulus + 1 / pair.second.youngs_modulus));
    return {4.0 / 3 * modulus * std::sqrt(radius), 2 * radius, guard_share * radius};
  }

  [[gnu::always_inline]] Number factor_at(const Number& sine) const {
    const Number bounded = Math::larger(sine, Math::number(least_sine));
    return factor / Math::square_root(bounded * Math::square_root(bounded));
  }

  /// Returns F_N in N.
  [[gnu::always_inline]] Number operator()(const ContactGap<Number>& gap) const {
    const Number overlap = Math::larger(touch - gap.distance, Math::number(0));
    return factor_at(gap.sine) * overlap * Math::square_root(overlap);
  }

  /// Returns an upper bound of −dF_N/dd in N/m at and around the gap.
  [[gnu::always_inline]] Number stiffness(const ContactGap<Number>& gap, const Number&) const {
    const Number overlap = Math::larger(touch + guard - gap.distance, Math::number(0));
    return 1.5 * factor_at(gap.sine) * Math::square_root(overlap);
  }

  /// Returns the distance from which on there is no force, m.
  [[nodiscard]] double reach() const { return touch; }
  /// Returns the distance from which on the stiffness is 0, m.
  [[nodiscard]] double hold() const { return touch + guard; }

  [[nodiscard]] static RestingContact resting(const ContactParameters& contact, const ContactPair& pair) {
    const HertzContact law = make(contact, pair);
    const double overlap = resting_overlap * law.touch;
    return {2 - overlap / law.touch, overlap, law({law.touch - overlap, 1}), 0};
  }
};

}  // namespace fiberfate
