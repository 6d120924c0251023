// Finds where fronts have met.
#include "molding/weld_lines.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace fiberfate {
namespace {

/// Cosine of the angle between two fronts beyond which their meeting is a weld line.
constexpr double weld_cosine = -0.5;

const ShellNeighbour& neighbour_of(const ShellMesh& mesh, Index node, Index other) {
  return *std::ranges::find(mesh.neighbours(node), other, &ShellNeighbour::node);
}

/// A point of a weld line: a node twice, or the two ends of an edge that it crosses, the lesser first.
using WeldPoint = std::pair<Index, Index>;

/// The points in which weld lines pass a triangle, in rising order.
std::vector<WeldPoint> points_in(const ShellMesh& mesh, const FillingState& state,
                                 std::array<Index, 3> corners) {
  std::ranges::sort(corners);
  std::vector<WeldPoint> points;
  for (const Index corner : corners)
    if (fronts_met_in(mesh, state, corner)) points.emplace_back(corner, corner);
  const auto on_line = [&points](Index node) {
    return std::ranges::find(points, WeldPoint(node, node)) != points.end();
  };
  for (const auto& [a, b] : {WeldPoint(corners[0], corners[1]), WeldPoint(corners[0], corners[2]),
                             WeldPoint(corners[1], corners[2])})
    if (!on_line(a) && !on_line(b) && fronts_met_between(state, a, neighbour_of(mesh, a, b)))
      points.emplace_back(a, b);
  std::ranges::sort(points);
  return points;
}

}  // namespace

bool fronts_met_between(const FillingState& state, std::size_t node, const ShellNeighbour& other) {
  const Vec2 &here = state.inflow[node], there = other.turned(state.inflow[other.node]);
  return here.dot(there) < weld_cosine * here.norm() * there.norm() && here.dot(other.direction) > 0 &&
         there.dot(other.direction) < 0;
}

bool fronts_met_in(const ShellMesh& mesh, const FillingState& state, std::size_t node) {
  return state.inflow[node] != Vec2::Zero() && state.inflow[node].norm() < 0.5 * mesh.volume(node);
}

std::vector<LinePiece> weld_lines(const ShellMesh& mesh, const FillingState& state) {
  // Two triangles share an edge whose ends are both on the line.
  std::set<std::pair<WeldPoint, WeldPoint>> pieces;
  const auto is_full = [&state](Index node) { return state.is_full(node); };
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!std::ranges::all_of(mesh.corners(t), is_full)) continue;
    const std::vector<WeldPoint> points = points_in(mesh, state, mesh.corners(t));
    for (std::size_t k = 1; k < points.size(); ++k) pieces.emplace(points[k - 1], points[k]);
  }
  const auto place = [&mesh](const WeldPoint& point) -> Vec3 {
    return 0.5 * (mesh.shell().nodes[point.first] + mesh.shell().nodes[point.second]);
  };
  std::vector<LinePiece> lines;
  for (const auto& [begin, end] : pieces) lines.push_back({place(begin), place(end)});
  return lines;
}

}  // namespace fiberfate
