// The registry of laws of the normal force.
#include "fibers/contact_laws/contact_registry.hpp"

#include "base/law_choice.hpp"
#include "fibers/contact_laws/contact_laws.hpp"

namespace fiberfate {
namespace {

template <class Law>
ContactRow row_of(int number) {
  return {Law::text,
          number,
          [](const ContactParameters& contact, const ContactPair& pair) {
            return numbers_of(Law::make(contact, pair));
          },
          [](const LawNumbers& law, const ContactGap<double>& gap) { return law_from<Law>(law)(gap); },
          [](const LawNumbers& law, const ContactGap<double>& gap, double force) {
            return law_from<Law>(law).stiffness(gap, force);
          },
          [](const LawNumbers& law) { return law_from<Law>(law).reach(); },
          [](const LawNumbers& law) { return law_from<Law>(law).hold(); },
          Law::resting};
}

template <template <class> class... Laws>
std::vector<ContactRow> rows_of(ContactLawList<Laws...>) {
  int number = 0;
  return {row_of<Laws<PlainMath>>(number++)...};
}

}  // namespace

const std::vector<ContactRow>& contact_laws() {
  static const std::vector<ContactRow> all = rows_of(ContactLaws{});
  return all;
}

const ContactRow& contact_law_named(std::string_view name) {
  return law_named(contact_laws(), name, "law of contact");
}

}  // namespace fiberfate
