// The keys of the study molding.
#include <algorithm>

#include "keys/law_choice.hpp"
#include "studies/length_choices.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {
namespace {

KeyRows<MoldingFiberChoices> length_keys() {
  using Fibers = MoldingFiberChoices;
  const Units units = {"m", "mm"};
  const Range range = Range::positive(1);
  const std::vector<Column> classes = {{"length", units, range},
                                       {"number", {"1", "1"}, Range::not_negative()}};
  const Choices<ClassWeight> weights = {
      {ClassWeight::length, "length", "the fiber length of the class: nothing is lost"},
      {ClassWeight::number, "number", "the number of its fibers, as the thesis"}};
  return {
      key("length", &Fibers::length, units, range, "One length of all fibers at the gates.",
          usual("\"2 mm\""), "thesis 4.3"),
      rows_key("distribution", &Fibers::distribution, classes,
               "Classes at the gates: rows [length, number of fibers], or the path of a file with "
               "such rows in SI. Every class follows the length law by itself.",
               optional(R"([["0.5 mm", 120], ["1 mm", 60], ["5 mm", 4]])"), "thesis 4.4, table 12"),
      key("number_average", &Fibers::number_average, units, range,
          "L_N at the gates, followed by itself beside L_W.", {}, "thesis 4.3"),
      key("weight_average", &Fibers::weight_average, units, range, "L_W at the gates.", {}, "thesis 4.3"),
      key("weight", &Fibers::weight, weights,
          "What a class keeps while it becomes shorter; not for " + laws_of_bins() + "."),
      key("diameter", &Fibers::diameter, {"m", "um"}, Range::positive(1e-3), "Diameter."),
      key("volume_fraction", &Fibers::volume_fraction, {}, Range::inside(0, 1),
          "Share of the volume that is fiber.", required("0.13")),
  };
}

KeyRows<MoldingFiberChoices> orientation_keys() {
  using Fibers = MoldingFiberChoices;
  const Choices<InletAxes> axes = {
      {InletAxes::flow, "flow",
       "1 along the flow out of the gate, 2 across it in the surface, 3 across the wall"},
      {InletAxes::part, "part", "the axes of the part"}};
  return {
      name_key("closure", &Fibers::closure, closure_names(), "How A4 is made from A2."),
      orientation_key("inlet_orientation", &Fibers::inlet_orientation,
                      "A2 at the gates, in the axes that inlet_axes names."),
      key("inlet_axes", &Fibers::inlet_axes, axes, "Axes of inlet_orientation."),
  };
}

KeyRows<MoldingFiberChoices> coupling_keys() {
  using Fibers = MoldingFiberChoices;
  const Choices<CouplingChoice> couplings = {
      {CouplingChoice::none, "none",
       "the flow does not feel the fibers; [melt] is the viscosity of the compound"},
      {CouplingChoice::informed_isotropic, "informed_isotropic",
       "viscosity from orientation and length; [melt] is the viscosity of the matrix"}};
  const Choices<DragViscosity> drags = {
      {DragViscosity::matrix, "matrix", "that of the melt between them"},
      {DragViscosity::suspension, "suspension",
       "that of the melt with them, as a user routine is given it by a filling program"}};
  return {
      key("coupling", &Fibers::coupling, couplings, "How the flow feels the fibers.",
          "Favaloro, Tseng, Pipes 2018; thesis 2.11"),
      key("trouton_term", &Fibers::trouton_term, {}, Range::between(0, 1e6),
          "R of the coupled viscosity eta (1 + R (D:A4:D)/(D:D)) for fibers of trouton_length; it "
          "goes with the square of their length. Not given: phi N_p, semi-dilute, which "
          "overestimates long fibers.",
          {}, "thesis 2.11, 2.12"),
      key("trouton_length", &Fibers::trouton_length, {"m", "mm"}, Range::positive(1),
          "Length of the fibers for which trouton_term holds; not given: that at the gates."),
      key("drag", &Fibers::drag, drags,
          "Viscosity that the length laws take where the flow feels the fibers."),
  };
}

KeyGroup<CompositeChoices> composite_keys() {
  using Composite = CompositeChoices;
  const auto elasticity = [](IsotropicElasticity Composite::*of, const char* modulus,
                             const char* modulus_text, const char* ratio, const char* ratio_text) {
    return rows_of(
        of, {key(modulus, &IsotropicElasticity::modulus, {"Pa", "GPa"}, Range::positive(1e13), modulus_text),
             key(ratio, &IsotropicElasticity::poisson, {}, Range::inside(-1, 0.5), ratio_text)});
  };
  const Range expansions = Range::between(-1e-3, 1e-2);
  return {"composite", "Properties of the solid, for stiffness and thermal expansion.",
          joined<Composite>(
              {{key("model", &Composite::model, stiffness_choices(),
                    "Model of aligned fibers (docs/theory/properties.md).")},
               elasticity(&Composite::fiber, "fiber_modulus", "Young's modulus of the fibers.",
                          "fiber_poisson", "Poisson's ratio of the fibers."),
               {key("fiber_expansion", &Composite::fiber_expansion, {"1/K"}, expansions,
                    "Thermal expansion of the fibers.")},
               elasticity(&Composite::matrix, "matrix_modulus", "Young's modulus of the solid matrix.",
                          "matrix_poisson", "Poisson's ratio of the matrix."),
               {key("matrix_expansion", &Composite::matrix_expansion, {"1/K"}, expansions,
                    "Thermal expansion of the matrix.")}})};
}

Reading<MeasuredLength> read_measured(const std::vector<TomlValue>& row, const std::vector<MeasuredLength>&) {
  const RowTexts texts(row);
  const auto mean = texts.count() == 3 ? length_mean_of(texts.text(1)) : std::nullopt;
  if (!mean) return Complaint{"not a place, L_N or L_W, and a length", ""};
  const Reading<double> length = read_quantity(row[2], {"m", "mm"}, Range::positive(1));
  if (const auto* complaint = std::get_if<Complaint>(&length)) return *complaint;
  return MeasuredLength{texts.text(0), *mean, std::get<double>(length)};
}

std::vector<std::string> write_measured(const MeasuredLength& one, NumberStyle style) {
  return {write_text(one.place), write_text(symbol(one.mean)),
          write_quantity(one.length, {"m", "mm"}, style)};
}

/// The parameters of all laws of length, each once.
NamedTexts length_parameters() {
  NamedTexts names;
  for (const LawMenuItem& law : attrition_menu())
    for (const LawParameter& parameter : law.parameters)
      if (std::ranges::none_of(names, [&](const auto& one) { return one.name == parameter.name; }))
        names.push_back({parameter.name, parameter.meaning});
  return names;
}

KeyGroup<MoldingSweep> sweep_keys() {
  using Sweep = MoldingSweep;
  const Choices<ParameterScale> spacings = {{ParameterScale::logarithmic, "logarithmic", "equal ratios"},
                                            {ParameterScale::linear, "linear", "equal steps"}};
  const KeyRow<Sweep> parameter = {
      "parameter", [](KeyTable& table, const std::string& name, Sweep& sweep) {
        describe_name(table, name, sweep.parameter, length_parameters(),
                      {.text = "The parameter; not given: no sweep.", .example = "\"xi\""});
      }};
  return {"sweep",
          "Several values of one parameter of [law], all in one filling, and measured lengths.",
          {
              parameter,
              key("lower", &Sweep::lower, {}, {}, "Least value, in the SI unit of the parameter."),
              key("upper", &Sweep::upper, {}, {}, "Greatest value."),
              key("count", &Sweep::count, {}, Range::between(3, 200), "Number of values."),
              key("spacing", &Sweep::spacing, spacings, "How the values are spaced."),
              items_key("measured", &Sweep::measured, {read_measured, write_measured},
                        "Rows [place, \"L_N\" or \"L_W\", length] of measured mean lengths at output.places; "
                        "a place may have several. The average error (4.8) of every value and the optimum "
                        "are told.",
                        optional(R"([["Loc.1", "L_N", "0.9 mm"]])"), "thesis 4.7, 4.8"),
          }};
}

KeyGroup<FillingNumerics> numerics_keys() {
  using Numerics = FillingNumerics;
  const Range share = {0, 1, Range::Ends::open_low};
  const Choices<HeatModel> heats = {
      {HeatModel::full, "full", "convection, conduction across the gap, viscous heating, fountain flow"},
      {HeatModel::none, "none", "everywhere the temperature of the melt at the gates"}};
  return {"numerics",
          "How finely to compute.",
          {
              key("layers", &Numerics::layers, {}, Range::between(4, 128),
                  "Layers in the full gap, even; half of them are computed, by symmetry."),
              key("wall_width_ratio", &Numerics::wall_width_ratio, {}, share,
                  "Width of the layer at the wall over that at the mid-plane."),
              key("middle_width_ratio", &Numerics::middle_width_ratio, {}, share,
                  "Share of its width that the layer at the mid-plane gets; 0.25 lets it show the "
                  "mid-plane itself (docs/theory/molding.md)."),
              key("steps", &Numerics::steps, {}, Range::between(10, 100000), "Steps to aim at."),
              key("heat", &Numerics::heat, heats, "Whether the temperature is solved for."),
              key("viscosity_tolerance", &Numerics::viscosity_tolerance, {}, Range::positive(1),
                  "Largest relative change of a node's fluidity that ends iterating."),
              key("most_iterations", &Numerics::most_iterations, {}, Range::between(1, 1000),
                  "Most solutions of the pressure in a step."),
              key("orientation_tolerance", &Numerics::orientation_tolerance, {}, Range::positive(1),
                  "Error of A2 in one step."),
          }};
}

KeyGroup<MoldingOutput> output_keys() {
  using Output = MoldingOutput;
  return {"output",
          "What is kept.",
          {
              key("frames", &Output::frames, {}, Range::between(1, 1000),
                  "Frames of result.vtkhdf, at equal shares of the filled volume."),
              items_key("places", &Output::places, place_rows(),
                        "Named places, rows [name, x, y] in the flat part or [name, x, y, z], for profiles "
                        "across the gap and mean lengths.",
                        optional(R"([["Loc.1", "30 mm", "51 mm"]])"), "thesis figures 4.4, 4.18"),
              key("place_radius", &Output::place_radius, {"m", "mm"}, Range::between(0, 1),
                  "Values at a place are averages over this radius, as of a sample cut out; at least "
                  "the nearest node."),
              key("checkpoint_interval", &Output::checkpoint_interval, {"s"}, Range::positive(),
                  "Wall time between checkpoints."),
          }};
}

}  // namespace

void describe_molding(KeyTable& table, MoldingCase& values) {
  const LawTable melt = {"melt", "Viscosity (docs/theory/viscosity.md).", "\"cross_wlf\"", Need::required};
  const LawTable orientation = {"orientation",
                                "How fibers orient (docs/theory/orientation.md); no name: they do not.",
                                "\"iard_rpr\"", Need::usual};
  const LawTable law = {"law", "How fibers break (docs/theory/length.md); no name: they do not.",
                        "\"unbreakable_length\"", Need::usual};
  const LawTable compare = {"compare", "A second length law in the same filling, for comparison.",
                            "\"phelps\"", Need::optional};
  const KeyGroup<MoldingFiberChoices> fibers = {
      "fibers", "The fibers that come in; give length, distribution, or both mean lengths.",
      joined<MoldingFiberChoices>({length_keys(), orientation_keys(), coupling_keys()})};
  const KeyGroup<RunChoices> run = {"run", "How it runs.", {threads_key()}};
  describe_part(table, values.part);
  describe(table, gate_keys(), values.gates);
  describe(table, material_keys(), values.material);
  describe_law(table, viscosity_menu(), melt, values.melt);
  describe(table, machine_keys(), values.machine);
  describe(table, fibers, values.fibers);
  describe_law(table, orientation_menu(), orientation, values.orientation);
  describe_law(table, attrition_menu(), law, values.law);
  describe_law(table, attrition_menu(), compare, values.compared);
  describe(table, composite_keys(), values.composite);
  describe(table, sweep_keys(), values.sweep);
  describe(table, numerics_keys(), values.numerics);
  describe(table, output_keys(), values.output);
  describe(table, run, values.run);
}

}  // namespace fiberfate
