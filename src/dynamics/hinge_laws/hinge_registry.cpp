// The registry of laws of bending at a hinge.
#include "dynamics/hinge_laws/hinge_registry.hpp"

#include "base/law_choice.hpp"
#include "dynamics/hinge_laws/hinge_laws.hpp"

namespace fiberfate {
namespace {

template <class Law>
HingeRow row_of(int number) {
  return {
      Law::text, number, [] { return numbers_of(Law::make()); },
      [](const LawNumbers& law, double squared_half_sine) { return law_from<Law>(law)(squared_half_sine); }};
}

template <template <class> class... Laws>
std::vector<HingeRow> rows_of(HingeLawList<Laws...>) {
  int number = 0;
  return {row_of<Laws<PlainMath>>(number++)...};
}

}  // namespace

const std::vector<HingeRow>& hinge_laws() {
  static const std::vector<HingeRow> all = rows_of(HingeLaws{});
  return all;
}

const HingeRow& hinge_law_named(std::string_view name) {
  return law_named(hinge_laws(), name, "law of bending");
}

}  // namespace fiberfate
