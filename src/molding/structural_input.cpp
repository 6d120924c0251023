// Parts with their properties in the language of structural solvers. Source: CalculiX CrunchiX user's
// manual 2.20 and Abaqus keywords: *ORIENTATION, *ELASTIC (TYPE=ENGINEERING CONSTANTS), *EXPANSION
// (TYPE=ORTHO), *SHELL SECTION (COMPOSITE).
#include "molding/structural_input.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

namespace fiberfate {
namespace {

/// The name of the material and axes of a ply in a triangle.
std::string ply_name(std::size_t triangle, std::size_t ply) {
  return fmt::format("{}P{}", triangle + 1, ply + 1);
}

void append_material(std::string& text, const std::string& name, const TriangleProperties& properties) {
  const auto out = std::back_inserter(text);
  const EngineeringConstants& c = properties.constants;
  const Mat3& axes = properties.axes;
  // nu_13 = nu_31 E_1/E_3, by the symmetry of the compliance.
  const double nu13 = c.nu31 * c.e1 / c.e3;
  fmt::format_to(
      out, "*ORIENTATION, NAME=O{}, SYSTEM=RECTANGULAR\n{:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}\n",
      name, axes(0, 0), axes(1, 0), axes(2, 0), axes(0, 1), axes(1, 1), axes(2, 1));
  fmt::format_to(out, "*MATERIAL, NAME=M{}\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n", name);
  fmt::format_to(out, "{:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g},\n{:.7g}\n", c.e1, c.e2,
                 c.e3, c.nu12, nu13, c.nu23, c.g12, c.g31, c.g23);
  fmt::format_to(out, "*EXPANSION, TYPE=ORTHO\n{:.7g}, {:.7g}, {:.7g}\n", properties.expansion[0],
                 properties.expansion[1], properties.expansion[2]);
}

/// Lists the plies from one wall to the other; the innermost is one across the mid-plane.
void append_section(std::string& text, std::size_t triangle, const std::vector<Ply>& plies,
                    double thickness) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "*SHELL SECTION, ELSET=E{}, COMPOSITE\n", triangle + 1);
  const auto append = [&](std::size_t ply) {
    const double height = (ply == 0 ? 1 : 0.5) * plies[ply].share * thickness;
    const std::string name = ply_name(triangle, ply);
    fmt::format_to(out, "{:.7g}, , M{}, O{}\n", height, name, name);
  };
  for (std::size_t ply = plies.size(); ply-- > 1;) append(ply);
  for (std::size_t ply = 0; ply < plies.size(); ++ply) append(ply);
}

/// Numbers the middles of edges after the nodes of the shell, and writes them.
class EdgeMiddles {
 public:
  EdgeMiddles(const Shell& shell, std::string& text) : next_(shell.nodes.size() + 1) {
    const auto out = std::back_inserter(text);
    for (const auto& corner : shell.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = corner[k], b = corner[(k + 1) % 3];
        if (!numbers_.try_emplace(std::minmax(a, b), next_).second) continue;
        const Vec3 middle = 0.5 * (shell.nodes[a] + shell.nodes[b]);
        fmt::format_to(out, "{}, {:.9g}, {:.9g}, {:.9g}\n", next_++, middle.x(), middle.y(), middle.z());
      }
  }
  [[nodiscard]] std::size_t between(Index a, Index b) const { return numbers_.at(std::minmax(a, b)); }

 private:
  std::map<std::pair<Index, Index>, std::size_t> numbers_;
  std::size_t next_;
};

void append_elements(std::string& text, const Shell& shell, StructuralSolver solver) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "*NODE, NSET=PART\n");
  for (std::size_t i = 0; i < shell.nodes.size(); ++i)
    fmt::format_to(out, "{}, {:.9g}, {:.9g}, {:.9g}\n", i + 1, shell.nodes[i].x(), shell.nodes[i].y(),
                   shell.nodes[i].z());
  if (solver == StructuralSolver::abaqus) {
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
      const auto& [a, b, c] = shell.triangles[t];
      fmt::format_to(out, "*ELEMENT, TYPE=S3, ELSET=E{0}\n{0}, {1}, {2}, {3}\n", t + 1, a + 1, b + 1, c + 1);
    }
    return;
  }
  const EdgeMiddles middles(shell, text);
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    const auto& [a, b, c] = shell.triangles[t];
    fmt::format_to(out, "*ELEMENT, TYPE=S6, ELSET=E{0}\n{0}, {1}, {2}, {3}, {4}, {5}, {6}\n", t + 1, a + 1,
                   b + 1, c + 1, middles.between(a, b), middles.between(b, c), middles.between(c, a));
  }
}

}  // namespace

std::string structural_input(const Shell& shell, const std::vector<Ply>& plies, StructuralSolver solver) {
  std::string text = fmt::format(
      "** Written by fiberfate: a molded part, SI units (m, N, Pa, K), for {}.\n"
      "** Every triangle has plies with material axes (1 along most fibers, 2 across, 3 the normal) and "
      "constants\n** of their own, P1 at the mid-plane.\n",
      solver == StructuralSolver::abaqus ? "Abaqus" : "CalculiX");
  append_elements(text, shell, solver);
  fmt::format_to(std::back_inserter(text), "*ELSET, ELSET=PART, GENERATE\n1, {}, 1\n",
                 shell.triangles.size());
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    for (std::size_t ply = 0; ply < plies.size(); ++ply)
      append_material(text, ply_name(t, ply), plies[ply].triangles[t]);
    append_section(text, t, plies, shell.thickness[t]);
  }
  return text;
}

}  // namespace fiberfate
