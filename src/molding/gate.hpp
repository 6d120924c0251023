// Describes gates: where melt enters, through which resistance, and when they open and close.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// What opens or closes a gate.
enum class TriggerKind {
  start,            ///< from the beginning
  never,            ///< not at all
  filled_fraction,  ///< when this share of the cavity is filled (value in 0 to 1)
  time,             ///< at this time, s
  arrival           ///< when the front has reached the gate, or a sensor; value is a delay, s
};

/// Stands for the gate itself where a trigger names a sensor.
inline constexpr int own_gate = -1;

/// When a gate opens or closes.
struct Trigger {
  TriggerKind kind = TriggerKind::start;
  double value = 0;
  int sensor = own_gate;  ///< number of the sensor whose arrival counts
};

/// When a gate is open: from one trigger to the next.
struct OpenInterval {
  Trigger opens = {};
  Trigger closes = {TriggerKind::never};
};

/// Marks a place of the part at which the front's arrival is noticed: the nearest node.
struct Sensor {
  std::string name;
  Vec3 position = Vec3::Zero();  ///< m
};

/// Describes one gate. It feeds all nodes within `radius` of the line from `position` to `end`, at one
/// pressure; or, where the mesh is coarser than the gate, the nearest node. The pressure at a round gate is
/// that at `radius`, whatever the mesh (the flux of the exact radial field is imposed on the gate's edges:
/// Peaceman, SPE J. 18, 183 (1978), for triangles).
struct Gate {
  std::string name = "gate";
  Vec3 position = Vec3::Zero();  ///< m
  std::optional<Vec3> end = {};  ///< other end of an edge or film gate, m
  double radius = 1e-3;          ///< m
  double resistance = 0;         ///< of the runner from the sprue, Pa s/m³: p_sprue - p_gate = R Q
  std::vector<OpenInterval> intervals = std::vector<OpenInterval>(1);  ///< one after the other
};

}  // namespace fiberfate
