// Lists of measured fibers, read from the files that instruments and spreadsheets write.
#pragma once

#include <cstddef>
#include <string>

#include "microstructure/length_statistics.hpp"
#include "microstructure/orientation_statistics.hpp"
#include "studies/measurement/case.hpp"

namespace fiberfate {

/// Counts what a list holds beside fibers.
struct LeftOut {
  std::size_t empty_lines = 0;
  std::size_t zero_lengths = 0;

  /// In words: "1 empty line and 2 rows of zero length are left out"; nothing where there is nothing.
  [[nodiscard]] std::string text() const;
};

/// The lengths of a list, m.
struct LengthList {
  MeasuredLengths fibers;
  std::string column;  ///< its heading
  LeftOut left_out;
};

/// The directions of a list with their weights.
struct DirectionList {
  MeasuredDirections fibers;
  LeftOut left_out;
};

/// Reads the lengths as they were measured. Where the case names no column, there must be one only beside
/// the column of numbers, or one whose heading says "length" with a unit. Rows of zero length are left out.
/// Raises InputError with the file's line and column at fault, or with the key of the case.
[[nodiscard]] LengthList read_lengths(const MeasuredLengthChoices& choices);
/// Reads the directions, corrected for a cut where the case tells of one; raises as above.
[[nodiscard]] DirectionList read_directions(const MeasuredDirectionChoices& choices);

}  // namespace fiberfate
