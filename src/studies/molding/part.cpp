// Reads [part] and makes the shell.
#include "studies/molding/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "io/patch_mesher.hpp"
#include "io/surface_file.hpp"
#include "keys/text_keys.hpp"
#include "keys/text_rows.hpp"
#include "studies/molding/element_thickness.hpp"

namespace fiberfate {
namespace {

constexpr double most_triangles = 4e6;

/// Sizes of parts, of their walls and of what lies on them, m: below a tenth of a millimetre and a micrometre
/// nothing is molded, and meshers fail.
const Range sizes = Range::between(1e-4, 100);
const Range walls = Range::between(1e-6, 0.1);

void describe_shape(KeyTable& table, PartChoices& part) {
  const auto length = [&table](const char* key, std::optional<double>& member, const char* text,
                               const char* example = "", Need need = Need::optional) {
    table.quantity(
        std::string("part.") + key, member,
        {.text = text, .unit = "m", .friendly = "mm", .range = sizes, .need = need, .example = example});
  };
  length("length", part.length, "Length along x, of plaque, frame and ribbed.", "\"305 mm\"", Need::usual);
  length("width", part.width, "Width along y, of plaque, frame and ribbed.", "\"102 mm\"", Need::usual);
  length("diameter", part.diameter, "Diameter, of disc.");
  length("opening_length", part.opening_length, "Length of the opening in the middle of a frame.");
  length("opening_width", part.opening_width, "Width of the opening.");
  table.count("part.ribs", part.ribs,
              {.text = "Number of ribs along x, of ribbed.", .range = Range::between(1, 100)});
  table.quantity("part.rib_height", part.rib_height,
                 {.text = "Height of the ribs; their thickness is that of region \"rib\".",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::between(1e-4, 1)});
  table.quantity("part.volume", part.volume,
                 {.text = "Volume of the tailgate; with the thickness it sets the height.",
                  .unit = "m^3",
                  .friendly = "cm^3",
                  .range = Range::between(2e-3, 2e-2),
                  .source = "thesis table 15: 4933 cm^3"});
  length("bend_radius", part.bend_radius,
         "Rolls a flat part onto a cylinder of this radius along x; lengths stay what they are.");
}

void describe_gate(KeyTable& table, PartChoices& part) {
  table.choice(
      "part.gate", part.gate,
      {{PartGate::edge, "edge", "a film along the edge x = 0"},
       {PartGate::fan, "fan", "a fan in front of the edge x = 0, region \"fan\""},
       {PartGate::pin, "pin", "a round gate in the middle of the edge x = 0"},
       {PartGate::centre, "centre", "a round gate in the middle of the part"},
       {PartGate::given, "given", "none of the part's own: [gates] gives them"}},
      {.text = "Where melt enters. A disc has its gate in the centre, a tailgate has nine, unless given."});
  table.quantity("part.gate_width", part.gate_width,
                 {.text = "Width of an edge gate, or of a fan's entry; not given: the whole edge.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = sizes});
  table.quantity(
      "part.gate_radius", part.gate_radius,
      {.text = "Radius of a round gate.", .unit = "m", .friendly = "mm", .range = Range::between(1e-6, 1)});
  table.quantity(
      "part.fan_length", part.fan_length,
      {.text = "Length of the fan.", .unit = "m", .friendly = "mm", .range = Range::between(1e-4, 10)});
  table.quantity("part.fan_thickness", part.fan_thickness,
                 {.text = "Thickness of the fan at its entry; it falls to that of the part.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = walls});
}

void describe_thickness(KeyTable& table, PartChoices& part) {
  table.quantity("part.thickness", part.thickness,
                 {.text = "Thickness of the wall.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = walls,
                  .need = Need::usual,
                  .example = "\"2 mm\"",
                  .source = "thesis table 10"});
  describe_text_rows(table, "part.thicknesses",
                     {.text = "Rows [region, thickness] of regions with a thickness of their own.",
                      .example = R"([["rib", "1.2 mm"]])"},
                     {[&part](const std::vector<TomlValue>& row) -> std::optional<Complaint> {
                        const RowTexts texts(row);
                        if (texts.count() != 2 || texts.text(0).empty())
                          return Complaint{"not a row of a region and a thickness", ""};
                        const Reading<double> thickness = read_quantity(row[1], {"m", "mm"}, walls);
                        if (const auto* complaint = std::get_if<Complaint>(&thickness)) return *complaint;
                        part.thicknesses.push_back({texts.text(0), std::get<double>(thickness)});
                        return std::nullopt;
                      },
                      [&part] { part.thicknesses.clear(); },
                      [&part](NumberStyle style) {
                        std::vector<std::string> rows;
                        for (const RegionThickness& one : part.thicknesses)
                          rows.push_back(write_list(
                              {write_text(one.region), write_quantity(one.thickness, {"m", "mm"}, style)}));
                        return rows;
                      }});
  table.file("part.thickness_file", part.thickness_file,
             {.text = "Table of the thickness of every triangle of a mesh from a file, instead of thickness: "
                      "rows of the element's number in that file (in an .stl, counted from 1) and the "
                      "thickness in units of file_unit."});
  describe_text(
      table, "part.thickness_data", part.thickness_data, "name",
      {.text = "Name of $ElementData in the .msh file that hold the thickness of every triangle, in "
               "units of file_unit.",
       .example = "\"thickness\""});
  table.rows(
      "part.thickness_profile", part.thickness_profile,
      {{"x", {"m", "mm"}, Range::between(-100, 100)}, {"factor", {"1", "1"}, Range::positive(100)}},
      {.text = "Rows [x, factor]: the thickness times a factor that is linear between the rows, for parts "
               "whose thickness changes along x.",
       .example = R"([["0 mm", 1], ["305 mm", 0.5]])"});
}

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
  for (const RegionThickness& one : part.thicknesses) {
    const auto found = std::find(flat.region_names.begin(), flat.region_names.end(), one.region);
    if (found == flat.region_names.end())
      throw InputError(
          {{"", 0, 0, "part.thicknesses", "", fmt::format("the part has no region \"{}\"", one.region),
            fmt::format("its regions are {}", fmt::join(flat.region_names, ", "))}});
    by_region[static_cast<std::size_t>(found - flat.region_names.begin())] = one.thickness;
  }
  for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
    const auto region = static_cast<std::size_t>(flat.regions[t]);
    double x = 0;
    for (const Index node : flat.triangles[t]) x += flat.points[static_cast<std::size_t>(node)].x() / 3;
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

/// Refuses the surface of a solid: every edge of it belongs to two triangles, which no shell with an edge
/// has.
void refuse_closed_skin(const Shell& shell) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& [a, b, c] : shell.triangles)
    for (const auto& edge : {std::minmax({a, b}), std::minmax({b, c}), std::minmax({c, a})}) ++edges[edge];
  const bool open =
      std::any_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 1; });
  if (!open)
    throw InputError("the surface is closed: it is the skin of a solid, not the middle surface of a wall",
                     "export the middle surface of the part and give its thickness");
}

/// About how many triangles a part will have; 0 for files.
double foreseen_triangles(const PartChoices& part) {
  double area = part.length.value_or(0) * part.width.value_or(0);
  if (part.kind == PartKind::disc) area = 0.785 * part.diameter.value_or(0) * part.diameter.value_or(0);
  if (part.kind == PartKind::tailgate) area = part.volume.value_or(0) / part.thickness.value_or(1);
  return part.kind == PartKind::file ? 0 : 2.3 * area / (part.mesh_size * part.mesh_size);
}

/// Adds the unit of the file, which may be told as a unit alone, "mm", or as a length.
void describe_file_unit(KeyTable& table, double& unit) {
  const Units units = {"m", "mm"};
  const Range range = Range::positive(1e3);
  const auto read = [&unit, units, range](const TomlValue& value) -> std::vector<Complaint> {
    TomlValue whole = value;
    auto* text = std::get_if<std::string>(&whole.data);
    const bool is_alone = text != nullptr && text->find_first_of("0123456789") == std::string::npos;
    if (is_alone) *text = "1 " + *text;
    const Reading<double> reading = read_quantity(whole, units, range);
    if (const auto* complaint = std::get_if<Complaint>(&reading)) return {*complaint};
    unit = std::get<double>(reading);
    return {};
  };
  const auto write = [&unit, units](NumberStyle style) { return write_quantity(unit, units, style); };
  KeyNotes notes = {.text = "Length of one unit in that file, or the unit alone, \"mm\".",
                    .unit = "m",
                    .friendly = "mm",
                    .range = range};
  table.add({"part.file_unit", std::move(notes), "quantity", {}, read, write});
}

}  // namespace

void describe_part(KeyTable& table, PartChoices& part) {
  table.section("part", "The part: a shell that is described here and meshed, or read from a file.");
  table.choice("part.kind", part.kind,
               {{PartKind::file, "file", "a mesh of its middle surface"},
                {PartKind::plaque, "plaque", "a rectangle, 0 to length along x, 0 to width along y"},
                {PartKind::disc, "disc", "a disc about the origin"},
                {PartKind::frame, "frame", "a rectangle with an opening in its middle"},
                {PartKind::ribbed, "ribbed", "a rectangle with upright ribs along x"},
                {PartKind::tailgate, "tailgate", "a bent shell with a window and nine gates G1 to G9"}},
               {.text = "What the part is."});
  table.file("part.file", part.file,
             {.text = "Mesh of triangles, .msh (Gmsh) or .stl, of the middle surface, for kind = \"file\"."});
  describe_file_unit(table, part.file_unit);
  table.choice("part.junctions", part.junctions,
               {{Junctions::refused, "refused", "more than two triangles at an edge are an error"},
                {Junctions::allowed, "allowed", "walls may meet, as ribs and plates do"}},
               {.text = "Whether more than two walls may meet along a line in that file."});
  describe_thickness(table, part);
  describe_shape(table, part);
  table.quantity("part.mesh_size", part.mesh_size,
                 {.text = "Edge length of the triangles with which a described part is meshed.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::between(1e-5, 1)});
  describe_gate(table, part);
}

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

namespace {

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

}  // namespace

MoldingPart part_around(const PartChoices& part) {
  return part.kind == PartKind::file ? MoldingPart{} : placed(draw_part(part));
}

MoldingPart make_part(const PartChoices& part) {
  MoldingPart made;
  SurfaceMesh mesh;
  std::vector<Vec3> nodes;
  if (part.kind == PartKind::file) {
    mesh = read_surface(part.file, part.file_unit);
    made.remarks = mesh.remarks;
    nodes = mesh.points;
  } else {
    const PartShape shape = draw_part(part);
    made = placed(shape);
    mesh = mesh_patches(shape.surface);
    for (const Vec3& point : mesh.points) nodes.push_back(shape.place(point));
  }
  made.shell.nodes = std::move(nodes);
  made.shell.triangles = mesh.triangles;
  made.shell.region.assign(mesh.regions.begin(), mesh.regions.end());
  made.shell.junctions = part.kind == PartKind::ribbed ? Junctions::allowed : part.junctions;
  set_thickness(part, mesh, made.shell);
  made.regions = mesh.region_names;
  refuse_closed_skin(made.shell);
  return made;
}

}  // namespace fiberfate
