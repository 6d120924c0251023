// The registry of laws of breakage.
#include "dynamics/breakage_laws/breakage_registry.hpp"

#include "base/law_choice.hpp"
#include "dynamics/breakage_laws/fixed_radius.hpp"
#include "dynamics/breakage_laws/no_breakage.hpp"
#include "dynamics/breakage_laws/probability.hpp"
#include "dynamics/breakage_laws/strength.hpp"

namespace fiberfate {
namespace {

template <class Law>
BreakageRow row() {
  return {Law::text,
          [](const BreakageParameters& breakage, const CheckedHinge& hinge) {
            return Law::make(breakage)(hinge);
          },
          [](const BreakageParameters& breakage) { return Law::make(breakage).certain_radius(); },
          [](const BreakageParameters& breakage) { return Law::make(breakage).onset_radius(); }};
}

}  // namespace

const std::vector<BreakageRow>& breakage_laws() {
  static const std::vector<BreakageRow> all = {
      row<NoBreakage>(),
      row<FixedRadius>(),
      row<BreakingProbability>(),
      row<HingeStrength>(),
  };
  return all;
}

const BreakageRow& breakage_law_named(std::string_view name) {
  return law_named(breakage_laws(), name, "law of breakage");
}

}  // namespace fiberfate
