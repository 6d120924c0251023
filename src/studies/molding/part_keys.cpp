// The keys of the study molding that are about the part.
#include "keys/text_keys.hpp"
#include "studies/molding/part.hpp"

namespace fiberfate {
namespace {

/// Sizes of parts, of their walls and of what lies on them, m: below a tenth of a millimetre and a micrometre
/// nothing is molded, and meshers fail.
const Range sizes = Range::between(1e-4, 100);
const Range walls = Range::between(1e-6, 0.1);

/// Lets a member of the drawing serve as one of the whole part.
template <class Member>
constexpr Member PartChoices::*drawn(Member PartOutline::*member) {
  return member;
}

/// The unit of the file, which may be told as a unit alone, "mm", or as a length.
KeyRow<PartChoices> file_unit_key() {
  const auto add = [](KeyTable& table, const std::string& name, PartChoices& part) {
    const Units units = {"m", "mm"};
    const Range range = Range::positive(1e3);
    const auto read = [&part, units, range](const TomlValue& value) -> std::vector<Complaint> {
      TomlValue whole = value;
      auto* text = std::get_if<std::string>(&whole.data);
      const bool is_alone = text != nullptr && text->find_first_of("0123456789") == std::string::npos;
      if (is_alone) *text = "1 " + *text;
      const Reading<double> reading = read_quantity(whole, units, range);
      if (const auto* complaint = std::get_if<Complaint>(&reading)) return {*complaint};
      part.file_unit = std::get<double>(reading);
      return {};
    };
    const auto write = [&part, units](NumberStyle style) {
      return write_quantity(part.file_unit, units, style);
    };
    KeyNotes notes = {.text = "Length of one unit in that file, or the unit alone, \"mm\".",
                      .unit = units.si,
                      .friendly = units.friendly,
                      .range = range};
    table.add({name, std::move(notes), "quantity", {}, read, write});
  };
  return {"file_unit", add};
}

KeyRows<PartChoices> source_keys() {
  using Part = PartChoices;
  const Choices<PartKind> kinds = {
      {PartKind::file, "file", "a mesh of its middle surface"},
      {PartKind::plaque, "plaque", "a rectangle, 0 to length along x, 0 to width along y"},
      {PartKind::disc, "disc", "a disc about the origin"},
      {PartKind::frame, "frame", "a rectangle with an opening in its middle"},
      {PartKind::ribbed, "ribbed", "a rectangle with upright ribs along x"},
      {PartKind::tailgate, "tailgate", "a bent shell with a window and nine gates G1 to G9"}};
  const Choices<Junctions> junctions = {
      {Junctions::refused, "refused", "more than two triangles at an edge are an error"},
      {Junctions::allowed, "allowed", "walls may meet, as ribs and plates do"}};
  return {
      key("kind", drawn(&Part::kind), kinds, "What the part is."),
      file_key("file", &Part::file,
               "Mesh of triangles, .msh (Gmsh) or .stl, of the middle surface, for kind = \"file\"."),
      file_unit_key(),
      key("junctions", &Part::junctions, junctions,
          "Whether more than two walls may meet along a line in that file."),
  };
}

KeyRows<PartChoices> thickness_keys() {
  using Part = PartChoices;
  const Column thickness = {"thickness", {"m", "mm"}, walls};
  const std::vector<Column> profile = {{"x", {"m", "mm"}, Range::between(-100, 100)},
                                       {"factor", {"1", "1"}, Range::positive(100)}};
  return {
      key("thickness", drawn(&Part::thickness), {"m", "mm"}, walls, "Thickness of the wall.",
          usual("\"2 mm\""), "thesis table 10"),
      items_key("thicknesses", &Part::thicknesses,
                number_rows("region", thickness, {"not a row of a region and a thickness", 1, 1}),
                "Rows [region, thickness] of regions with a thickness of their own.",
                optional(R"([["rib", "1.2 mm"]])")),
      file_key("thickness_file", &Part::thickness_file,
               "Table of the thickness of every triangle of a mesh from a file, instead of thickness: "
               "rows of the element's number in that file (in an .stl, counted from 1) and the "
               "thickness in units of file_unit."),
      text_key("thickness_data", &Part::thickness_data, "name",
               "Name of $ElementData in the .msh file that hold the thickness of every triangle, in "
               "units of file_unit.",
               optional("\"thickness\"")),
      rows_key("thickness_profile", &Part::thickness_profile, profile,
               "Rows [x, factor]: the thickness times a factor that is linear between the rows, for parts "
               "whose thickness changes along x.",
               optional(R"([["0 mm", 1], ["305 mm", 0.5]])")),
  };
}

KeyRows<PartChoices> shape_keys() {
  using Part = PartChoices;
  return {
      key("length", drawn(&Part::length), {"m", "mm"}, sizes, "Length along x, of plaque, frame and ribbed.",
          usual("\"305 mm\"")),
      key("width", drawn(&Part::width), {"m", "mm"}, sizes, "Width along y, of plaque, frame and ribbed.",
          usual("\"102 mm\"")),
      key("diameter", drawn(&Part::diameter), {"m", "mm"}, sizes, "Diameter, of disc."),
      key("opening_length", drawn(&Part::opening_length), {"m", "mm"}, sizes,
          "Length of the opening in the middle of a frame."),
      key("opening_width", drawn(&Part::opening_width), {"m", "mm"}, sizes, "Width of the opening."),
      key("ribs", drawn(&Part::ribs), {}, Range::between(1, 100), "Number of ribs along x, of ribbed."),
      key("rib_height", drawn(&Part::rib_height), {"m", "mm"}, Range::between(1e-4, 1),
          "Height of the ribs; their thickness is that of region \"rib\"."),
      key("volume", drawn(&Part::volume), {"m^3", "cm^3"}, Range::between(2e-3, 2e-2),
          "Volume of the tailgate; with the thickness it sets the height.", {}, "thesis table 15: 4933 cm^3"),
      key("bend_radius", drawn(&Part::bend_radius), {"m", "mm"}, sizes,
          "Rolls a flat part onto a cylinder of this radius along x; lengths stay what they are."),
      key("mesh_size", drawn(&Part::mesh_size), {"m", "mm"}, Range::between(1e-5, 1),
          "Edge length of the triangles with which a described part is meshed."),
  };
}

KeyRows<PartChoices> gate_keys() {
  using Part = PartChoices;
  const Choices<PartGate> gates = {{PartGate::edge, "edge", "a film along the edge x = 0"},
                                   {PartGate::fan, "fan", "a fan in front of the edge x = 0, region \"fan\""},
                                   {PartGate::pin, "pin", "a round gate in the middle of the edge x = 0"},
                                   {PartGate::centre, "centre", "a round gate in the middle of the part"},
                                   {PartGate::given, "given", "none of the part's own: [gates] gives them"}};
  return {
      key("gate", drawn(&Part::gate), gates,
          "Where melt enters. A disc has its gate in the centre, a tailgate has nine, unless given."),
      key("gate_width", drawn(&Part::gate_width), {"m", "mm"}, sizes,
          "Width of an edge gate, or of a fan's entry; not given: the whole edge."),
      key("gate_radius", drawn(&Part::gate_radius), {"m", "mm"}, Range::between(1e-6, 1),
          "Radius of a round gate."),
      key("fan_length", drawn(&Part::fan_length), {"m", "mm"}, Range::between(1e-4, 10),
          "Length of the fan."),
      key("fan_thickness", &Part::fan_thickness, {"m", "mm"}, walls,
          "Thickness of the fan at its entry; it falls to that of the part."),
  };
}

}  // namespace

void describe_part(KeyTable& table, PartChoices& part) {
  const KeyGroup<PartChoices> keys = {
      "part", "The part: a shell that is described here and meshed, or read from a file.",
      joined<PartChoices>({source_keys(), thickness_keys(), shape_keys(), gate_keys()})};
  describe(table, keys, part);
}

}  // namespace fiberfate
