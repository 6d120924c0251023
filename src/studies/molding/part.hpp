// Describes a part in a case file, or names the file that holds it, and makes the shell to be filled.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keys/case_checker.hpp"
#include "keys/key_table.hpp"
#include "molding/gate.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Names what a part is.
enum class PartKind { file, plaque, disc, frame, ribbed, tailgate };

/// Names where melt enters a plaque, disc or frame; `given` leaves it to [gates].
enum class PartGate { edge, fan, pin, centre, given };

/// Gives a region of a part a thickness of its own.
struct RegionThickness {
  std::string region;
  double thickness = 0;  ///< m
};

/// Holds [part].
struct PartChoices {
  PartKind kind = PartKind::plaque;
  std::string file;
  double file_unit = 1e-3;                   ///< length of one unit of the file, m
  Junctions junctions = Junctions::refused;  ///< in that file
  std::optional<double> thickness;           ///< m
  std::vector<RegionThickness> thicknesses;
  std::string thickness_file;  ///< table of elements of that file and their thicknesses
  std::string thickness_data;  ///< name of such data in that file
  std::vector<std::vector<double>> thickness_profile;   ///< rows (x m, factor on the thickness)
  std::optional<double> length;                         ///< along x, m
  std::optional<double> width;                          ///< along y, m
  std::optional<double> diameter;                       ///< of a disc, m
  std::optional<double> opening_length, opening_width;  ///< of a frame, m
  std::int64_t ribs = 2;
  double rib_height = 0.01;           ///< m
  std::optional<double> volume;       ///< of a tailgate, m³
  std::optional<double> bend_radius;  ///< of the cylinder onto which a flat part is rolled along x, m
  double mesh_size = 4e-3;            ///< m
  PartGate gate = PartGate::edge;
  std::optional<double> gate_width;  ///< of an edge or fan gate, m; not given: the whole edge
  double gate_radius = 1e-3;         ///< of a pin, m
  double fan_length = 0.03;          ///< m
  double fan_thickness = 3e-3;       ///< at its entry, m
};

void describe_part(KeyTable& table, PartChoices& part);
void validate_part(const PartChoices& part, CaseChecker& checker);

/// Holds a part ready to be filled.
struct MoldingPart {
  Shell shell;
  std::vector<std::string> regions;
  std::vector<Gate> gates;           ///< those that belong to the part
  std::vector<std::string> remarks;  ///< what was mended when its file was read
  /// Puts a point of the flat part (x, y; m) onto the surface; empty for parts from files.
  std::function<Vec3(const Vec2&)> place;
};

/// Reads or meshes the part of a valid case. Raises InputError as read_surface, mesh_patches and check_shell,
/// for a region that the part does not have, and as element_thickness.
[[nodiscard]] MoldingPart make_part(const PartChoices& part);

/// Makes all of a part but its mesh: gates and places.
[[nodiscard]] MoldingPart part_around(const PartChoices& part);

}  // namespace fiberfate
