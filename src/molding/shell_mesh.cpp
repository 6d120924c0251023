// Measures shells: control volumes, edges, frames, and how vectors go from node to node.
#include "molding/shell_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fiberfate {
namespace {

/// Cosine of the angle between the normal and the part's first axis beyond which e1 follows the second axis.
constexpr double steep = 0.9;

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// Voronoi areas of a triangle's corners; where it is obtuse half of it for the obtuse corner and a quarter
/// each for the others (Meyer et al. 2003).
std::array<double, 3> corner_areas(const std::array<double, 3>& cotangent,
                                   const std::array<double, 3>& squared_edge, double area) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (cotangent[k] >= 0) continue;
    std::array<double, 3> areas = {area / 4, area / 4, area / 4};
    areas[k] = area / 2;
    return areas;
  }
  std::array<double, 3> areas;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    areas[k] = (squared_edge[i] * cotangent[i] + squared_edge[j] * cotangent[j]) / 8;
  }
  return areas;
}

}  // namespace

double volume_of(const Shell& shell) {
  double volume = 0;
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    const auto& [a, b, c] = shell.triangles[t];
    const Vec3& corner = shell.nodes[at(a)];
    const Vec3 twice_area = (shell.nodes[at(b)] - corner).cross(shell.nodes[at(c)] - corner);
    volume += 0.5 * twice_area.norm() * shell.thickness[t];
  }
  return volume;
}

ShellMesh::ShellMesh(Shell shell) : shell_(std::move(shell)) {
  check_shell(shell_);
  flow_ = flow_triangles(shell_);
  measure_triangles();
  link_edges();
  cut_off_ = negative_share();
  // What is lessened may leave a neighbour's edge with too little in turn.
  constexpr int most_passes = 20;
  for (int pass = 0; pass < most_passes && mend_negative_weights(); ++pass) {
  }
  orient_nodes();
  link_neighbours();
}

void ShellMesh::measure_triangles() {
  const std::size_t n = node_count();
  areas_.assign(n, 0);
  volumes_.assign(n, 0);
  angles_.assign(n, 0);
  half_cotangents_.resize(triangle_count());
  for (std::size_t t = 0; t < triangle_count(); ++t) {
    const auto& corner = flow_.corners[t];
    std::array<double, 3> cotangent, squared_edge;
    double area = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& x = shell_.nodes[at(corner[k])];
      const Vec3 u = shell_.nodes[at(corner[(k + 1) % 3])] - x, v = shell_.nodes[at(corner[(k + 2) % 3])] - x;
      const double sine = u.cross(v).norm();
      cotangent[k] = u.dot(v) / sine;
      half_cotangents_[t][k] = cotangent[k] / 2;
      squared_edge[k] = (v - u).squaredNorm();
      angles_[at(corner[k])] += std::atan2(sine, u.dot(v));
      area = sine / 2;
    }
    const std::array<double, 3> share = corner_areas(cotangent, squared_edge, area);
    for (std::size_t k = 0; k < 3; ++k) {
      areas_[at(corner[k])] += share[k];
      volumes_[at(corner[k])] += share[k] * flow_.thickness[t];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    total_area_ += areas_[i];
    total_volume_ += volumes_[i];
  }
}

void ShellMesh::link_edges() {
  struct Side {
    Index low, high, triangle, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangle_count());
  for (std::size_t t = 0; t < triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = flow_.corners[t][(k + 1) % 3], b = flow_.corners[t][(k + 2) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), static_cast<Index>(k)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  triangle_edges_.resize(triangle_count());
  on_boundary_.assign(node_count(), 0);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) {
      triangle_edges_[at(sides[end].triangle)][at(sides[end].corner)] = static_cast<Index>(edges_.size());
      ++end;
    }
    if (end - begin == 1) on_boundary_[at(sides[begin].low)] = on_boundary_[at(sides[begin].high)] = 1;
    edges_.push_back({sides[begin].low, sides[begin].high});
  }
}

std::vector<double> ShellMesh::edge_weights() const {
  std::vector<double> weights(edges_.size(), 0);
  for (std::size_t t = 0; t < triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) weights[at(triangle_edges_[t][k])] += half_cotangents_[t][k];
  return weights;
}

double ShellMesh::negative_share() const {
  double all = 0, negative = 0;
  for (const double weight : edge_weights()) {
    all += std::abs(weight);
    negative += std::max(-weight, 0.0);
  }
  return negative / all;
}

/// Linear elements resist flow along an edge of length L, under a gradient of one, with sum(w l^2) = A over
/// the edges of its triangles, l their lengths along it and A the area. Without a weight w < 0 of the edge
/// itself the others give A - w L^2.
bool ShellMesh::mend_negative_weights() {
  const std::vector<double> weights = edge_weights();
  std::vector<double> areas(edges_.size(), 0);
  for (std::size_t t = 0; t < triangle_count(); ++t) {
    const auto& [a, b, c] = flow_.corners[t];
    const Vec3& x = shell_.nodes[at(a)];
    const double area = 0.5 * (shell_.nodes[at(b)] - x).cross(shell_.nodes[at(c)] - x).norm();
    for (const Index edge : triangle_edges_[t]) areas[at(edge)] += area;
  }
  bool mended = false;
  for (std::size_t t = 0; t < triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t e = at(triangle_edges_[t][k]);
      if (!(weights[e] < 0)) continue;
      const double squared =
          (shell_.nodes[at(edges_[e].second)] - shell_.nodes[at(edges_[e].first)]).squaredNorm();
      for (double& weight : half_cotangents_[t]) weight *= areas[e] / (areas[e] - weights[e] * squared);
      half_cotangents_[t][k] = 0;
      mended = true;
    }
  return mended;
}

void ShellMesh::orient_nodes() {
  std::vector<Vec3> normals(node_count(), Vec3::Zero());
  for (const auto& corner : flow_.corners) {
    const Vec3& x = shell_.nodes[at(corner[0])];
    const Vec3 normal = (shell_.nodes[at(corner[1])] - x).cross(shell_.nodes[at(corner[2])] - x);
    for (const Index node : corner) {
      // At a junction the sheets are turned any way round: the first one decides the side.
      const double side =
          normals[at(node)].dot(normal) < 0 && shell_.junctions == Junctions::allowed ? -1 : 1;
      normals[at(node)] += side * normal;
    }
  }
  frames_.resize(node_count());
  for (std::size_t i = 0; i < node_count(); ++i) {
    const Vec3 normal = normals[i].normalized();
    const Vec3 guide = std::abs(normal[0]) < steep ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 first = (guide - guide.dot(normal) * normal).normalized();
    frames_[i] << first, normal.cross(first), normal;
  }
}

void ShellMesh::link_neighbours() {
  neighbour_begin_.assign(node_count() + 1, 0);
  for (const ShellEdge& edge : edges_) {
    ++neighbour_begin_[at(edge.first) + 1];
    ++neighbour_begin_[at(edge.second) + 1];
  }
  for (std::size_t i = 0; i < node_count(); ++i) neighbour_begin_[i + 1] += neighbour_begin_[i];
  neighbours_.resize(neighbour_begin_.back());
  std::vector<std::size_t> next(neighbour_begin_.begin(), neighbour_begin_.end() - 1);
  std::vector<Vec3> normals(edges_.size(), Vec3::Zero());
  for (std::size_t t = 0; t < triangle_count(); ++t) {
    const auto& corner = flow_.corners[t];
    const Vec3& x = shell_.nodes[at(corner[0])];
    const Vec3 normal = (shell_.nodes[at(corner[1])] - x).cross(shell_.nodes[at(corner[2])] - x).normalized();
    for (const Index edge : triangle_edges_[t])
      normals[at(edge)] += normals[at(edge)].dot(normal) < 0 ? Vec3(-normal) : normal;
  }
  // The surface around an edge is turned into the tangent plane of its node, which unfolds bends.
  const auto in_frame = [&](Index node, const Vec3& along, const Vec3& normal) {
    const Mat3& frame = frames_[at(node)];
    const Vec3 up = frame.col(2);
    const Vec3 flat =
        Eigen::Quaterniond::FromTwoVectors(normal.dot(up) < 0 ? Vec3(-normal) : normal, up) * along;
    return Vec2(frame.col(0).dot(flat), frame.col(1).dot(flat)).normalized();
  };
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto [a, b] = edges_[e];
    const Vec3 along = shell_.nodes[at(b)] - shell_.nodes[at(a)];
    const Vec2 at_a = in_frame(a, along, normals[e]), at_b = in_frame(b, along, normals[e]);
    // A vector keeps its angle to the edge: from b's frame to a's it turns by angle(a) - angle(b).
    const Vec2 turn(at_a.dot(at_b), at_b[0] * at_a[1] - at_b[1] * at_a[0]);
    const auto edge = static_cast<Index>(e);
    neighbours_[next[at(a)]++] = {b, edge, along.norm(), at_a, turn};
    neighbours_[next[at(b)]++] = {a, edge, along.norm(), -at_b, Vec2(turn[0], -turn[1])};
  }
}

std::size_t ShellMesh::nearest_node(const Vec3& place) const {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < node_count(); ++i)
    if ((shell_.nodes[i] - place).squaredNorm() < (shell_.nodes[nearest] - place).squaredNorm()) nearest = i;
  return nearest;
}

}  // namespace fiberfate
