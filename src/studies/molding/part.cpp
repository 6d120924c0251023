// Checks [part] and makes the shell.
#include "studies/molding/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <utility>

#include "base/error.hpp"
#include "base/timer.hpp"
#include "io/patch_mesher.hpp"
#include "io/surface_file.hpp"
#include "studies/molding/element_thickness.hpp"

namespace fiberfate {
namespace {

constexpr double most_triangles = 4e6;

/// Gives the factor of the profile at x; the first and last rows hold beyond the ends.
double profile_factor(const std::vector<std::vector<double>>& rows, double x) {
  if (rows.empty()) return 1;
  if (x <= rows.front()[0]) return rows.front()[1];
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (x <= rows[i][0])
      return std::lerp(rows[i - 1][1], rows[i][1], (x - rows[i - 1][0]) / (rows[i][0] - rows[i - 1][0]));
  return rows.back()[1];
}

/// Gives every triangle its thickness; `flat` are the points before they were bent.
void set_thickness(const PartChoices& part, const SurfaceMesh& flat, Shell& shell) {
  if (has_element_thickness(part)) {
    shell.thickness = element_thickness(part, flat);
    return;
  }
  std::vector<double> by_region(flat.region_names.size(), *part.thickness);
  for (const NamedNumbers& one : part.thicknesses) {
    const auto found = std::ranges::find(flat.region_names, one.name);
    if (found == flat.region_names.end())
      throw InputError(
          {{"", 0, 0, "part.thicknesses", "", fmt::format("the part has no region \"{}\"", one.name),
            fmt::format("its regions are {}", fmt::join(flat.region_names, ", "))}});
    by_region[found - flat.region_names.begin()] = one.numbers[0];
  }
  for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
    const std::size_t region = flat.regions[t];
    double x = 0;
    for (const Index node : flat.triangles[t]) x += flat.points[node].x() / 3;
    double thickness = by_region[region] * profile_factor(part.thickness_profile, x);
    if (flat.region_names[region] == "fan" && x < 0)
      thickness = std::lerp(*part.thickness, part.fan_thickness, std::min(1.0, -x / part.fan_length));
    shell.thickness.push_back(thickness);
  }
}

/// Finds what contradicts what of all that thicknesses may come from.
void validate_thickness(const PartChoices& part, CaseChecker& checker) {
  if (!has_element_thickness(part)) {
    if (!part.thickness)
      checker.error("part.thickness", "not given; the walls need it",
                    "add thickness = \"2 mm\" under [part]");
    return;
  }
  checker.warn_unused({"part.thickness", "part.thicknesses", "part.thickness_profile"},
                      "parts without thicknesses by element");
  const std::string key = part.thickness_file.empty() ? "part.thickness_data" : "part.thickness_file";
  if (part.kind != PartKind::file)
    checker.error(key, "only elements of a mesh from a file have numbers",
                  "give kind = \"file\", or thickness, thicknesses and thickness_profile");
  if (!part.thickness_file.empty() && !part.thickness_data.empty())
    checker.error("part.thickness_data", "thicknesses by element are given in two ways",
                  "leave it or part.thickness_file out");
  if (!part.thickness_file.empty()) checker.check_file("part.thickness_file", part.thickness_file);
}

void require_rows_to_rise(const PartChoices& part, CaseChecker& checker) {
  for (std::size_t i = 1; i < part.thickness_profile.size(); ++i)
    if (!(part.thickness_profile[i][0] > part.thickness_profile[i - 1][0]))
      checker.error_in_row("part.thickness_profile", i,
                           fmt::format("x of row {} is not larger than that of row {}", i + 1, i),
                           "sort the rows by x");
}

/// About how many triangles a part will have; 0 for files.
double foreseen_triangles(const PartChoices& part) {
  double area = part.length.value_or(0) * part.width.value_or(0);
  if (part.kind == PartKind::disc) area = 0.785 * part.diameter.value_or(0) * part.diameter.value_or(0);
  if (part.kind == PartKind::tailgate) area = part.volume.value_or(0) / part.thickness.value_or(1);
  return part.kind == PartKind::file ? 0 : 2.3 * area / (part.mesh_size * part.mesh_size);
}

/// Puts a drawing's gates into space and keeps how its points get there.
MoldingPart placed(const PartShape& shape) {
  MoldingPart part;
  part.place = [place = shape.place](const Vec2& at) { return place({at.x(), at.y(), 0}); };
  part.gates = shape.gates;
  for (Gate& gate : part.gates) {
    gate.position = shape.place(gate.position);
    if (gate.end) gate.end = shape.place(*gate.end);
  }
  return part;
}

struct MeshedDrawing {
  PatchedSurface drawing;
  SurfaceMesh mesh;
  double seconds = 0;
};

/// Meshes a drawing, or gives the mesh that one of the last drawings got: a case is checked, estimated and
/// run with one part, and several cases of a calibration share it.
MeshedDrawing meshed(const PatchedSurface& drawing) {
  constexpr std::size_t most_kept = 8;
  static std::mutex one_at_a_time;
  static std::deque<MeshedDrawing> kept;
  const std::scoped_lock lock(one_at_a_time);
  const auto found = std::ranges::find(kept, drawing, &MeshedDrawing::drawing);
  if (found != kept.end()) return *found;
  const double begin = wall_seconds();  // it is meshed in another process
  SurfaceMesh mesh = mesh_patches(drawing);
  kept.push_back({drawing, std::move(mesh), wall_seconds() - begin});
  if (kept.size() > most_kept) kept.pop_front();
  return kept.back();
}

}  // namespace

void validate_part(const PartChoices& part, CaseChecker& checker) {
  const auto require = [&checker](const std::string& key, const std::string& remedy) {
    if (!checker.is_given(key)) checker.error(key, "not given; this kind of part needs it", remedy);
  };
  const bool rectangle =
      part.kind == PartKind::plaque || part.kind == PartKind::frame || part.kind == PartKind::ribbed;
  if (part.kind == PartKind::file) {
    require("part.file", "add file = \"part.msh\" under [part]");
    if (!part.file.empty()) checker.check_file("part.file", part.file);
    checker.warn_unused({"part.mesh_size", "part.gate", "part.bend_radius"}, "parts that the program meshes");
  } else {
    checker.warn_unused({"part.file", "part.file_unit", "part.junctions"}, "kind = \"file\"");
  }
  if (rectangle) {
    require("part.length", "add length = \"305 mm\" under [part]");
    require("part.width", "add width = \"102 mm\" under [part]");
  } else {
    checker.warn_unused({"part.length", "part.width", "part.gate_width"}, "plaque, frame and ribbed");
  }
  if (part.kind == PartKind::disc) require("part.diameter", "add diameter = \"200 mm\" under [part]");
  if (part.kind == PartKind::tailgate) require("part.volume", "add volume = \"4933 cm^3\" under [part]");
  if (part.kind == PartKind::frame) {
    require("part.opening_length", "add opening_length = \"100 mm\" under [part]");
    require("part.opening_width", "add opening_width = \"40 mm\" under [part]");
    if (part.opening_length && part.length && !(*part.opening_length < *part.length))
      checker.error("part.opening_length", "not less than " + checker.cite("part.length"),
                    "give a smaller opening");
    if (part.opening_width && part.width && !(*part.opening_width < *part.width))
      checker.error("part.opening_width", "not less than " + checker.cite("part.width"),
                    "give a smaller opening");
  }
  validate_thickness(part, checker);
  require_rows_to_rise(part, checker);
  if (checker.is_sound() && foreseen_triangles(part) > most_triangles)
    checker.error("part.mesh_size", fmt::format("makes about {:.2g} triangles", foreseen_triangles(part)),
                  "give a larger size; ten triangles across the narrowest part are usually enough");
}

MoldingPart part_around(const PartChoices& part) {
  return part.kind == PartKind::file ? MoldingPart{} : placed(draw_part(part));
}

MoldingPart make_part(const PartChoices& part) {
  MoldingPart made;
  SurfaceMesh mesh;
  if (part.kind == PartKind::file) {
    const double begin = wall_seconds();
    mesh = read_surface(part.file, part.file_unit);
    made.meshing_s = wall_seconds() - begin;
    made.remarks = mesh.remarks;
    made.shell.nodes = mesh.points;
  } else {
    const PartShape shape = draw_part(part);
    made = placed(shape);
    MeshedDrawing drawn = meshed(shape.surface);
    mesh = std::move(drawn.mesh);
    made.meshing_s = drawn.seconds;
    for (const Vec3& point : mesh.points) made.shell.nodes.push_back(shape.place(point));
  }
  made.shell.triangles = mesh.triangles;
  made.shell.region.assign(mesh.regions.begin(), mesh.regions.end());
  made.shell.junctions = part.kind == PartKind::ribbed ? Junctions::allowed : part.junctions;
  set_thickness(part, mesh, made.shell);
  made.regions = mesh.region_names;
  return made;
}

}  // namespace fiberfate
