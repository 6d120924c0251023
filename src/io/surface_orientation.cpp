// Turns triangles to agree with their neighbours.
#include "io/surface_orientation.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace fiberfate {
namespace {

enum class Side : char { unknown, as_given, turned };

/// Joins two triangles at an edge.
struct Neighbour {
  std::size_t triangle;
  bool agrees;  ///< both run the same way round: along the edge, one there and one back
};

struct HalfEdge {
  Index low, high;
  std::size_t triangle;
  bool forward;
};

std::vector<HalfEdge> sorted_half_edges(const SurfaceMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return edges;
}

std::vector<std::vector<Neighbour>> neighbours_of(const SurfaceMesh& mesh) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    const HalfEdge& one = edges[begin];
    while (end < edges.size() && edges[end].low == one.low && edges[end].high == one.high) ++end;
    if (end - begin != 2) continue;
    const HalfEdge& other = edges[begin + 1];
    neighbours[one.triangle].push_back({other.triangle, one.forward != other.forward});
    neighbours[other.triangle].push_back({one.triangle, one.forward != other.forward});
  }
  return neighbours;
}

/// A piece of the surface: its triangles, and whether it has two sides.
struct Piece {
  std::vector<std::size_t> triangles;
  bool two_sided = true;
};

/// Goes over a piece and gives every triangle the side that agrees with the first.
Piece walk(std::size_t first, const std::vector<std::vector<Neighbour>>& neighbours,
           std::vector<Side>& sides) {
  Piece piece{{first}};
  sides[first] = Side::as_given;
  for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
    const std::size_t here = piece.triangles[i];
    const Side other = sides[here] == Side::as_given ? Side::turned : Side::as_given;
    for (const Neighbour& next : neighbours[here]) {
      const Side wanted = next.agrees ? sides[here] : other;
      if (sides[next.triangle] == Side::unknown) {
        sides[next.triangle] = wanted;
        piece.triangles.push_back(next.triangle);
      } else if (sides[next.triangle] != wanted) {
        piece.two_sided = false;
      }
    }
  }
  return piece;
}

}  // namespace

std::size_t turn_to_agree(SurfaceMesh& mesh) {
  const std::vector<std::vector<Neighbour>> neighbours = neighbours_of(mesh);
  std::vector<Side> sides(mesh.triangles.size(), Side::unknown);
  std::size_t count = 0;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (sides[first] != Side::unknown) continue;
    const Piece piece = walk(first, neighbours, sides);
    if (!piece.two_sided) continue;
    const std::size_t turned = std::count_if(piece.triangles.begin(), piece.triangles.end(),
                                             [&sides](std::size_t t) { return sides[t] == Side::turned; });
    const bool most = 2 * turned > piece.triangles.size();
    for (const std::size_t t : piece.triangles)
      if ((sides[t] == Side::turned) != most) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++count;
      }
  }
  return count;
}

}  // namespace fiberfate
