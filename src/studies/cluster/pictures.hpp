// Pictures of a packing: how densely fibers lie, and a cut through them.
#pragma once

#include <vector>

#include "fibers/state.hpp"
#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

/// Lists the volume fractions of columns through the cell, seen along each of its directions.
[[nodiscard]] CsvTable density_table(const FiberState& state);

/// Draws the table's maps; nothing for folders of older versions, which have none.
[[nodiscard]] std::vector<HeatmapSection> density_sections(const ResultFolder& folder);

/// Cuts through the middle of the cell, across the direction in which most fibers lie: every rod that meets
/// the cut is the ellipse of its cross-section, as under a microscope.
[[nodiscard]] LinesSection cut_section(const FiberState& state);

}  // namespace fiberfate
