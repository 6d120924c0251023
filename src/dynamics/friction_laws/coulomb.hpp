// Coulomb's friction.
#pragma once

#include "base/law_text.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"

namespace fiberfate {

/// Coulomb friction, regularised so that it vanishes at rest: force = −resistance(F_N, |v_t|) v_t with
///   resistance = mu F_N / sqrt(v_t² + v_0²)
/// Source: thesis (3.15), with the tangential relative velocity.
template <class Math>
struct CoulombFriction {
  using Number = typename Math::Number;

  static constexpr LawText text = {"coulomb",
                                   "in proportion to the normal force, whatever the speed of sliding",
                                   "thesis equation 3.15",
                                   {"slip_velocity"}};

  Number coefficient;            ///< mu
  Number squared_slip_velocity;  ///< v_0², m²/s²

  /// Takes mu apart, because rods and walls have their own.
  [[nodiscard]] static CoulombFriction make(const ContactParameters& contact, double coefficient) {
    return {coefficient, contact.slip_velocity * contact.slip_velocity};
  }

  /// Returns the resistance in N s/m for a normal force in N and the square of the tangential velocity.
  [[gnu::always_inline]] Number operator()(const Number& normal_force, const Number& squared_velocity) const {
    return coefficient * normal_force / Math::square_root(squared_velocity + squared_slip_velocity);
  }
};

}  // namespace fiberfate
