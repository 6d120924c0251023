// The laws of bending at a hinge.
#pragma once

#include "dynamics/hinge_laws/elastic.hpp"

namespace fiberfate {

/// Lists laws, each a template over its arithmetic (base/law_math.hpp).
template <template <class> class... Laws>
struct HingeLawList {};

/// To add a law: its file, and its name here (docs/develop/adding_a_hinge_law.md).
using HingeLaws = HingeLawList<  //
    ElasticHinge>;

}  // namespace fiberfate
