// Adds to the picture of a part what its last state holds: orientation as tensors, profiles through the gap,
// axes of stiffness.
#pragma once

#include "io/poly_frame.hpp"
#include "molding/shell_mesh.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

/// Adds the orientation tensors of the last frame, where there are any.
void add_orientation(const PolyFrame& last, ShellSection& section);

/// Adds the layers of layers.vtkhdf, where a run has written it and a page can carry it; raises StorageError.
void add_layers(const ResultFolder& folder, const ShellMesh& mesh, ShellSection& section);

/// Adds the axes of properties.vtkhdf along which triangles are stiffest, where a run has written it; raises
/// StorageError.
void add_stiffness_axes(const ResultFolder& folder, ShellSection& section);

}  // namespace fiberfate
