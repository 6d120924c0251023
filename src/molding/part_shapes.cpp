// Draws plaques, discs, frames, ribbed plates and the tailgate.
#include "molding/part_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

using Loop = std::vector<std::size_t>;

/// Collects corners; two at the same place are one.
class Drawing {
 public:
  explicit Drawing(double size) : size_(size) {}

  std::size_t corner(const Vec3& at) {
    for (std::size_t i = 0; i < surface_.corners.size(); ++i)
      if ((surface_.corners[i] - at).norm() < 1e-9) return i;
    surface_.corners.push_back(at);
    surface_.sizes.push_back(size_);
    return surface_.corners.size() - 1;
  }
  Loop loop(const std::vector<Vec3>& places) {
    Loop corners;
    for (const Vec3& at : places) {
      const std::size_t next = corner(at);
      if (corners.empty() || (corners.back() != next && corners.front() != next)) corners.push_back(next);
    }
    return corners;
  }
  Patch& patch(const std::string& region, const std::vector<Vec3>& outline) {
    surface_.patches.push_back({region, {loop(outline)}, {}, {}});
    return surface_.patches.back();
  }
  void hole(Patch& patch, const std::vector<Vec3>& outline) { patch.loops.push_back(loop(outline)); }
  [[nodiscard]] PatchedSurface take() { return std::move(surface_); }

 private:
  double size_;
  PatchedSurface surface_;
};

/// Lists the corners of a rectangle whose corners are cut by `chamfer`.
std::vector<Vec3> rectangle(const Vec2& low, const Vec2& high, double chamfer = 0) {
  const double c = chamfer;
  return {{low.x() + c, low.y(), 0},   {high.x() - c, low.y(), 0},  {high.x(), low.y() + c, 0},
          {high.x(), high.y() - c, 0}, {high.x() - c, high.y(), 0}, {low.x() + c, high.y(), 0},
          {low.x(), high.y() - c, 0},  {low.x(), low.y() + c, 0}};
}

/// Rolls the plane onto a cylinder along x.
std::function<Vec3(const Vec3&)> rolled(std::optional<double> radius) {
  if (!radius) return [](const Vec3& at) { return at; };
  return [r = *radius](const Vec3& at) {
    const double inside = r - at.z();
    return Vec3(inside * std::sin(at.x() / r), at.y(), r - inside * std::cos(at.x() / r));
  };
}

Gate edge_gate(double x, double from, double to, double radius) {
  Gate gate;
  gate.position = {x, from, 0};
  gate.end = Vec3(x, to, 0);
  gate.radius = radius;
  return gate;
}

Gate pin_gate(const Vec2& at, double radius) {
  Gate gate;
  gate.position = {at.x(), at.y(), 0};
  gate.radius = radius;
  return gate;
}

/// Puts the gate of a rectangle of length L and width W: the film of an edge or fan, or a pin.
void add_gate(const PartOutline& part, Drawing& drawing, Patch& plate, std::vector<Gate>& gates) {
  const double length = *part.length, width = *part.width;
  const double opening = std::min(part.gate_width.value_or(width), width);
  const double low = 0.5 * (width - opening), high = 0.5 * (width + opening);
  const double film = 0.5 * part.mesh_size;
  switch (part.gate) {
    case PartGate::edge:
      gates.push_back(edge_gate(0, low, high, std::min(film, 0.5 * *part.thickness)));
      break;
    case PartGate::fan:
      drawing.patch("fan",
                    {{-part.fan_length, low, 0}, {0, 0, 0}, {0, width, 0}, {-part.fan_length, high, 0}});
      gates.push_back(edge_gate(-part.fan_length, low, high, std::min(film, 0.5 * *part.thickness)));
      break;
    case PartGate::pin:
      gates.push_back(pin_gate({0, 0.5 * width}, part.gate_radius));
      break;
    case PartGate::centre:
      plate.inner_points.push_back(drawing.corner({0.5 * length, 0.5 * width, 0}));
      gates.push_back(pin_gate({0.5 * length, 0.5 * width}, part.gate_radius));
      break;
    case PartGate::given:
      break;
  }
}

/// Lists the outline of a rectangle with the ends of the gate's film on its edge.
std::vector<Vec3> gated_rectangle(const PartOutline& part) {
  const double length = *part.length, width = *part.width;
  std::vector<Vec3> outline = {{0, 0, 0}, {length, 0, 0}, {length, width, 0}, {0, width, 0}};
  if (part.gate == PartGate::edge && part.gate_width && *part.gate_width < width) {
    outline.push_back({0, 0.5 * (width + *part.gate_width), 0});
    outline.push_back({0, 0.5 * (width - *part.gate_width), 0});
  }
  if (part.gate == PartGate::pin) outline.push_back({0, 0.5 * width, 0});
  return outline;
}

PartShape draw_rectangle(const PartOutline& part) {
  PartShape shape;
  Drawing drawing(part.mesh_size);
  Patch plate = drawing.patch("plate", gated_rectangle(part));
  if (part.kind == PartKind::frame) {
    const Vec2 middle(0.5 * *part.length, 0.5 * *part.width);
    const Vec2 half(0.5 * *part.opening_length, 0.5 * *part.opening_width);
    drawing.hole(plate, rectangle(middle - half, middle + half));
  }
  add_gate(part, drawing, plate, shape.gates);
  shape.surface = drawing.take();
  shape.surface.patches.front() = plate;
  shape.place = rolled(part.bend_radius);
  return shape;
}

/// Draws upright ribs along x on a plate, evenly spaced across it.
PartShape draw_ribbed(const PartOutline& part) {
  PartShape shape;
  Drawing drawing(part.mesh_size);
  Patch plate = drawing.patch("plate", gated_rectangle(part));
  const double inset = 0.1 * *part.length;
  for (std::int64_t i = 1; i <= part.ribs; ++i) {
    const double y = *part.width * static_cast<double>(i) / static_cast<double>(part.ribs + 1);
    const Vec3 from(inset, y, 0), to(*part.length - inset, y, 0), up(0, 0, part.rib_height);
    plate.inner_edges.push_back({drawing.corner(from), drawing.corner(to)});
    drawing.patch("rib", {from, to, to + up, from + up});
  }
  add_gate(part, drawing, plate, shape.gates);
  shape.surface = drawing.take();
  shape.surface.patches.front() = plate;
  shape.place = rolled(part.bend_radius);
  return shape;
}

PartShape draw_disc(const PartOutline& part) {
  PartShape shape;
  Drawing drawing(part.mesh_size);
  const double radius = 0.5 * *part.diameter;
  const auto sides = std::max(12L, std::lround(2 * pi * radius / part.mesh_size));
  std::vector<Vec3> outline;
  for (long i = 0; i < sides; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(sides);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  Patch& plate = drawing.patch("disc", outline);
  plate.inner_points.push_back(drawing.corner(Vec3::Zero()));
  if (part.gate != PartGate::given) shape.gates.push_back(pin_gate(Vec2::Zero(), part.gate_radius));
  shape.surface = drawing.take();
  shape.place = rolled(part.bend_radius);
  return shape;
}

// The tailgate: our own drawing of a part with the volume and thickness of thesis table 15 and the
// proportions of figure 4.14. Lengths in m, in the developed (flat) surface: x from left to right, y upwards.
constexpr double tailgate_width = 1.5;
constexpr double tailgate_chamfer = 0.12;
constexpr double window_chamfer = 0.06;
constexpr double window_margin = 0.25;  // left and right of the window
constexpr double window_height = 0.42;
constexpr double window_top_margin = 0.3;
constexpr double lower_angle = 1.40;  // of the lower part to the ground, radians
constexpr double upper_angle = 0.62;  // of the window
constexpr double bend_length = 0.30;  // along the surface

double cut_area(double width, double height, double chamfer) {
  return width * height - 2 * chamfer * chamfer;
}

/// Bends the plane along y, from the angle of the lower part to that of the window, linear in arc length.
Vec3 bend_tailgate(const Vec3& at, double bend_begin) {
  const double y = at.y(), end = bend_begin + bend_length;
  const double curvature = (upper_angle - lower_angle) / bend_length;
  const auto along_arc = [curvature](double s) {
    const double angle = lower_angle + curvature * s;
    return Vec2((std::sin(angle) - std::sin(lower_angle)) / curvature,
                -(std::cos(angle) - std::cos(lower_angle)) / curvature);
  };
  Vec2 place = std::min(y, bend_begin) * Vec2(std::cos(lower_angle), std::sin(lower_angle));
  if (y > bend_begin) place += along_arc(std::min(y - bend_begin, bend_length));
  if (y > end) place += (y - end) * Vec2(std::cos(upper_angle), std::sin(upper_angle));
  return {at.x(), place.y(), -place.x()};
}

PartShape draw_tailgate(const PartOutline& part) {
  const double window_width = tailgate_width - 2 * window_margin;
  const double area = *part.volume / *part.thickness + cut_area(window_width, window_height, window_chamfer);
  const double height = (area + 2 * tailgate_chamfer * tailgate_chamfer) / tailgate_width;
  const double window_top = height - window_top_margin, window_bottom = window_top - window_height;
  PartShape shape;
  Drawing drawing(part.mesh_size);
  Patch plate = drawing.patch("tailgate", rectangle({0, 0}, {tailgate_width, height}, tailgate_chamfer));
  drawing.hole(plate, rectangle({window_margin, window_bottom}, {tailgate_width - window_margin, window_top},
                                window_chamfer));
  if (part.gate != PartGate::given) shape.gates = tailgate_gates(part.gate_radius);
  for (const Gate& gate : shape.gates) plate.inner_points.push_back(drawing.corner(gate.position));
  shape.surface = drawing.take();
  shape.surface.patches.front() = plate;
  const double bend_begin = window_bottom - 0.5 * bend_length;
  shape.place = [bend_begin](const Vec3& at) { return bend_tailgate(at, bend_begin); };
  return shape;
}

}  // namespace

std::vector<Gate> tailgate_gates(double radius) {
  // Pairs below and above the window; the front of thesis figure 4.16 runs from right to left.
  const std::vector<Vec2> places = {{0.06, 0.70}, {0.32, 0.25}, {0.32, 1.25}, {0.60, 0.25}, {0.60, 1.25},
                                    {0.86, 0.25}, {0.86, 1.25}, {1.36, 0.30}, {1.36, 1.10}};
  std::vector<Gate> gates;
  for (std::size_t i = 0; i < places.size(); ++i) {
    gates.push_back(pin_gate(places[i], radius));
    gates.back().name = "G" + std::to_string(i + 1);
  }
  return gates;
}

PartShape draw_part(const PartOutline& part) {
  switch (part.kind) {
    case PartKind::disc:
      return draw_disc(part);
    case PartKind::ribbed:
      return draw_ribbed(part);
    case PartKind::tailgate:
      return draw_tailgate(part);
    default:
      return draw_rectangle(part);
  }
}

}  // namespace fiberfate
