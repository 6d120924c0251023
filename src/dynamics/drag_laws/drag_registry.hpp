// The registry of laws of drag.
#pragma once

#include <string_view>
#include <vector>

#include "base/law_text.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"

namespace fiberfate {

/// Describes one law. A law is in proportion to the viscosity (Pa s).
struct DragRow {
  LawText text;
  RodDrag (*drag)(double viscosity, const RodShape& rod);
};

/// Lists the laws. To add one: its file, and its row in drag_registry.cpp
/// (docs/develop/adding_a_drag_law.md).
[[nodiscard]] const std::vector<DragRow>& drag_laws();
/// Finds a law; raises InputError for a name that no law has.
[[nodiscard]] const DragRow& drag_law_named(std::string_view name);

}  // namespace fiberfate
