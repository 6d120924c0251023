// Groups fibers into bundles and draws them along the packed bundles' axes.
#include "packing/bundles.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "packing/chain_shapes.hpp"
#include "packing/densest_fraction.hpp"

namespace fiberfate {
namespace {

constexpr int frames_a_rod = 4;  // along a bundle: between them normals are nearly constant

struct Place {
  double x, y;
};

/// The places of a hexagonal lattice of spacing 1 that are nearest to this point of it, seen from there, in a
/// fixed order.
std::vector<Place> places_around(const Place& centre, std::size_t count) {
  const int reach = 2 + static_cast<int>(std::sqrt(static_cast<double>(count)));
  std::vector<Place> places;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j)
      places.push_back({i + 0.5 * j - centre.x, 0.5 * std::sqrt(3.0) * j - centre.y});
  }
  // Rounded, so that places of one shell are equally far whatever the last digit says.
  const auto distance = [](const Place& p) { return std::lround(1e6 * std::hypot(p.x, p.y)); };
  std::stable_sort(places.begin(), places.end(),
                   [&](const Place& a, const Place& b) { return distance(a) < distance(b); });
  places.resize(count);
  return places;
}

/// The narrowest of the arrangements around a place, around the middle of two and around that of three.
std::vector<Place> hexagonal_places(std::size_t count) {
  const Place centres[] = {{0, 0}, {0.5, 0}, {0.5, 0.5 / std::sqrt(3.0)}};
  std::vector<Place> narrowest;
  for (const Place& centre : centres) {
    std::vector<Place> places = places_around(centre, count);
    const auto radius = [](const Place& place) { return std::hypot(place.x, place.y); };
    constexpr double clearly = 1 - 1e-6;
    if (narrowest.empty() || radius(places.back()) < clearly * radius(narrowest.back()))
      narrowest = std::move(places);
  }
  return narrowest;
}

double bundle_radius(std::size_t fibers, double spacing, double fiber_radius) {
  const Place farthest = hexagonal_places(fibers).back();
  return spacing * std::hypot(farthest.x, farthest.y) + fiber_radius;
}

void require_bundles(const BundleRequest& bundle) {
  if (bundle.fibers < 1)
    throw InputError(fmt::format("a bundle has {} fibers", bundle.fibers), "give at least 1");
  if (!(bundle.volume_fraction > 0) || !(bundle.volume_fraction <= densest_parallel))
    throw InputError(
        fmt::format("fibers fill {:.4g} of a bundle", bundle.volume_fraction),
        fmt::format("give a fraction above 0 and at most {:.4g} (pi / sqrt 12)", densest_parallel));
}

void require_room(const BundlePlan& plan) {
  double volume = 0, thickest = 0;
  for (const FiberBlank& bundle : plan.bundles.fibers) {
    const double radius = plan.bundles.materials[bundle.material_id].radius;
    volume += pi * radius * radius * bundle.length;
    thickest = std::max(thickest, 2 * radius);
  }
  const double fraction = volume / plan.bundles.cell.volume();
  if (fraction >= densest_parallel)
    throw InputError(
        fmt::format("the bundles fill {:.4g} of the cell", fraction),
        fmt::format(
            "even parallel bundles fill at most {:.4g}: put more fibers into the volume of a bundle, or "
            "fewer into a bundle",
            densest_parallel));
  for (int i = 0; i < 3; ++i) {
    if (plan.bundles.cell.height(i) < 2 * thickest)
      throw InputError(fmt::format("the cell is {:.4g} m high and a bundle {:.4g} m thick",
                                   plan.bundles.cell.height(i), thickest),
                       "give a cell of at least two bundle diameters, or fewer fibers a bundle");
  }
}

/// Finds normals along a bundle that do not turn about its axis: each is the one before, made perpendicular.
std::vector<Vec3> steady_normals(const Chains& bundles, FiberIndex bundle, int count) {
  std::vector<Vec3> normals;
  Vec3 normal;
  for (int i = 0; i <= count; ++i) {
    const double x = static_cast<double>(i) / count, step = 0.5 / count;
    const Vec3 tangent =
        (point_along(bundles, bundle, x + step) - point_along(bundles, bundle, x - step)).normalized();
    if (i == 0) normal = tangent.unitOrthogonal();
    normal = (normal - normal.dot(tangent) * tangent).normalized();
    normals.push_back(normal);
  }
  return normals;
}

/// Draws the fibers of one bundle; `scale` takes its units to those of the fibers.
class BundleDrawer {
 public:
  BundleDrawer(const Chains& bundles, FiberIndex bundle, double scale)
      : bundles_(bundles), bundle_(bundle), scale_(scale) {
    normals_ = steady_normals(bundles, bundle, frames_a_rod * bundles.rod_count(bundle));
  }
  /// Draws a fiber of equal rods beside the bundle's axis, by the length of its own curve, which differs from
  /// that of the axis where the bundle is bent.
  void draw(const FiberBlank& fiber, double length, const Place& beside, std::vector<Vec3>& nodes) const {
    constexpr double overhang = 0.2;  // inner curves are shorter than the bundle, by far less than this
    const std::size_t points = 2 * normals_.size() + 1;
    std::vector<Vec3> curve;
    std::vector<double> travelled;
    for (std::size_t i = 0; i < points; ++i) {
      const double x =
          -overhang + (1 + 2 * overhang) * static_cast<double>(i) / static_cast<double>(points - 1);
      curve.push_back(at(x, beside));
      travelled.push_back(i == 0 ? 0 : travelled.back() + (curve[i] - curve[i - 1]).norm());
    }
    const double middle = travelled[points / 2];
    std::size_t i = 1;
    for (Index k = 0; k <= fiber.rods; ++k) {
      const double place = middle + length * (static_cast<double>(k) / fiber.rods - 0.5);
      while (i + 1 < points && travelled[i] < place) ++i;
      const double share = (place - travelled[i - 1]) / (travelled[i] - travelled[i - 1]);
      nodes.push_back(curve[i - 1] + share * (curve[i] - curve[i - 1]));
    }
  }

 private:
  /// The point at share x of the bundle, beside its axis.
  [[nodiscard]] Vec3 at(double x, const Place& beside) const {
    const double count = static_cast<double>(normals_.size() - 1), step = 0.5 / count;
    const Vec3 tangent =
        (point_along(bundles_, bundle_, x + step) - point_along(bundles_, bundle_, x - step)).normalized();
    const Vec3& near = normals_[std::lround(std::clamp(x, 0.0, 1.0) * count)];
    const Vec3 normal = (near - near.dot(tangent) * tangent).normalized();
    return scale_ * point_along(bundles_, bundle_, x) + beside.x * normal + beside.y * tangent.cross(normal);
  }

  const Chains& bundles_;
  FiberIndex bundle_;
  double scale_;
  std::vector<Vec3> normals_;
};

}  // namespace

BundlePlan plan_bundles(const PackingRequest& request) {
  require_bundles(request.bundle);
  BundlePlan plan;
  plan.bundles = request;
  plan.bundles.start = PackingStart::dispersed;
  // Bundles are not what the contact law is of: they need not be at rest under it.
  plan.bundles.rest.law = "exponential";
  plan.bundles.rest.force_constant = 0;
  plan.bundles.materials.clear();
  plan.bundles.fibers.clear();
  std::vector<std::size_t> order(request.fibers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto kind = [&](std::size_t f) {
    return std::pair(request.fibers[f].material_id, request.fibers[f].length);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return kind(a) < kind(b); });
  std::map<std::pair<std::uint16_t, std::size_t>, std::uint16_t>
      sections;  // by material and number of fibers
  double thickest = 0;
  for (std::size_t first = 0; first < order.size();) {
    const std::uint16_t material = request.fibers[order[first]].material_id;
    std::size_t last = first;
    while (last < order.size() && last - first < static_cast<std::size_t>(request.bundle.fibers) &&
           request.fibers[order[last]].material_id == material)
      ++last;
    const FiberMaterial& fiber = request.materials[material];
    const double spacing =
        fiber.diameter() * std::sqrt(pi / (2 * std::sqrt(3.0) * request.bundle.volume_fraction));
    const auto [section, is_new] = sections.try_emplace(
        {material, last - first}, static_cast<std::uint16_t>(plan.bundles.materials.size()));
    if (is_new)
      plan.bundles.materials.push_back(
          {bundle_radius(last - first, spacing, fiber.radius), fiber.youngs_modulus, fiber.density});
    thickest = std::max(thickest, plan.bundles.materials[section->second].radius);
    const FiberBlank& longest = request.fibers[order[last - 1]];
    plan.bundles.fibers.push_back({longest.length, longest.rods, section->second});
    plan.members.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(first),
                              order.begin() + static_cast<std::ptrdiff_t>(last));
    plan.spacing.push_back(spacing);
    first = last;
  }
  // The fiber on the inner side of a bend is bent more than the axis.
  if (request.minimum_radius > 0) plan.bundles.minimum_radius += thickest;
  require_room(plan);
  return plan;
}

Chains fibers_in_bundles(const PackingRequest& request, const BundlePlan& plan, const Chains& bundles) {
  const double unit = thickest_diameter(request);
  const double scale = thickest_diameter(plan.bundles) / unit;
  std::vector<std::vector<Vec3>> nodes(request.fibers.size());
  for (std::size_t b = 0; b < plan.members.size(); ++b) {
    const BundleDrawer drawer(bundles, FiberIndex(b), scale);
    const std::vector<Place> places = hexagonal_places(plan.members[b].size());
    const double spacing = plan.spacing[b] / unit;
    for (std::size_t m = 0; m < places.size(); ++m) {
      const std::size_t f = plan.members[b][m];
      drawer.draw(request.fibers[f], request.fibers[f].length / unit,
                  {spacing * places[m].x, spacing * places[m].y}, nodes[f]);
    }
  }
  Cell cell = request.cell;
  cell.lattice /= unit;
  ChainMaker maker(request, cell);
  for (const std::vector<Vec3>& fiber : nodes) maker.append(fiber);
  return maker.take();
}

}  // namespace fiberfate
