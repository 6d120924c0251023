// Checks shells of triangles and lists their faults.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "base/error.hpp"
#include "molding/shell.hpp"

namespace fiberfate {
namespace {

/// Faults of one kind that are listed one by one; of a thousand alike a few are enough.
constexpr std::size_t most_listed = 5;

/// Twice the area over the square of the longest edge below which a triangle has no usable angles.
constexpr double least_shape = 1e-6;

/// Share of the shortest edge within which two nodes of rims lie at the same place.
constexpr double seam_share = 1e-3;

class FaultList {
 public:
  void add(const std::string& kind, std::string complaint, std::string remedy) {
    const std::size_t number = ++counts_[kind];
    if (number > most_listed) return;
    problems_.push_back({"", 0, 0, "", "", std::move(complaint), std::move(remedy)});
  }
  void raise() {
    for (const auto& [kind, number] : counts_)
      if (number > most_listed)
        problems_.push_back({"", 0, 0, "", "", fmt::format("{} more of: {}", number - most_listed, kind),
                             "they have the same remedy"});
    if (!problems_.empty()) throw InputError(problems_);
  }

 private:
  std::map<std::string, std::size_t> counts_;
  std::vector<InputProblem> problems_;
};

std::string place(const Vec3& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]);
}

Vec3 centre(const Shell& shell, std::size_t t) {
  const auto& corner = shell.triangles[t];
  return (shell.nodes[corner[0]] + shell.nodes[corner[1]] + shell.nodes[corner[2]]) / 3;
}

void check_sizes(const Shell& shell) {
  if (shell.triangles.empty() || shell.nodes.size() < 3)
    throw InputError("the shell has no triangles", "mesh the middle surface of the part with triangles");
  if (shell.thickness.size() != shell.triangles.size())
    throw InputError(fmt::format("the shell has {} triangles and {} thicknesses", shell.triangles.size(),
                                 shell.thickness.size()),
                     "give one thickness a triangle");
  if (!shell.region.empty() && shell.region.size() != shell.triangles.size())
    throw InputError(fmt::format("the shell has {} triangles and {} region numbers", shell.triangles.size(),
                                 shell.region.size()),
                     "give one region a triangle, or none");
  const auto count = static_cast<Index>(shell.nodes.size());
  for (std::size_t t = 0; t < shell.triangles.size(); ++t)
    for (const Index node : shell.triangles[t])
      if (node < 0 || node >= count)
        throw InputError(fmt::format("triangle {} names node {} of {}", t, node, count),
                         "number the nodes from 0 to the number of nodes less one");
}

void check_triangles(const Shell& shell, FaultList& faults) {
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    std::array<Vec3, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = shell.nodes[shell.triangles[t][k]];
    const double longest =
        std::max({(x[1] - x[0]).squaredNorm(), (x[2] - x[1]).squaredNorm(), (x[0] - x[2]).squaredNorm()});
    const double twice_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
    if (!(twice_area > least_shape * longest))
      faults.add("degenerate triangles",
                 fmt::format("triangle {} at {} is degenerate: its area is next to nothing", t,
                             place(centre(shell, t))),
                 "remove slivers and double nodes, or mesh again");
    if (!(shell.thickness[t] > 0) || !std::isfinite(shell.thickness[t]))
      faults.add("zero thickness",
                 fmt::format("triangle {} at {} has a thickness of {:g} m", t, place(centre(shell, t)),
                             shell.thickness[t]),
                 "give a thickness above zero to its region or element");
  }
}

struct HalfEdge {
  Index low, high;
  Index triangle;
  bool forward;
};

std::vector<HalfEdge> half_edges(const Shell& shell) {
  std::vector<HalfEdge> all;
  all.reserve(3 * shell.triangles.size());
  for (std::size_t t = 0; t < shell.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = shell.triangles[t][k], b = shell.triangles[t][(k + 1) % 3];
      all.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), a < b});
    }
  std::sort(all.begin(), all.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return all;
}

void check_edges(const Shell& shell, FaultList& faults) {
  const std::vector<HalfEdge> all = half_edges(shell);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].low == all[begin].low && all[end].high == all[begin].high) ++end;
    const std::string where = place(0.5 * (shell.nodes[all[begin].low] + shell.nodes[all[begin].high]));
    if (end - begin > 2 && shell.junctions == Junctions::refused)
      faults.add("edges of more than two triangles",
                 fmt::format("the edge of nodes {} and {} at {} belongs to {} triangles", all[begin].low,
                             all[begin].high, where, end - begin),
                 "mesh one middle surface (no closed skin), or allow junctions where ribs meet plates");
    if (end - begin == 2 && all[begin].forward == all[begin + 1].forward)
      faults.add("inverted triangles",
                 fmt::format("triangles {} and {} at {} are turned opposite ways", all[begin].triangle,
                             all[begin + 1].triangle, where),
                 "orient the surface: reverse the nodes of one of them; a band that is twisted by half a "
                 "turn has one "
                 "side only, and cannot be filled");
  }
}

/// Finds nodes that lie at the same place on two rims: a seam that melt cannot cross. Rims are looked at
/// along a direction in which few nodes stand level.
void check_seams(const Shell& shell, const std::vector<int>& rim_edges, FaultList& faults) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& corner : shell.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      shortest = std::min(shortest, (shell.nodes[corner[k]] - shell.nodes[corner[(k + 1) % 3]]).norm());
  const double reach = seam_share * shortest;
  const Vec3 direction = Vec3(1, 0.6180, 0.4142).normalized();
  std::vector<std::pair<double, std::size_t>> rim;
  for (std::size_t i = 0; i < shell.nodes.size(); ++i)
    if (rim_edges[i] > 0) rim.emplace_back(direction.dot(shell.nodes[i]), i);
  std::sort(rim.begin(), rim.end());
  for (std::size_t i = 0; i < rim.size(); ++i)
    for (std::size_t j = i + 1; j < rim.size() && rim[j].first - rim[i].first <= reach; ++j)
      if ((shell.nodes[rim[i].second] - shell.nodes[rim[j].second]).norm() <= reach)
        faults.add("open seams",
                   fmt::format("nodes {} and {} both lie at {}: the surface is open between them",
                               std::min(rim[i].second, rim[j].second), std::max(rim[i].second, rim[j].second),
                               place(shell.nodes[rim[i].second])),
                   "merge nodes that coincide, so that triangles on both sides share them");
}

/// Checks the rims of the surface.
void check_rims(const Shell& shell, FaultList& faults) {
  const std::vector<HalfEdge> all = half_edges(shell);
  std::vector<int> rim_edges(shell.nodes.size(), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto same = [&](std::size_t j) { return all[j].low == all[i].low && all[j].high == all[i].high; };
    if ((i > 0 && same(i - 1)) || (i + 1 < all.size() && same(i + 1))) continue;
    ++rim_edges[all[i].low];
    ++rim_edges[all[i].high];
  }
  if (std::ranges::all_of(rim_edges, [](int edges) { return edges == 0; }))
    faults.add("closed surfaces",
               "the surface is closed: it is the skin of a solid, not the middle surface of a wall",
               "export the middle surface of the part and give its thickness");
  check_seams(shell, rim_edges, faults);  // which also leave points where surfaces touch
  for (std::size_t i = 0; i < shell.nodes.size() && shell.junctions == Junctions::refused; ++i)
    if (rim_edges[i] > 2)
      faults.add(
          "points where surfaces touch",
          fmt::format("parts of the surface touch in nothing but node {} at {}", i, place(shell.nodes[i])),
          "join them along edges, or part them");
}

void check_connection(const Shell& shell, FaultList& faults) {
  std::vector<std::size_t> root(shell.nodes.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::vector<char> used(shell.nodes.size(), 0);
  for (const auto& corner : shell.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      used[corner[k]] = 1;
      root[find(corner[k])] = find(corner[(k + 1) % 3]);
    }
  const std::size_t first = find(shell.triangles.front()[0]);
  std::vector<char> reported(shell.nodes.size(), 0);
  for (std::size_t i = 0; i < shell.nodes.size(); ++i) {
    if (used[i] == 0) {
      faults.add("unused nodes",
                 fmt::format("node {} at {} belongs to no triangle", i, place(shell.nodes[i])), "remove it");
    } else if (find(i) != first && reported[find(i)] == 0) {
      reported[find(i)] = 1;
      faults.add("pieces",
                 fmt::format("the piece around node {} at {} hangs on nothing", i, place(shell.nodes[i])),
                 "join the surfaces so that they share nodes, or fill the pieces one by one");
    }
  }
}

}  // namespace

void check_shell(const Shell& shell) {
  check_sizes(shell);
  FaultList faults;
  check_triangles(shell, faults);
  check_edges(shell, faults);
  check_rims(shell, faults);
  check_connection(shell, faults);
  faults.raise();
}

}  // namespace fiberfate
