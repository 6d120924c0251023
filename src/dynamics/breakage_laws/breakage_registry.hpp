// The registry of laws of breakage.
#pragma once

#include <string_view>
#include <vector>

#include "base/law_text.hpp"
#include "dynamics/breakage_laws/breakage_parameters.hpp"
#include "dynamics/breakage_laws/checked_hinge.hpp"

namespace fiberfate {

/// Describes one law.
struct BreakageRow {
  LawText text;
  /// Whether a hinge breaks at a check.
  bool (*breaks)(const BreakageParameters& breakage, const CheckedHinge& hinge);
  /// Returns the radius of curvature below which every hinge breaks, m.
  double (*certain_radius)(const BreakageParameters& breakage);
  /// Returns the radius from which on none breaks, m; 0 where none ever does.
  double (*onset_radius)(const BreakageParameters& breakage);
};

/// Lists the laws. To add one: its file, and its row in breakage_registry.cpp
/// (docs/develop/adding_a_breakage_law.md).
[[nodiscard]] const std::vector<BreakageRow>& breakage_laws();
/// Finds a law; raises InputError for a name that no law has.
[[nodiscard]] const BreakageRow& breakage_law_named(std::string_view name);

}  // namespace fiberfate
