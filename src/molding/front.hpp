// Moves the front: fills control volumes, passes on what overflows, marks weld lines and air traps.
#pragma once

#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/flow_solver.hpp"
#include "molding/shell_mesh.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// The size of the control volumes next to wet ones, m³: a step that fills more is coarse.
[[nodiscard]] double volume_at_front(const ShellMesh& mesh, const FlowField& field);

/// Lets the fluxes of `field` act for step.duration; step.gate_volume says what gates that are not full bring
/// into their own nodes. What overflows goes on to empty neighbours in the same
/// step, in proportion to how their edges conduct; where there are none it is kept as `excess` and becomes a
/// source of the next solution. Writes the volumes of `step` (edges, gates, contents) and updates `filled`,
/// `excess`, `fill_time`, `inflow`. Nothing is lost: contents change by what the edges and gates carry.
void advance_front(const FlowSolver& solver, const FlowField& field, StepFlow& step, FillingState& state);

/// Marks nodes that have become full: weld lines where fronts met (weld_lines.hpp), air traps where a pocket
/// ended that melt had closed in.
void mark_front(const ShellMesh& mesh, const StepFlow& step, FillingState& state);

/// Marks the node that the melt reached last, in a cavity that is full.
void mark_last(FillingState& state);

}  // namespace fiberfate
