// Writes parts with their properties for structural solvers. Source: CalculiX CrunchiX user's manual 2.20 and
// Abaqus keywords: *ORIENTATION, *ELASTIC (TYPE=ENGINEERING CONSTANTS), *EXPANSION (TYPE=ORTHO), *SHELL
// SECTION.
#include <fmt/format.h>

#include <iterator>

#include "io/atomic_file.hpp"
#include "studies/molding/properties.hpp"

namespace fiberfate {
namespace {

void append_triangle(std::string& text, std::size_t number, const TriangleProperties& properties,
                     double thickness) {
  const auto out = std::back_inserter(text);
  const EngineeringConstants& c = properties.constants;
  const Mat3& axes = properties.axes;
  // nu_13 = nu_31 E_1/E_3, by the symmetry of the compliance.
  const double nu13 = c.nu31 * c.e1 / c.e3;
  fmt::format_to(
      out, "*ORIENTATION, NAME=O{}, SYSTEM=RECTANGULAR\n{:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}\n",
      number, axes(0, 0), axes(1, 0), axes(2, 0), axes(0, 1), axes(1, 1), axes(2, 1));
  fmt::format_to(out, "*MATERIAL, NAME=M{}\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n", number);
  fmt::format_to(out, "{:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g}, {:.7g},\n{:.7g}\n", c.e1, c.e2,
                 c.e3, c.nu12, nu13, c.nu23, c.g12, c.g31, c.g23);
  fmt::format_to(out, "*EXPANSION, TYPE=ORTHO\n{:.7g}, {:.7g}, {:.7g}\n", properties.expansion[0],
                 properties.expansion[1], properties.expansion[2]);
  fmt::format_to(out, "*SHELL SECTION, ELSET=E{0}, MATERIAL=M{0}, ORIENTATION=O{0}\n{1:.7g}\n", number,
                 thickness);
}

}  // namespace

void write_structural_input(const std::string& path, const Shell& shell,
                            const std::vector<TriangleProperties>& properties) {
  std::string text =
      "** Written by fiberfate: a molded part, SI units (m, N, Pa, K), keywords common to Abaqus and "
      "CalculiX.\n"
      "** Every triangle has its own material axes (1 along most fibers, 2 across, 3 the normal) and "
      "constants.\n"
      "*NODE, NSET=PART\n";
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < shell.nodes.size(); ++i)
    fmt::format_to(out, "{}, {:.9g}, {:.9g}, {:.9g}\n", i + 1, shell.nodes[i].x(), shell.nodes[i].y(),
                   shell.nodes[i].z());
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    const auto& [a, b, c] = shell.triangles[t];
    fmt::format_to(out, "*ELEMENT, TYPE=S3, ELSET=E{0}\n{0}, {1}, {2}, {3}\n", t + 1, a + 1, b + 1, c + 1);
  }
  fmt::format_to(out, "*ELSET, ELSET=PART, GENERATE\n1, {}, 1\n", shell.triangles.size());
  for (std::size_t t = 0; t < shell.triangles.size(); ++t)
    append_triangle(text, t + 1, properties[t], shell.thickness[t]);
  replace_file(path, text);
}

}  // namespace fiberfate
