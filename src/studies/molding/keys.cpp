// Describes the keys of the study molding.
#include <fmt/format.h>

#include "microstructure/closure.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {
namespace {

void describe_lengths(KeyTable& table, MoldingFiberChoices& fibers) {
  const auto length = [&table](const char* key, std::optional<double>& member, const char* text,
                               const char* example, Need need) {
    table.quantity(std::string("fibers.") + key, member,
                   {.text = text,
                    .unit = "m",
                    .friendly = "mm",
                    .range = Range::positive(1),
                    .need = need,
                    .example = example,
                    .source = "thesis 4.3"});
  };
  length("length", fibers.length, "One length of all fibers at the gates.", "\"2 mm\"", Need::usual);
  table.rows("fibers.distribution", fibers.distribution,
             {{"length", {"m", "mm"}, Range::positive(1)}, {"number", {"1", "1"}, Range::not_negative()}},
             {.text = "Classes at the gates: rows [length, number of fibers], or the path of a file with "
                      "such rows in SI. "
                      "Every class follows the length law by itself.",
              .example = R"([["0.5 mm", 120], ["1 mm", 60], ["5 mm", 4]])",
              .source = "thesis 4.4, table 12"});
  length("number_average", fibers.number_average, "L_N at the gates, followed by itself beside L_W.", "",
         Need::optional);
  length("weight_average", fibers.weight_average, "L_W at the gates.", "", Need::optional);
  table.choice("fibers.weight", fibers.weight,
               {{ClassWeight::length, "length", "the fiber length of the class: nothing is lost"},
                {ClassWeight::number, "number", "the number of its fibers, as the thesis"}},
               {.text = "What a class keeps while it becomes shorter; not for phelps and durin."});
}

void describe_fibers(KeyTable& table, MoldingFiberChoices& fibers) {
  table.section("fibers", "The fibers that come in; give length, distribution, or both mean lengths.");
  describe_lengths(table, fibers);
  table.quantity("fibers.diameter", fibers.diameter,
                 {.text = "Diameter.", .unit = "m", .friendly = "um", .range = Range::positive(1e-3)});
  table.quantity("fibers.volume_fraction", fibers.volume_fraction,
                 {.text = "Share of the volume that is fiber.",
                  .range = Range::inside(0, 1),
                  .need = Need::required,
                  .example = "0.13"});
  std::vector<std::pair<std::string, std::string>> names;
  for (const ClosureDescription& closure : closures()) names.emplace_back(closure.name, closure.meaning);
  describe_name(table, "fibers.closure", fibers.closure, std::move(names),
                {.text = "How A4 is made from A2."});
  table.orientation("fibers.inlet_orientation", fibers.inlet_orientation,
                    {.text = "A2 at the gates, in the axes that inlet_axes names."});
  table.choice("fibers.inlet_axes", fibers.inlet_axes,
               {{InletAxes::flow, "flow",
                 "1 along the flow out of the gate, 2 across it in the surface, 3 across the wall"},
                {InletAxes::part, "part", "the axes of the part"}},
               {.text = "Axes of inlet_orientation."});
  table.choice(
      "fibers.coupling", fibers.coupling,
      {{CouplingChoice::none, "none",
        "the flow does not feel the fibers; [melt] is the viscosity of the compound"},
       {CouplingChoice::informed_isotropic, "informed_isotropic",
        "viscosity from orientation and length; [melt] is the viscosity of the matrix"}},
      {.text = "How the flow feels the fibers.", .source = "Favaloro, Tseng, Pipes 2018; thesis 2.11"});
  table.quantity(
      "fibers.trouton_term", fibers.trouton_term,
      {.text = "R of the coupled viscosity eta (1 + R (D:A4:D)/(D:D)) for fibers of trouton_length; it "
               "goes with the square of their length. Not given: phi N_p, semi-dilute, which "
               "overestimates long fibers.",
       .range = Range::between(0, 1e6),
       .source = "thesis 2.11, 2.12"});
  table.quantity("fibers.trouton_length", fibers.trouton_length,
                 {.text = "Length of the fibers for which trouton_term holds; not given: that at the gates.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(1)});
  table.choice("fibers.drag", fibers.drag,
               {{DragViscosity::matrix, "matrix", "that of the melt between them"},
                {DragViscosity::suspension, "suspension",
                 "that of the melt with them, as a user routine is given it by a filling program"}},
               {.text = "Viscosity that the length laws take where the flow feels the fibers."});
}

void describe_composite(KeyTable& table, CompositeChoices& composite) {
  table.section("composite", "Properties of the solid, for stiffness and thermal expansion.");
  table.choice("composite.model", composite.model, stiffness_choices(),
               {.text = "Model of aligned fibers (docs/theory/properties.md)."});
  const auto modulus = [&table](const char* key, double& member, const char* text) {
    table.quantity(std::string("composite.") + key, member,
                   {.text = text, .unit = "Pa", .friendly = "GPa", .range = Range::positive(1e13)});
  };
  const auto ratio = [&table](const char* key, double& member, const char* text) {
    table.quantity(std::string("composite.") + key, member, {.text = text, .range = Range::inside(-1, 0.5)});
  };
  const auto expansion = [&table](const char* key, double& member, const char* text) {
    table.quantity(std::string("composite.") + key, member,
                   {.text = text, .unit = "1/K", .range = Range::between(-1e-3, 1e-2)});
  };
  modulus("fiber_modulus", composite.fiber.modulus, "Young's modulus of the fibers.");
  ratio("fiber_poisson", composite.fiber.poisson, "Poisson's ratio of the fibers.");
  expansion("fiber_expansion", composite.fiber_expansion, "Thermal expansion of the fibers.");
  modulus("matrix_modulus", composite.matrix.modulus, "Young's modulus of the solid matrix.");
  ratio("matrix_poisson", composite.matrix.poisson, "Poisson's ratio of the matrix.");
  expansion("matrix_expansion", composite.matrix_expansion, "Thermal expansion of the matrix.");
}

std::optional<Complaint> append_measured(const std::vector<TomlValue>& row,
                                         std::vector<MeasuredLength>& measured) {
  const RowTexts texts(row);
  if (texts.count() != 3 || (texts.text(1) != "L_N" && texts.text(1) != "L_W"))
    return Complaint{"not a place, L_N or L_W, and a length", ""};
  const Reading<double> length = read_quantity(row[2], {"m", "mm"}, Range::positive(1));
  if (const auto* complaint = std::get_if<Complaint>(&length)) return *complaint;
  measured.push_back({texts.text(0),
                      texts.text(1) == "L_N" ? MeasuredMean::number_average : MeasuredMean::weight_average,
                      std::get<double>(length)});
  return std::nullopt;
}

void describe_sweep(KeyTable& table, MoldingSweep& sweep) {
  table.section("sweep",
                "Several values of one parameter of [law], all in one filling, and measured lengths.");
  std::vector<std::pair<std::string, std::string>> names;
  for (const LawMenuItem& law : attrition_menu())
    for (const LawParameter& parameter : law.parameters)
      if (std::none_of(names.begin(), names.end(),
                       [&](const auto& one) { return one.first == parameter.name; }))
        names.emplace_back(parameter.name, parameter.meaning);
  describe_name(table, "sweep.parameter", sweep.parameter, std::move(names),
                {.text = "The parameter; not given: no sweep.", .example = "\"xi\""});
  table.quantity("sweep.lower", sweep.lower, {.text = "Least value, in the SI unit of the parameter."});
  table.quantity("sweep.upper", sweep.upper, {.text = "Greatest value."});
  table.count("sweep.count", sweep.count, {.text = "Number of values.", .range = Range::between(3, 200)});
  table.choice("sweep.spacing", sweep.spacing,
               {{ParameterScale::logarithmic, "logarithmic", "equal ratios"},
                {ParameterScale::linear, "linear", "equal steps"}},
               {.text = "How the values are spaced."});
  describe_text_rows(
      table, "sweep.measured",
      {.text = "Rows [place, \"L_N\" or \"L_W\", length] of measured mean lengths at output.places; a place "
               "may have "
               "several. The average error (4.8) of every value and the optimum are told.",
       .example = R"([["Loc.1", "L_N", "0.9 mm"]])",
       .source = "thesis 4.7, 4.8"},
      {[&sweep](const std::vector<TomlValue>& row) { return append_measured(row, sweep.measured); },
       [&sweep] { sweep.measured.clear(); },
       [&sweep](NumberStyle style) {
         std::vector<std::string> rows;
         for (const MeasuredLength& one : sweep.measured)
           rows.push_back(write_list({write_text(one.place),
                                      write_text(one.mean == MeasuredMean::number_average ? "L_N" : "L_W"),
                                      write_quantity(one.length, {"m", "mm"}, style)}));
         return rows;
       }});
}

void describe_numerics(KeyTable& table, FillingNumerics& numerics) {
  table.section("numerics", "How finely to compute.");
  table.count("numerics.layers", numerics.layers,
              {.text = "Layers in the full gap, even; half of them are computed, by symmetry.",
               .range = Range::between(4, 128)});
  table.quantity("numerics.wall_width_ratio", numerics.wall_width_ratio,
                 {.text = "Width of the layer at the wall over that at the mid-plane.",
                  .range = Range{0, 1, Range::Ends::open_low}});
  table.quantity("numerics.middle_width_ratio", numerics.middle_width_ratio,
                 {.text = "Share of its width that the layer at the mid-plane gets; 0.25 lets it show the "
                          "mid-plane itself (docs/theory/molding.md).",
                  .range = Range{0, 1, Range::Ends::open_low}});
  table.count("numerics.steps", numerics.steps,
              {.text = "Steps to aim at.", .range = Range::between(10, 100000)});
  table.choice(
      "numerics.heat", numerics.heat,
      {{HeatModel::full, "full", "convection, conduction across the gap, viscous heating, fountain flow"},
       {HeatModel::none, "none", "everywhere the temperature of the melt at the gates"}},
      {.text = "Whether the temperature is solved for."});
  table.quantity("numerics.viscosity_tolerance", numerics.viscosity_tolerance,
                 {.text = "Largest relative change of a node's fluidity that ends iterating.",
                  .range = Range::positive(1)});
  table.count("numerics.most_iterations", numerics.most_iterations,
              {.text = "Most solutions of the pressure in a step.", .range = Range::between(1, 1000)});
  table.quantity("numerics.orientation_tolerance", numerics.orientation_tolerance,
                 {.text = "Error of A2 in one step.", .range = Range::positive(1)});
}

void describe_output(KeyTable& table, MoldingCase& values) {
  table.section("output", "What is kept.");
  table.count("output.frames", values.output.frames,
              {.text = "Frames of result.vtkhdf, at equal shares of the filled volume.",
               .range = Range::between(1, 1000)});
  describe_places(
      table, "output.places", values.output.places, PlaceLines::no,
      {.text =
           "Named places, rows [name, x, y] in the flat part or [name, x, y, z], for profiles across the gap "
           "and mean lengths.",
       .example = R"([["Loc.1", "30 mm", "51 mm"]])",
       .source = "thesis figures 4.4, 4.18"});
  table.quantity("output.place_radius", values.output.place_radius,
                 {.text = "Values at a place are averages over this radius, as of a sample cut out; at least "
                          "the nearest node.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::between(0, 1)});
  table.quantity("output.checkpoint_interval", values.output.checkpoint_interval,
                 {.text = "Wall time between checkpoints.", .unit = "s", .range = Range::positive()});
  table.section("run", "How it runs.");
  table.count("run.threads", values.threads,
              {.text = "Threads; 0 takes all processors. Results do not depend on it.",
               .range = Range::between(0, 4096)});
}

}  // namespace

void describe_molding(KeyTable& table, MoldingCase& values) {
  describe_part(table, values.part);
  describe_gates(table, values.gates);
  describe_material(table, values.material);
  describe_law(table, viscosity_menu(),
               {"melt", "Viscosity (docs/theory/viscosity.md).", "\"cross_wlf\"", Need::required},
               values.melt);
  describe_machine(table, values.machine);
  describe_fibers(table, values.fibers);
  describe_law(table, orientation_menu(),
               {"orientation", "How fibers orient (docs/theory/orientation.md); no name: they do not.",
                "\"iard_rpr\"", Need::usual},
               values.orientation);
  describe_law(table, attrition_menu(),
               {"law", "How fibers break (docs/theory/length.md); no name: they do not.",
                "\"unbreakable_length\"", Need::usual},
               values.law);
  describe_law(
      table, attrition_menu(),
      {"compare", "A second length law in the same filling, for comparison.", "\"phelps\"", Need::optional},
      values.compared);
  describe_composite(table, values.composite);
  describe_sweep(table, values.sweep);
  describe_numerics(table, values.numerics);
  describe_output(table, values);
}

}  // namespace fiberfate
