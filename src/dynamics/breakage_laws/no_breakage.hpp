// Fibers that do not break.
#pragma once

#include "base/law_text.hpp"
#include "dynamics/breakage_laws/breakage_parameters.hpp"
#include "dynamics/breakage_laws/checked_hinge.hpp"

namespace fiberfate {

struct NoBreakage {
  static constexpr LawText text = {"none", "fibers do not break", ""};

  [[nodiscard]] static NoBreakage make(const BreakageParameters& /*unused*/) { return {}; }
  [[nodiscard]] bool operator()(const CheckedHinge& /*unused*/) const { return false; }
  [[nodiscard]] double certain_radius() const { return 0; }
  [[nodiscard]] double onset_radius() const { return 0; }
};

}  // namespace fiberfate
