// A case of the study measurement: lists of measured fibers, and how they stand for the whole.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "keys/case_checker.hpp"
#include "keys/text_keys.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Bins of a histogram at most.
inline constexpr int most_histogram_bins = 10000;

/// [lengths].
struct MeasuredLengthChoices {
  std::string file;                       ///< CSV; empty: no lengths were measured
  std::string column;                     ///< empty: the only one
  std::string number_column;              ///< fibers that a row stands for; empty: one
  std::string unit;                       ///< of the column; empty: in its heading
  std::optional<double> sample_diameter;  ///< of the down-sampled region, m; not given: none
  std::int64_t bins = 30;
  std::optional<double> bin_width;  ///< m, instead of a number of bins
};

/// How the file tells directions.
enum class DirectionForm { angles, vectors };
/// The unit of angles.
enum class AngleUnit { degrees, radians };

/// [orientation].
struct MeasuredDirectionChoices {
  std::string file;  ///< CSV; empty: no directions were measured
  DirectionForm form = DirectionForm::angles;
  Texts columns;  ///< empty: theta, phi or p1, p2, p3
  AngleUnit angle_unit = AngleUnit::degrees;
  std::string weight_column;           ///< empty: all fibers count alike
  std::optional<Vec3> cut_normal;      ///< fibers were found on a plane cut
  std::optional<double> aspect_ratio;  ///< of the fibers, with cut_normal
};

/// [statistics].
struct StatisticsChoices {
  double level = 0.95;            ///< confidence of the intervals
  std::int64_t resamples = 2000;  ///< of the bootstrap
  std::int64_t seed = 1;
};

struct MeasurementCase {
  MeasuredLengthChoices lengths;
  MeasuredDirectionChoices orientation;
  StatisticsChoices statistics;
};

void describe_measurement(KeyTable& table, MeasurementCase& values);
void validate_measurement(const MeasurementCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_measurement(const MeasurementCase& values);

}  // namespace fiberfate
