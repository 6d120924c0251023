// The registry of laws of friction.
#include "dynamics/friction_laws/friction_registry.hpp"

#include "base/law_choice.hpp"
#include "dynamics/friction_laws/friction_laws.hpp"

namespace fiberfate {
namespace {

template <class Law>
FrictionRow row_of(int number) {
  return {Law::text, number,
          [](const ContactParameters& contact, double coefficient) {
            return numbers_of(Law::make(contact, coefficient));
          },
          [](const LawNumbers& law, double normal_force, double squared_velocity) {
            return law_from<Law>(law)(normal_force, squared_velocity);
          }};
}

template <template <class> class... Laws>
std::vector<FrictionRow> rows_of(FrictionLawList<Laws...>) {
  int number = 0;
  return {row_of<Laws<PlainMath>>(number++)...};
}

}  // namespace

const std::vector<FrictionRow>& friction_laws() {
  static const std::vector<FrictionRow> all = rows_of(FrictionLaws{});
  return all;
}

const FrictionRow& friction_law_named(std::string_view name) {
  return law_named(friction_laws(), name, "law of friction");
}

}  // namespace fiberfate
