// Tests the registry of normal forces: every law keeps what the loops and packing rely on.
#include "fibers/contact_laws/contact_registry.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr ContactBody glass{9.5e-6, 73e9};

TEST(ContactRegistry, NamesEveryLawInWords) {
  for (const ContactRow& row : contact_laws()) {
    EXPECT_EQ(&contact_law_named(row.text.name), &row);
    EXPECT_STRNE(row.text.meaning, "");
  }
}

TEST(ContactRegistry, RefusesAnUnknownLawWithTheNearest) {
  try {
    (void)contact_law_named("herz");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "there is no law of contact 'herz': did you mean 'hertz'?");
  }
}

// The loops: no force beyond the reach, no stiffness beyond the hold, which is farther; a force that falls
// with the distance, never faster than the stiffness there.
TEST(ContactRegistry, HoldsLawsThatTheImplicitStepCanBear) {
  for (const ContactRow& row : contact_laws()) {
    ContactParameters contact;
    contact.law = row.text.name;
    const NormalForce force(contact, {glass, glass});
    EXPECT_GE(force.hold(), force.reach()) << row.text.name;
    EXPECT_EQ(force(force.reach() * (1 + 1e-9)), 0) << row.text.name;
    EXPECT_EQ(force.stiffness({force.hold() * (1 + 1e-9), 1}, 0), 0) << row.text.name;
    const double spacing = 1e-10;
    for (double d = force.reach() - 2e-6; d < force.hold(); d += spacing) {
      const double fall = force(d) - force(d + spacing);
      ASSERT_GE(fall, 0) << row.text.name << ' ' << d;
      ASSERT_LE(fall, force.stiffness({d, 1}, force(d)) * spacing * (1 + 1e-6)) << row.text.name << ' ' << d;
    }
  }
}

// Packing: where the ramp ends the force is that of the law.
TEST(ContactRegistry, TellsPackingTheForceOfTheLaw) {
  for (const ContactRow& row : contact_laws()) {
    ContactParameters contact;
    contact.law = row.text.name;
    const RestingContact rest = row.resting(contact, {glass, glass});
    const NormalForce force(contact, {glass, glass});
    const double distance = rest.cutoff * glass.radius - rest.ramp / 2;
    EXPECT_NEAR(rest.force, force(distance), 1e-9 * rest.force) << row.text.name;
  }
}

}  // namespace
}  // namespace fiberfate
