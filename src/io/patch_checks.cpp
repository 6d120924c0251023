// Finds patches that cannot be meshed.
#include "io/patch_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace fiberfate {
namespace {

using Edge = std::array<std::size_t, 2>;
constexpr double flatness = 1e-9;  // of the size of the patch

std::vector<Edge> edges_of(const Patch& patch) {
  std::vector<Edge> edges = patch.inner_edges;
  for (const std::vector<std::size_t>& loop : patch.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return edges;
}

/// Sums the cross products of a loop: twice its area times its normal.
Vec3 area_vector(const PatchedSurface& surface, const std::vector<std::size_t>& loop) {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = surface.corners.at(loop.front());
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += (surface.corners.at(loop[i]) - origin).cross(surface.corners.at(loop[i + 1]) - origin);
  return sum;
}

/// The side of a line on which a point lies: the sign of an area.
int side(const Vec3& from, const Vec3& to, const Vec3& point, const Vec3& normal) {
  const Vec3 along = to - from, aside = point - from;
  const double area = normal.dot(along.cross(aside));
  return std::abs(area) <= flatness * along.norm() * std::max(along.norm(), aside.norm()) ? 0
         : area > 0                                                                       ? 1
                                                                                          : -1;
}

/// Whether a point on the line of an edge lies between its ends.
bool lies_between(const Vec3& from, const Vec3& to, const Vec3& point) {
  const double part = (point - from).dot(to - from) / (to - from).squaredNorm();
  return part > -flatness && part < 1 + flatness;
}

bool touch(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b, const Vec3& normal) {
  const int a0 = side(b[0], b[1], a[0], normal), a1 = side(b[0], b[1], a[1], normal);
  const int b0 = side(a[0], a[1], b[0], normal), b1 = side(a[0], a[1], b[1], normal);
  if (a0 * a1 < 0 && b0 * b1 < 0) return true;
  return (a0 == 0 && lies_between(b[0], b[1], a[0])) || (a1 == 0 && lies_between(b[0], b[1], a[1])) ||
         (b0 == 0 && lies_between(a[0], a[1], b[0])) || (b1 == 0 && lies_between(a[0], a[1], b[1]));
}

bool share_corner(const Edge& a, const Edge& b) {
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

void check_patch(const PatchedSurface& surface, const Patch& patch) {
  const Vec3 area = area_vector(surface, patch.loops.front());
  const Vec3 normal = area.normalized();
  const Vec3& origin = surface.corners.at(patch.loops.front().front());
  const std::vector<Edge> edges = edges_of(patch);
  const auto ends = [&](const Edge& edge) {
    return std::array<Vec3, 2>{surface.corners.at(edge[0]), surface.corners.at(edge[1])};
  };
  const double size = std::sqrt(area.norm());
  const bool has_area = size > 0 && std::isfinite(size);
  for (const Edge& edge : edges)
    if (!has_area || !(std::abs(normal.dot(ends(edge)[0] - origin)) <= 1e3 * flatness * size))
      throw InputError(
          fmt::format("the part cannot be meshed: patch \"{}\" is not flat or has no area", patch.region),
          "check its dimensions");
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (share_corner(edges[i], edges[j]) || !touch(ends(edges[i]), ends(edges[j]), normal)) continue;
      const Vec3 at = 1e3 * ends(edges[j])[0];
      throw InputError(
          fmt::format("the part cannot be meshed: edges of patch \"{}\" cross near ({:.4g}, {:.4g}, "
                      "{:.4g}) mm",
                      patch.region, at.x(), at.y(), at.z()),
          "check its dimensions: openings, gates and ribs must lie inside the outline");
    }
}

}  // namespace

void check_patches(const PatchedSurface& surface) {
  for (const Patch& patch : surface.patches) check_patch(surface, patch);
}

}  // namespace fiberfate
