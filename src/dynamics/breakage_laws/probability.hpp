// Breakage by chance at every check.
#pragma once

#include "base/law_text.hpp"
#include "base/random.hpp"
#include "dynamics/breakage_laws/breakage_parameters.hpp"
#include "dynamics/breakage_laws/checked_hinge.hpp"
#include "dynamics/breakage_laws/scattered_radius.hpp"

namespace fiberfate {

/// Breaks with the probability P(R) (scattered_radius.hpp) at every check: a draw keyed by seed, hinge and
/// check. Source: thesis section 3.3.3.
struct BreakingProbability {
  static constexpr LawText text = {"probability",
                                   "at every check with a probability that rises from maximum_radius to "
                                   "minimum_radius; the result depends "
                                   "on check_interval, as that of strength does not",
                                   "thesis section 3.3.3",
                                   {"minimum_radius", "maximum_radius", "exponent", "check_interval"}};
  const BreakageParameters& breakage;

  [[nodiscard]] static BreakingProbability make(const BreakageParameters& breakage) { return {breakage}; }
  [[nodiscard]] bool operator()(const CheckedHinge& hinge) const {
    if (hinge.radius >= breakage.maximum_radius) return false;
    const RandomCounter counter{hinge.name.birth_id, hinge.name.birth_node,
                                static_cast<std::uint32_t>(hinge.check)};
    return uniform(hinge.seed, RandomStream::breakage, counter) < break_probability(breakage, hinge.radius);
  }
  [[nodiscard]] double certain_radius() const { return breakage.minimum_radius; }
  [[nodiscard]] double onset_radius() const { return breakage.maximum_radius; }
};

}  // namespace fiberfate
