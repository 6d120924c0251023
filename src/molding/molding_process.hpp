// The settings of the injection molding machine.
#pragma once

#include <limits>
#include <vector>

namespace fiberfate {

/// What a profile's first column counts.
enum class ProfileAgainst { time, filled_fraction };
/// What happens between two rows of a profile.
enum class ProfileForm { steps, ramps };

/// One row: from `at` (s, or filled fraction) on.
struct ProfileRow {
  double at = 0;
  double rate = 0;  ///< m³/s
};

/// The flow rate that the machine aims at, against time or filled fraction.
struct FlowProfile {
  std::vector<ProfileRow> rows = {};
  ProfileAgainst against = ProfileAgainst::time;
  ProfileForm form = ProfileForm::steps;

  [[nodiscard]] static FlowProfile constant(double rate) { return {{{0, rate}}}; }
  /// The rate at a time and filled fraction, m³/s; the last row holds for ever.
  [[nodiscard]] double at(double time, double filled_fraction) const;
  /// Where the profile next jumps or bends after `position` (in units of `at`); infinity when never.
  [[nodiscard]] double next_row(double position) const;
};

/// Turns ram speeds (m/s, in the column `rate`) into flow rates: speed times the area of the barrel.
[[nodiscard]] FlowProfile flow_of_ram(FlowProfile speeds, double barrel_diameter);

/// Pressure above which nothing drives flow, Pa: machines end at 0.2 to 0.5 GPa, and viscosity laws are
/// fitted below that.
inline constexpr double greatest_pressure = 1e9;

/// The machine's settings.
struct MoldingProcess {
  FlowProfile flow = {};
  double switchover_fraction = 1;  ///< filled fraction from which on pressure is controlled instead of flow
  /// Pressure at the sprue after switchover, Pa; infinity keeps what it was at switchover.
  double switchover_pressure = std::numeric_limits<double>::infinity();
  /// Of the machine, at the sprue, Pa; `greatest_pressure` holds beside it.
  double pressure_limit = std::numeric_limits<double>::infinity();
  double inlet_temperature = 500;  ///< K
  double mold_temperature = 320;   ///< K
  /// Heat transfer from melt to mold, W/(m² K); infinity: the melt at the wall has the mold's temperature.
  double wall_transfer = std::numeric_limits<double>::infinity();
  double longest_time = std::numeric_limits<double>::infinity();  ///< s; filling stops then at the latest
};

}  // namespace fiberfate
