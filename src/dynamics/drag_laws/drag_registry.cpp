// The registry of laws of drag.
#include "dynamics/drag_laws/drag_registry.hpp"

#include "base/law_choice.hpp"
#include "dynamics/drag_laws/beads.hpp"
#include "dynamics/drag_laws/ellipsoid.hpp"
#include "dynamics/drag_laws/slender_body.hpp"

namespace fiberfate {
namespace {

template <class Law>
DragRow row() {
  return {Law::text, [](double viscosity, const RodShape& rod) { return Law{viscosity}(rod); }};
}

}  // namespace

const std::vector<DragRow>& drag_laws() {
  static const std::vector<DragRow> all = {
      row<BeadDrag>(),
      row<IntegerBeadDrag>(),
      row<EllipsoidDrag>(),
      row<SlenderBodyDrag>(),
  };
  return all;
}

const DragRow& drag_law_named(std::string_view name) {
  return law_named(drag_laws(), name, "law of drag");
}

}  // namespace fiberfate
