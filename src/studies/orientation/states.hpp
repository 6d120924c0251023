// What summary.json tells of single states of the study orientation: the start, the end, and the steady one.
#pragma once

#include "studies/orientation/case.hpp"

namespace fiberfate {

/// Adds A4 and DA/Dt of the start and of the end, whose A2 is given.
void summarise_ends(const OrientationCase& values, const Mat3& last, RunSummary& summary);

/// Adds the state that the flow at the end leads to, and how fast; or why there is none, which is warned of.
void summarise_steady(const OrientationCase& values, Session& session, RunSummary& summary);

}  // namespace fiberfate
