// Measures distances between gates and the part.
#include "molding/gate_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fiberfate {
namespace {

double distance_to_line(const Vec3& x, const Gate& gate) {
  if (!gate.end) return (x - gate.position).norm();
  const Vec3 along = *gate.end - gate.position;
  const double square = along.squaredNorm();
  const double part = square > 0 ? std::clamp((x - gate.position).dot(along) / square, 0.0, 1.0) : 0.0;
  return (x - gate.position - part * along).norm();
}

/// Distance of a point to a triangle: to its plane where the foot lies inside, else to its nearest side.
double distance_to_triangle(const Vec3& x, const std::array<Vec3, 3>& corner) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = corner[k];
    const Vec3 side = corner[(k + 1) % 3] - a;
    inside = inside && normal.dot(side.cross(x - a)) >= 0;
    const double part = std::clamp((x - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (x - a - part * side).norm());
  }
  return inside ? std::abs(normal.dot(x - corner[0])) : nearest;
}

double distance_to_part(const Vec3& x, const ShellMesh& mesh) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.shell().triangles) {
    std::array<Vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.shell().nodes[static_cast<std::size_t>(triangle[k])];
    nearest = std::min(nearest, distance_to_triangle(x, corner));
  }
  return nearest;
}

}  // namespace

double distance_from_part(const Gate& gate, const ShellMesh& mesh) {
  double farthest = distance_to_part(gate.position, mesh);
  if (gate.end) farthest = std::max(farthest, distance_to_part(*gate.end, mesh));
  return farthest;
}

std::vector<Index> nodes_of(const Gate& gate, const ShellMesh& mesh) {
  std::vector<Index> nodes;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    const double distance = distance_to_line(mesh.shell().nodes[i], gate);
    if (distance <= gate.radius) nodes.push_back(static_cast<Index>(i));
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  if (nodes.empty()) nodes.push_back(static_cast<Index>(nearest));
  return nodes;
}

double GateEdge::front_factor(double filled) const {
  // The front is taken to be outside the gate by at least a tenth of the way.
  const double front = std::max(start + (0.5 + filled) * (end - start), radius + 0.1 * (end - radius));
  return std::log(end / radius) / std::log(front / radius);
}

std::vector<GateEdge> edges_of_round_gate(const Gate& gate, std::span<const Index> nodes,
                                          const ShellMesh& mesh) {
  if (gate.end) return {};
  const auto inside = [&](Index node) { return std::binary_search(nodes.begin(), nodes.end(), node); };
  const auto& x = mesh.shell().nodes;
  const Vec3 centre = nodes.size() == 1 ? x[nodes.front()] : gate.position;
  double angle = 0, weight = 0;
  std::vector<GateEdge> leaving;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto& corner = mesh.shell().triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = corner[(k + 1) % 3], b = corner[(k + 2) % 3];
      if (inside(corner[k]) && !inside(a) && !inside(b)) {
        const Vec3 u = x[a] - centre, v = x[b] - centre;
        angle += std::atan2(u.cross(v).norm(), u.dot(v));
      }
      if (inside(a) == inside(b)) continue;
      const Index outside = inside(a) ? b : a, start = inside(a) ? a : b;
      const double distance = (x[outside] - centre).norm();
      if (!(distance > gate.radius)) return {};
      weight += mesh.half_cotangents(t)[k] * std::log(distance / gate.radius);
      leaving.push_back({mesh.edges_of(t)[k], outside, 1, (x[start] - centre).norm(), distance, gate.radius});
    }
  }
  if (!(weight > 0)) return {};
  std::sort(leaving.begin(), leaving.end(),
            [](const GateEdge& a, const GateEdge& b) { return a.edge < b.edge; });
  leaving.erase(std::unique(leaving.begin(), leaving.end(),
                            [](const GateEdge& a, const GateEdge& b) { return a.edge == b.edge; }),
                leaving.end());
  for (GateEdge& edge : leaving) edge.scale = angle / weight;
  return leaving;
}

}  // namespace fiberfate
