// Drawings of parts: their flat patches, where their gates are, and how they bend in
// space.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/patched_surface.hpp"
#include "molding/gate.hpp"
#include "molding/shell.hpp"

namespace fiberfate {

/// What a part is.
enum class PartKind { file, plaque, disc, frame, ribbed, tailgate };

/// Where melt enters a plaque, disc or frame; `given` leaves it to [gates].
enum class PartGate { edge, fan, pin, centre, given };

/// What a part looks like that is drawn, not read from a file; lengths in m. What a kind does not have
/// may be missing.
struct PartOutline {
  PartKind kind = PartKind::plaque;
  std::optional<double> thickness;
  std::optional<double> length;                         ///< along x
  std::optional<double> width;                          ///< along y
  std::optional<double> diameter;                       ///< of a disc
  std::optional<double> opening_length, opening_width;  ///< of a frame
  std::int64_t ribs = 2;
  double rib_height = 0.01;
  std::optional<double> volume;       ///< of a tailgate, m³
  std::optional<double> bend_radius;  ///< of the cylinder onto which a flat part is rolled along x
  double mesh_size = 4e-3;
  PartGate gate = PartGate::edge;
  std::optional<double> gate_width;  ///< of an edge or fan gate; not given: the whole edge
  double gate_radius = 1e-3;         ///< of a pin
  double fan_length = 0.03;
};

/// A part before it is meshed.
struct PartShape {
  PatchedSurface surface;
  std::vector<Gate> gates;  ///< in flat coordinates, z = 0
  /// Puts a point of the drawing into space; lengths along the surface stay what they are.
  std::function<Vec3(const Vec3&)> place;
};

/// Draws any part but one from a file.
[[nodiscard]] PartShape draw_part(const PartOutline& part);

/// The names of the nine gates of a tailgate and their flat coordinates (thesis table 14), m.
[[nodiscard]] std::vector<Gate> tailgate_gates(double radius);

}  // namespace fiberfate
