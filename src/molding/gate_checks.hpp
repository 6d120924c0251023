// Checks gates, their events and the sensors that these wait for.
#pragma once

#include <vector>

#include "base/error.hpp"
#include "molding/filling_params.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Appends what is wrong with gates and sensors: places off the part, sizes and values out of range, events
/// that contradict each other, a cavity that no gate can begin to fill.
void check_gates(const FillingParams& params, const ShellMesh& mesh, std::vector<InputProblem>& problems);

}  // namespace fiberfate
