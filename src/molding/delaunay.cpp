// Turns edges until pairs of flat triangles are Delaunay.
#include "molding/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

namespace fiberfate {
namespace {

/// Weight of an edge, cot + cot, below which it is turned; a rectangle's diagonals have none but round-off.
constexpr double least_weight = -1e-9;
/// Turns in all, per edge of the shell, after which the rest stays as it is: in a plane far fewer are needed.
constexpr std::size_t most_turns_per_edge = 20;

using Edge = std::pair<Index, Index>;

Edge edge_between(Index a, Index b) {
  return std::minmax(a, b);
}

class EdgeTurner {
 public:
  explicit EdgeTurner(const Shell& shell) : shell_(shell) {
    result_.corners = shell.triangles;
    result_.thickness = shell.thickness;
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) add_sides(t);
  }

  FlowTriangles run() {
    std::deque<Edge> waiting;
    for (const auto& [edge, sides] : sides_) waiting.push_back(edge);
    std::size_t left = most_turns_per_edge * sides_.size();
    while (!waiting.empty() && left > 0) {
      const Edge edge = waiting.front();
      waiting.pop_front();
      if (!should_turn(edge)) continue;
      for (const Edge& around : turn(edge)) waiting.push_back(around);
      ++result_.turned;
      --left;
    }
    return std::move(result_);
  }

 private:
  const Vec3& at(Index node) const { return shell_.nodes[node]; }
  /// Finds the node of a triangle that is not on the edge.
  Index opposite(std::size_t triangle, const Edge& edge) const {
    for (const Index node : result_.corners[triangle])
      if (node != edge.first && node != edge.second) return node;
    return -1;
  }
  Vec3 normal(std::size_t triangle) const {
    const auto& [a, b, c] = result_.corners[triangle];
    return (at(b) - at(a)).cross(at(c) - at(a));
  }
  double cotangent(Index corner, const Edge& edge) const {
    const Vec3 u = at(edge.first) - at(corner), v = at(edge.second) - at(corner);
    return u.dot(v) / u.cross(v).norm();
  }

  void add_sides(std::size_t triangle) {
    const auto& corner = result_.corners[triangle];
    for (std::size_t k = 0; k < 3; ++k)
      sides_[edge_between(corner[k], corner[(k + 1) % 3])].push_back(triangle);
  }
  void remove_sides(std::size_t triangle) {
    const auto& corner = result_.corners[triangle];
    for (std::size_t k = 0; k < 3; ++k)
      std::erase(sides_[edge_between(corner[k], corner[(k + 1) % 3])], triangle);
  }

  bool should_turn(const Edge& edge) const {
    const std::vector<std::size_t>& sides = sides_.at(edge);
    if (sides.size() != 2) return false;
    const Index c = opposite(sides[0], edge), d = opposite(sides[1], edge);
    if (!(cotangent(c, edge) + cotangent(d, edge) < least_weight)) return false;
    const auto across = sides_.find(edge_between(c, d));
    if (c == d || (across != sides_.end() && !across->second.empty())) return false;
    const Vec3 first = normal(sides[0]), second = normal(sides[1]);
    const bool flat = first.dot(second) >= flat_cosine * first.norm() * second.norm();
    const double h = result_.thickness[sides[0]], other = result_.thickness[sides[1]];
    return flat && std::abs(h - other) <= like_thickness * 0.5 * (h + other);
  }

  /// Puts the edge between the opposite nodes; returns the sides of the pair.
  std::array<Edge, 4> turn(const Edge& edge) {
    const std::vector<std::size_t> sides = sides_.at(edge);
    const std::size_t one = sides[0], two = sides[1];
    const Index c = opposite(one, edge), d = opposite(two, edge);
    // Seen from the side of the normals, triangle one runs a, b, c.
    const auto& corner = result_.corners[one];
    const auto place = std::find(corner.begin(), corner.end(), c) - corner.begin();
    const Index a = corner[(place + 1) % 3], b = corner[(place + 2) % 3];
    const double first = normal(one).norm(), second = normal(two).norm();
    const double h = (first * result_.thickness[one] + second * result_.thickness[two]) / (first + second);
    remove_sides(one);
    remove_sides(two);
    result_.corners[one] = {c, a, d};
    result_.corners[two] = {d, b, c};
    if (result_.thickness[one] != result_.thickness[two]) result_.thickness[one] = result_.thickness[two] = h;
    add_sides(one);
    add_sides(two);
    return {edge_between(a, c), edge_between(b, c), edge_between(a, d), edge_between(b, d)};
  }

  const Shell& shell_;
  FlowTriangles result_;
  std::map<Edge, std::vector<std::size_t>> sides_;
};

}  // namespace

FlowTriangles flow_triangles(const Shell& shell) {
  return EdgeTurner(shell).run();
}

}  // namespace fiberfate
