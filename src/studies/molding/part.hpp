// Describes a part in a case file, or names the file that holds it, and makes the shell to be filled.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keys/case_checker.hpp"
#include "keys/text_rows.hpp"
#include "molding/part_shapes.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// The keys of [part]: a drawing, or a file, and the thickness of its walls.
struct PartChoices : PartOutline {
  std::string file;
  double file_unit = 1e-3;                   ///< length of one unit of the file, m
  Junctions junctions = Junctions::refused;  ///< in that file
  std::vector<NamedNumbers> thicknesses;     ///< of regions, one each, m
  std::string thickness_file;                ///< table of elements of that file and their thicknesses
  std::string thickness_data;                ///< name of such data in that file
  std::vector<std::vector<double>> thickness_profile;  ///< rows (x m, factor on the thickness)
  double fan_thickness = 3e-3;                         ///< at its entry, m
};

void describe_part(KeyTable& table, PartChoices& part);
void validate_part(const PartChoices& part, CaseChecker& checker);

/// A part ready to be filled.
struct MoldingPart {
  Shell shell;
  std::vector<std::string> regions;
  std::vector<Gate> gates;           ///< those that belong to the part
  std::vector<std::string> remarks;  ///< what was mended when its file was read
  double meshing_s = 0;              ///< wall seconds that meshing it or reading its file took
  /// Puts a point of the flat part (x, y; m) onto the surface; empty for parts from files.
  std::function<Vec3(const Vec2&)> place;
};

/// Reads or meshes the part of a valid case; what is drawn alike is meshed once. Raises InputError as
/// read_surface, mesh_patches and check_shell, for a region that the part does not have, and as
/// element_thickness.
[[nodiscard]] MoldingPart make_part(const PartChoices& part);

/// Makes all of a part but its mesh: gates and places.
[[nodiscard]] MoldingPart part_around(const PartChoices& part);

}  // namespace fiberfate
