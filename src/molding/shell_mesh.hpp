// A part as a shell of triangles in space: control volumes, edges, frames of nodes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "molding/delaunay.hpp"
#include "molding/shell.hpp"

namespace fiberfate {

/// Joins two nodes; `first` < `second`.
struct ShellEdge {
  Index first = 0;
  Index second = 0;
};

/// Leads from a node to a neighbour.
struct ShellNeighbour {
  Index node = 0;
  Index edge = 0;
  double length = 0;        ///< of the edge, m
  Vec2 direction = {0, 0};  ///< unit vector along the edge in the frame of the node where it begins
  Vec2 turn = {1, 0};  ///< (cos, sin) of the angle by which components in the neighbour's frame are turned
                       ///< to become components in this frame

  /// Components in this frame of a vector in the neighbour's.
  [[nodiscard]] Vec2 turned(const Vec2& there) const {
    return {turn[0] * there[0] - turn[1] * there[1], turn[1] * there[0] + turn[0] * there[1]};
  }
};

/// Adds what filling needs to a checked shell. Arrays by node have the numbering of the shell. Triangles and
/// edges are those of the flow (`flow_triangles`): as many as the shell has, the same where it is Delaunay.
///
/// The frame of a node is (e1, e2, normal): e1 is the projection of the part's first axis, or second where
/// that stands on the surface. Vectors go from node to node by keeping their angle to the edge, so that a
/// flow around a bend stays parallel to itself. The control volume of a node is its Voronoi area (mixed for
/// obtuse triangles: Meyer, Desbrun, Schröder, Barr, 2003) times the thickness.
class ShellMesh {
 public:
  /// Raises InputError as check_shell.
  explicit ShellMesh(Shell shell);

  [[nodiscard]] const Shell& shell() const { return shell_; }
  [[nodiscard]] std::size_t node_count() const { return shell_.nodes.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return flow_.corners.size(); }
  /// Gives the nodes of a triangle of the flow.
  [[nodiscard]] const std::array<Index, 3>& corners(std::size_t triangle) const {
    return flow_.corners[triangle];
  }
  /// The thickness of a triangle of the flow, m.
  [[nodiscard]] double thickness_of(std::size_t triangle) const { return flow_.thickness[triangle]; }
  /// How many edges of the shell the flow does not use, since others are better.
  [[nodiscard]] std::size_t turned_edges() const { return flow_.turned; }
  [[nodiscard]] std::span<const ShellEdge> edges() const { return edges_; }
  /// Gives the edges of a triangle; edge k is opposite to its node k.
  [[nodiscard]] const std::array<Index, 3>& edges_of(std::size_t triangle) const {
    return triangle_edges_[triangle];
  }
  /// Gives half the cotangents of a triangle's angles: the weights of its edges in the stiffness of linear
  /// elements. An edge at which they sum up to less than nothing has none (`cut_off`); the others of its
  /// triangles are lessened so that flow along that edge, as along a wall, meets the same resistance as
  /// before.
  [[nodiscard]] const std::array<double, 3>& half_cotangents(std::size_t triangle) const {
    return half_cotangents_[triangle];
  }
  /// Share of the weights of all edges, by size, that was negative: edges of obtuse triangles at walls and
  /// folds, which could not be turned into others.
  [[nodiscard]] double cut_off() const { return cut_off_; }
  [[nodiscard]] std::span<const ShellNeighbour> neighbours(std::size_t node) const {
    return std::span(neighbours_)
        .subspan(neighbour_begin_[node], neighbour_begin_[node + 1] - neighbour_begin_[node]);
  }
  [[nodiscard]] double area(std::size_t node) const { return areas_[node]; }                        ///< m²
  [[nodiscard]] double volume(std::size_t node) const { return volumes_[node]; }                    ///< m³
  [[nodiscard]] double thickness(std::size_t node) const { return volumes_[node] / areas_[node]; }  ///< m
  /// The angle of the surface around a node: 2 pi inside, less at the edge of the part.
  [[nodiscard]] double angle(std::size_t node) const { return angles_[node]; }
  [[nodiscard]] bool on_boundary(std::size_t node) const { return on_boundary_[node] != 0; }
  [[nodiscard]] double total_volume() const { return total_volume_; }  ///< m³
  [[nodiscard]] double total_area() const { return total_area_; }      ///< m²

  /// Gives e1, e2 and the normal of a node as columns.
  [[nodiscard]] const Mat3& frame(std::size_t node) const { return frames_[node]; }
  /// Finds the node nearest to a place.
  [[nodiscard]] std::size_t nearest_node(const Vec3& place) const;

 private:
  void measure_triangles();
  void link_edges();
  [[nodiscard]] std::vector<double> edge_weights() const;
  [[nodiscard]] double negative_share() const;
  bool mend_negative_weights();
  void orient_nodes();
  void link_neighbours();

  Shell shell_;
  FlowTriangles flow_;
  std::vector<ShellEdge> edges_;
  std::vector<std::array<Index, 3>> triangle_edges_;
  std::vector<std::array<double, 3>> half_cotangents_;
  std::vector<double> areas_, volumes_, angles_;
  std::vector<char> on_boundary_;
  std::vector<Mat3> frames_;
  std::vector<std::size_t> neighbour_begin_;
  std::vector<ShellNeighbour> neighbours_;
  double total_volume_ = 0, total_area_ = 0, cut_off_ = 0;
};

}  // namespace fiberfate
