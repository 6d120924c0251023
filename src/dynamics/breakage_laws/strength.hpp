// Breakage of hinges that have each a strength of their own.
#pragma once

#include "base/law_text.hpp"
#include "base/random.hpp"
#include "dynamics/breakage_laws/breakage_parameters.hpp"
#include "dynamics/breakage_laws/checked_hinge.hpp"
#include "dynamics/breakage_laws/scattered_radius.hpp"

namespace fiberfate {

/// Breaks where R is below the hinge's own critical radius, which is distributed like that of
/// BreakingProbability: a draw keyed by seed and hinge alone. Source: this program's, after thesis section
/// 3.3.3.
struct HingeStrength {
  static constexpr LawText text = {"strength",
                                   "each hinge at a radius of its own, drawn once from the same distribution",
                                   "thesis section 3.3.3",
                                   {"minimum_radius", "maximum_radius", "exponent", "check_interval"}};
  const BreakageParameters& breakage;

  [[nodiscard]] static HingeStrength make(const BreakageParameters& breakage) { return {breakage}; }
  [[nodiscard]] bool operator()(const CheckedHinge& hinge) const {
    if (hinge.radius >= breakage.maximum_radius) return false;
    const RandomCounter counter{hinge.name.birth_id, hinge.name.birth_node, 0};
    return hinge.radius <
           critical_radius(breakage, uniform(hinge.seed, RandomStream::hinge_strength, counter));
  }
  [[nodiscard]] double certain_radius() const { return breakage.minimum_radius; }
  [[nodiscard]] double onset_radius() const { return breakage.maximum_radius; }
};

}  // namespace fiberfate
