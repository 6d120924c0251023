// Distances between gates and the part, and how melt leaves a round gate.
#include "molding/gate_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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
    for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.shell().nodes[triangle[k]];
    nearest = std::min(nearest, distance_to_triangle(x, corner));
  }
  return nearest;
}

/// Weight cot/2 + cot/2 of an edge that is none but for round-off: the diagonal of a rectangle.
constexpr double least_weight = 1e-9;
/// Logarithm of the distance of a node outside over the radius that counts at least: nodes on the rim of a
/// gate are at its pressure.
constexpr double least_logarithm = 1e-3;

/// What the triangles on both sides of an edge that leaves a gate say of it.
struct LeavingEdge {
  Index edge = 0, outside = 0;
  double start = 0, end = 0;  ///< distances of its nodes from the centre, m
  double angle = 0;           ///< under which its dual face is seen from the centre
  double weight = 0;          ///< cot/2 + cot/2
};

/// The angle under which the half of an edge's dual face that lies in a triangle, from the middle of
/// the edge a-b to the circumcentre, is seen from a centre; positive where it turns as a, b, c do.
double dual_angle(const std::array<Vec3, 3>& corner, const Vec3& centre) {
  const auto& [a, b, c] = corner;
  const Vec3 u = b - a, v = c - a, normal = u.cross(v);
  const Vec3 circumcentre = a + (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) /
                                    (2 * normal.squaredNorm());
  // Where the surface bends, the centre counts as if it lay in the plane of the triangle.
  const Vec3 up = normal.normalized(), foot = centre - up.dot(centre - a) * up;
  const Vec3 from = a + 0.5 * u - foot, to = circumcentre - foot;
  return std::atan2(up.dot(from.cross(to)), from.dot(to));
}

/// Finds the edges from nodes of a gate to others, in rising order.
std::vector<LeavingEdge> leaving_edges(std::span<const Index> nodes, const Vec3& centre,
                                       const ShellMesh& mesh) {
  const auto inside = [&](Index node) { return std::binary_search(nodes.begin(), nodes.end(), node); };
  const auto at = [&](Index node) { return mesh.shell().nodes[node]; };
  std::map<Index, LeavingEdge> by_edge;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      // Seen along a-b the triangle lies on the left; the edge leaves the gate at b, or at a.
      const Index c = mesh.corners(t)[k], a = mesh.corners(t)[(k + 1) % 3], b = mesh.corners(t)[(k + 2) % 3];
      if (inside(a) == inside(b)) continue;
      const Index start = inside(a) ? a : b, outside = inside(a) ? b : a;
      LeavingEdge& edge = by_edge[mesh.edges_of(t)[k]];
      edge.edge = mesh.edges_of(t)[k];
      edge.outside = outside;
      edge.start = (at(start) - centre).norm();
      edge.end = (at(outside) - centre).norm();
      edge.angle += (inside(a) ? 1 : -1) * dual_angle({at(a), at(b), at(c)}, centre);
      edge.weight += mesh.half_cotangents(t)[k];
    }
  std::vector<LeavingEdge> leaving;
  for (const auto& [number, edge] : by_edge) leaving.push_back(edge);
  return leaving;
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
  const Vec3 centre = nodes.size() == 1 ? mesh.shell().nodes[nodes.front()] : gate.position;
  std::vector<LeavingEdge> leaving = leaving_edges(nodes, centre, mesh);
  double whole = 0, forward = 0;
  for (const LeavingEdge& one : leaving) {
    whole += one.angle;
    forward += std::max(one.angle, 0.0);
  }
  if (!(whole > 0)) return {};
  std::vector<GateEdge> edges;
  for (const LeavingEdge& one : leaving) {
    if (!(one.weight > least_weight)) continue;
    GateEdge edge{one.edge, one.outside, 1, one.start, one.end, gate.radius};
    edge.end = std::max(edge.end, gate.radius * std::exp(least_logarithm));
    edge.scale =
        std::max(one.angle, 0.0) * (whole / forward) / (one.weight * std::log(edge.end / gate.radius));
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace fiberfate
