// The state of a filling: what a checkpoint stores, and all that the future depends on.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Why a filling is at its end.
enum class FillingEnd {
  none,        ///< it is not
  filled,      ///< the cavity is full
  short_shot,  ///< the pressure that there is no longer moves the melt, or no gate is open any more
  frozen,      ///< the melt has frozen off
  time         ///< MoldingProcess::longest_time is over
};
[[nodiscard]] const char* name(FillingEnd reason);

/// What the machine holds at its setting.
enum class ControlMode { flow, pressure_limit, switchover };
[[nodiscard]] const char* name(ControlMode mode);

/// What can happen.
enum class FillingEventKind {
  gate_opened,
  gate_closed,
  pressure_limited,
  flow_resumed,
  switched_over,
  ended
};
[[nodiscard]] const char* name(FillingEventKind kind);

/// Records what happened when; `gate` is its number, or -1.
struct FillingEvent {
  double time = 0;             ///< s
  double filled_fraction = 0;  ///< 1
  FillingEventKind kind = FillingEventKind::gate_opened;
  int gate = -1;
};

/// The state of one gate.
struct GateState {
  int moves = 0;  ///< how often it has opened or closed: odd while it is open
  double arrival_time = std::numeric_limits<double>::quiet_NaN();  ///< of the front, s; NaN before
  double pressure = 0;                                             ///< Pa
  double rate = 0;                                                 ///< into the cavity, m³/s
  double volume = 0;                                               ///< that has come in so far, m³

  [[nodiscard]] bool is_open() const { return moves % 2 == 1; }
};

/// Accounts for heat since the start, J (inlet temperature minus mold temperature counts as heat content).
struct HeatAccount {
  double brought_in = 0;  ///< through gates
  double dissipated = 0;  ///< by viscous flow
  double to_mold = 0;     ///< through the walls
};

/// Marks nodes where the front did more than pass. The last node of a full cavity, an air trap or not, is
/// marked as such only.
enum class NodeMark : std::uint8_t { none, weld_line, air_trap, last_filled };

/// Everything that changes. Arrays by node have n elements; by point n·layers (layers of half the gap,
/// [node][layer], layer 0 at the mid-plane); lengths [node][layer][field].
struct FillingState {
  double time = 0;  ///< s
  std::int64_t steps = 0;
  FillingEnd stop_reason = FillingEnd::none;
  ControlMode control = ControlMode::flow;
  double sprue_pressure = 0;                                       ///< Pa
  double flow_rate = 0;                                            ///< m³/s
  double held_pressure = std::numeric_limits<double>::infinity();  ///< after switchover, Pa
  double injected_volume = 0;  ///< that the sprue has delivered, int of flow_rate dt, m³
  double filled_volume = 0;    ///< m³; equal to `injected_volume` but for round-off and `excess`
  std::vector<GateState> gates;
  std::vector<double> sensor_arrivals;  ///< by sensor, s; NaN before
  std::vector<FillingEvent> events;
  HeatAccount heat;

  std::vector<char> covered;      ///< by node: the pattern of the pressure equation counts with it
  std::vector<double> filled;     ///< by node: share of the control volume that is filled, 0 to 1
  std::vector<double> excess;     ///< by node: volume that has found no room yet, m³
  std::vector<double> fill_time;  ///< by node, s; NaN where melt has not arrived; of half the control volume
  std::vector<double> pressure;   ///< by node, Pa; while all melt settles, that which the machine made last
  std::vector<Vec2> gradient;     ///< by node: of the pressure at the last solution, in its frame, Pa/m
  std::vector<Vec2> inflow;       ///< by node: sum of inflow times direction while it filled, m³
  std::vector<NodeMark> mark;     ///< by node
  std::vector<double> temperature;                 ///< by point, K
  std::vector<double> rate;                        ///< by point: shear rate, 1/s
  std::array<std::vector<double>, 6> orientation;  ///< by point, A2 in the node's frame: 11 22 33 23 31 12
  std::vector<double> lengths;  ///< by point and field, m (or numbers of fibers, for Phelps' bins)

  /// Whether a node counts as full for marks: the last ones lack round-off.
  [[nodiscard]] bool is_full(std::size_t node) const { return filled[node] >= 1 - 1e-9; }
};

}  // namespace fiberfate
