// Decides what drives a step, how long it is, and when to stop.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/flow_solver.hpp"
#include "molding/gate_control.hpp"
#include "molding/shell_mesh.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// What acts on a filling from outside: the process that is set, and the gates of the mold.
struct Machine {
  const FillingParams& params;
  const ShellMesh& mesh;
  const GateControl& gates;
};

/// Whether the volume of the cavity has come in: what some nodes have too much has yet to find the last free
/// places.
[[nodiscard]] bool settling(const ShellMesh& mesh, const FillingState& state);

/// What the machine wants: the profile's rate, below the pressure that it may have.
[[nodiscard]] Drive drive_of(const FillingParams& params, const ShellMesh& mesh, const FillingState& state);

/// Notes pressure, rate and changes of control after a solution of the flow.
void note_control(const FillingParams& params, const FlowField& field, double filled_fraction,
                  FillingState& state);

/// Fills the control volumes of open gates that are the sprue itself, before anything else flows: as long as
/// melt runs freely out of one of them the sprue has no pressure, and all other melt rests. Writes such a
/// step and returns true, or returns false where there is nothing to fill.
[[nodiscard]] bool prime_at_sprue(const Machine& machine, FillingState& state, StepFlow& step,
                                  FlowField& field);

/// Lets the melt stand while all gates are closed, until one opens or for as long as a step is meant to take:
/// writes such a step. Heat goes on into the mold.
void stand_still(const Machine& machine, FillingState& state, StepFlow& step, FlowField& field);

/// How long the step is: the aimed volume, at most the control volumes at the front, and not past the
/// next event.
[[nodiscard]] double step_duration(const Machine& machine, const FillingState& state, const FlowField& field);

/// Whether and why the filling is at its end.
[[nodiscard]] FillingEnd reason_to_stop(const FillingParams& params, const ShellMesh& mesh,
                                        const FillingState& state, const FlowField& field);

}  // namespace fiberfate
