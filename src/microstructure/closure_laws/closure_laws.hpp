// The closures of A4.
#pragma once

#include "base/law_list.hpp"
#include "microstructure/closure_laws/bingham.hpp"
#include "microstructure/closure_laws/exact.hpp"
#include "microstructure/closure_laws/hybrid.hpp"
#include "microstructure/closure_laws/ibof.hpp"
#include "microstructure/closure_laws/linear.hpp"
#include "microstructure/closure_laws/ore.hpp"
#include "microstructure/closure_laws/orf.hpp"
#include "microstructure/closure_laws/orl.hpp"
#include "microstructure/closure_laws/orp.hpp"
#include "microstructure/closure_laws/ors.hpp"
#include "microstructure/closure_laws/orw.hpp"
#include "microstructure/closure_laws/orw3.hpp"
#include "microstructure/closure_laws/quadratic.hpp"

namespace fiberfate {

/// To add a closure: its file, and its name here (docs/develop/adding_an_orientation_law.md). The first is
/// the one of a model that names none.
using ClosureLaws = LawList<  //
    IbofClosure,              //
    LinearClosure,            //
    QuadraticClosure,         //
    HybridClosure,            //
    OrfClosure,               //
    OrwClosure,               //
    Orw3Closure,              //
    OreClosure,               //
    OrsClosure,               //
    OrlClosure,               //
    OrpClosure,               //
    BinghamClosure,           //
    ExactClosure>;

}  // namespace fiberfate
