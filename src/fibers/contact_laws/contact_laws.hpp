// The laws of the normal force between fibers.
#pragma once

#include "fibers/contact_laws/exponential.hpp"
#include "fibers/contact_laws/hertz.hpp"

namespace fiberfate {

/// Lists laws, each a template over its arithmetic (base/law_math.hpp).
template <template <class> class... Laws>
struct ContactLawList {};

/// To add a law: its file, and its name here (docs/develop/adding_a_contact_law.md).
using ContactLaws = ContactLawList<  //
    ExponentialContact,              //
    HertzContact>;

}  // namespace fiberfate
