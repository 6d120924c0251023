// Builds the section of reports that shows the cell in three dimensions.
#pragma once

#include <string>
#include <vector>

#include "io/csv_table.hpp"
#include "io/vtkhdf_file.hpp"
#include "results/report_document.hpp"

namespace fiberfate {

/// What the files of a run tell about the motion between its frames.
struct CellHistory {
  std::vector<double> times = {};    ///< s, ascending
  std::vector<double> strains = {};  ///< shear strain at these times
  std::vector<FiberBreak> breaks = {};
};

/// Reads strains out of series.csv and breaks out of breaks.csv.
[[nodiscard]] CellHistory read_cell_history(const CsvTable& series, const CsvTable& breaks);

/// What a page has room for.
struct PageRoom {
  double exact_bytes = 8e6;    ///< of nodes as float32 in all frames together; more are put on a grid
  double encoded_bytes = 8e6;  ///< of what is on a grid: 12 MB of HTML
};

/// Shows the cell at as many frames and with as many fibers as a page can carry, and says which in the
/// caption.
[[nodiscard]] FibersSection fibers_section(const VtkhdfReader& frames, const std::string& caption,
                                           const CellHistory& history = {}, const PageRoom& room = {});

}  // namespace fiberfate
