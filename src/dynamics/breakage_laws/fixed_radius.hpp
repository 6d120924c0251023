// Breakage at one radius of curvature.
#pragma once

#include "base/law_text.hpp"
#include "dynamics/breakage_laws/breakage_parameters.hpp"
#include "dynamics/breakage_laws/checked_hinge.hpp"

namespace fiberfate {

/// Breaks where R < R_crit. Source: thesis section 3.3.3.
struct FixedRadius {
  static constexpr LawText text = {"fixed",
                                   "where the radius of curvature is below critical_radius",
                                   "thesis section 3.3.3",
                                   {"critical_radius", "check_interval"}};
  double critical_radius;  ///< R_crit, m

  [[nodiscard]] static FixedRadius make(const BreakageParameters& breakage) {
    return {breakage.critical_radius};
  }
  [[nodiscard]] bool operator()(const CheckedHinge& hinge) const { return hinge.radius < critical_radius; }
  /// Returns the radius below which every hinge breaks, m.
  [[nodiscard]] double certain_radius() const { return critical_radius; }
  /// Returns the radius from which on none breaks, m.
  [[nodiscard]] double onset_radius() const { return critical_radius; }
};

}  // namespace fiberfate
