// The published normal force: a penalty that grows exponentially with the overlap.
#pragma once

#include <cmath>

#include "base/law_text.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"

namespace fiberfate {

/// With the distance d of the axes and the mean radius a,
///   F_N = A 2a exp(−B (d/a − 2)) for d < d_cut = cutoff a
/// whose jump at d_cut is replaced by a ramp of width `ramp`, centred on d_cut, so that force and step
/// converge:
///   F_N = min(F_0 (1/2 − (d − d_cut)/ramp), A 2a exp(−B (d/a − 2))),   F_0 = A 2a exp(−B (cutoff − 2))
/// for d > d_cut − ramp, continuous as long as B ramp < 0.4 a. The angle between the rods does not matter.
/// Source: thesis (3.14), with d in units of the radius as its program computes it; the ramp is ours.
template <class Math>
struct ExponentialContact {
  using Number = typename Math::Number;

  static constexpr LawText text = {"exponential",
                                   "a penalty that grows exponentially with the overlap",
                                   "thesis equation 3.14",
                                   {"force_constant", "decay", "cutoff", "ramp"}};

  Number strength;   ///< A 2a, N
  Number per_decay;  ///< B/a, 1/m
  Number touch;      ///< 2a, m
  Number cutoff;     ///< d_cut, m
  Number ramp;       ///< m
  Number step;       ///< F_0, N

  [[nodiscard]] static ExponentialContact make(const ContactParameters& contact, const ContactPair& pair) {
    const double radius = pair.mean_radius();
    ExponentialContact law{contact.force_constant * 2 * radius,
                           contact.decay / radius,
                           2 * radius,
                           contact.cutoff * radius,
                           contact.ramp,
                           0};
    law.step = law.exponential(law.cutoff);
    return law;
  }

  [[gnu::always_inline]] Number exponential(const Number& distance) const {
    return strength * Math::exponential(-per_decay * (distance - touch));
  }

  /// Returns F_N in N.
  [[gnu::always_inline]] Number operator()(const ContactGap<Number>& gap) const {
    const Number& d = gap.distance;
    const Number rise = step * (0.5 - (d - cutoff) / ramp);
    const Number penalty = exponential(d);
    // The ramp is below the exponential over its own width, except near its inner end, where they cross.
    const Number lesser = Math::choose(d < cutoff - ramp, penalty, Math::smaller(rise, penalty));
    return Math::larger(Math::choose(d > cutoff - 0.4 * ramp, rise, lesser), Math::number(0));
  }

  /// Returns an upper bound of −dF_N/dd in N/m at and around the gap, at which the force is `force`. Pairs
  /// about to close are held like closed ones, or they would overshoot the ramp within a step.
  [[gnu::always_inline]] Number stiffness(const ContactGap<Number>& gap, const Number& force) const {
    return Math::choose(gap.distance < cutoff + 1.5 * ramp, Math::larger(step / ramp, per_decay * force),
                        Math::number(0));
  }

  /// Returns the distance from which on there is no force, m; 0 where there never is.
  [[nodiscard]] double reach() const { return strength > 0 ? cutoff + 0.5 * ramp : 0; }
  /// Returns the distance from which on the stiffness is 0, m.
  [[nodiscard]] double hold() const { return strength > 0 ? reach() + ramp : 0; }

  [[nodiscard]] static RestingContact resting(const ContactParameters& contact, const ContactPair& pair) {
    const double diameter = 2 * pair.mean_radius();
    return {contact.cutoff, contact.ramp,
            contact.force_constant * diameter * std::exp(-contact.decay * (contact.cutoff - 2)),
            contact.decay};
  }
};

}  // namespace fiberfate
