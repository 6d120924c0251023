// The rotary diffusions and the retardations of orientation laws.
#pragma once

#include "base/law_list.hpp"
#include "continuum/orientation_laws/ard.hpp"
#include "continuum/orientation_laws/folgar_tucker.hpp"
#include "continuum/orientation_laws/iard.hpp"
#include "continuum/orientation_laws/jeffery.hpp"
#include "continuum/orientation_laws/mrd.hpp"
#include "continuum/orientation_laws/no_retardation.hpp"
#include "continuum/orientation_laws/pard.hpp"
#include "continuum/orientation_laws/rpr.hpp"
#include "continuum/orientation_laws/rsc.hpp"
#include "continuum/orientation_laws/srf.hpp"
#include "continuum/orientation_laws/wpt.hpp"

namespace fiberfate {

/// To add a law: its file, and its name here (docs/develop/adding_an_orientation_law.md). The first of a list
/// is the one of a model that names none.
using RotaryDiffusions = LawList<  //
    NoDiffusion,                   //
    FolgarTuckerDiffusion,         //
    ArdDiffusion,                  //
    IardDiffusion,                 //
    PardDiffusion,                 //
    MrdDiffusion,                  //
    WptDiffusion>;

using Retardations = LawList<  //
    NoRetardation,             //
    RscRetardation,            //
    RprRetardation,            //
    SrfRetardation>;

}  // namespace fiberfate
