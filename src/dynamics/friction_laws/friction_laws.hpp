// The laws of friction between fibers, and between fibers and walls.
#pragma once

#include "dynamics/friction_laws/coulomb.hpp"

namespace fiberfate {

/// Lists laws, each a template over its arithmetic (base/law_math.hpp).
template <template <class> class... Laws>
struct FrictionLawList {};

/// To add a law: its file, and its name here (docs/develop/adding_a_contact_law.md).
using FrictionLaws = FrictionLawList<  //
    CoulombFriction>;

}  // namespace fiberfate
