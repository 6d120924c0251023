// A case of the study rheometer: cells of fibers in flows of several rates, types, concentrations and
// lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "keys/text_keys.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {

/// [sweep]: what differs between the points; every list stands for a key of the cell.
struct RheometerSweep {
  Texts flows;                           ///< of flow.type
  std::vector<double> volume_fractions;  ///< of fibers.volume_fraction
  std::vector<double> lengths;           ///< of fibers.length, m
  std::vector<double> rates;             ///< of flow.rate, 1/s
  std::int64_t replicas = 3;
  std::optional<double> strain;  ///< after which a point ends; not given: run.duration
};

struct RheometerCase {
  ShearCellCase cell;  ///< what all points share
  RheometerSweep sweep;
};

void describe_rheometer(KeyTable& table, RheometerCase& values);
void validate_rheometer(const RheometerCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_rheometer(const RheometerCase& values);

/// One point of the grid.
struct RheometerPoint {
  /// Of the value in its list; nothing where the case has no such list.
  std::optional<std::size_t> flow, volume_fraction, length, rate;
  std::size_t fibers =
      0;  ///< number of its kind of fibers: points of one have one volume fraction and length
};
/// Lists the points: rates change first, then lengths, volume fractions, flows. One where there is no list.
[[nodiscard]] std::vector<RheometerPoint> points(const RheometerSweep& sweep);
/// Counts the kinds of fibers of the points.
[[nodiscard]] std::size_t kinds_of_fibers(const RheometerSweep& sweep);
/// The cell of a point and replica (from 0), whose seed is run.seed + replica.
[[nodiscard]] ShearCellCase cell_at(const RheometerCase& values, const RheometerPoint& point,
                                    std::int64_t replica);
/// The rate of a constant flow, 1/s: that of its keys; of type "gradient" sqrt(2 D:D).
[[nodiscard]] double constant_rate(const ShearCellCase& cell);

}  // namespace fiberfate
