// Describes the keys of the study orientation.
#include "microstructure/closure.hpp"
#include "studies/orientation/case.hpp"

namespace fiberfate {
namespace {

std::vector<Column> gradient_columns() {
  std::vector<Column> columns;
  for (const char* name : {"L11", "L12", "L13", "L21", "L22", "L23", "L31", "L32", "L33"})
    columns.push_back({name, {"1/s", "1/s"}, Range::between(-1e7, 1e7)});
  return columns;
}

void describe_flow(KeyTable& table, OrientationFlowChoices& flow) {
  table.section("flow", "The homogeneous flow that turns the fibers; L_ij = d v_i / d x_j.");
  table.choice(
      "flow.kind", flow.kind,
      {{OrientationFlow::shear, "shear", "simple shear along x at flow.rate"},
       {OrientationFlow::planar, "planar", "planar elongation, diag(1, 0, -1) rate/2"},
       {OrientationFlow::uniaxial, "uniaxial", "uniaxial elongation, diag(2, -1, -1) rate/(2 sqrt 3)"},
       {OrientationFlow::biaxial, "biaxial", "biaxial elongation, the opposite of uniaxial"},
       {OrientationFlow::mixed, "mixed", "simple shear at flow.rate with planar elongation"},
       {OrientationFlow::gradient, "gradient", "any constant gradient, flow.gradient"},
       {OrientationFlow::table, "table", "the gradient follows flow.table"}},
      {.text = "What the flow is."});
  table.quantity("flow.rate", flow.rate,
                 {.text = "Rate sqrt(2 D:D) of the shear or elongation.",
                  .unit = "1/s",
                  .range = Range::between(0, 1e7),
                  .need = Need::usual,
                  .example = "\"1 1/s\""});
  table.quantity(
      "flow.elongation_rate", flow.elongation_rate,
      {.text = "Stretching along x and shrinking along the shear's gradient, for kind = \"mixed\".",
       .unit = "1/s",
       .range = Range::between(-1e7, 1e7)});
  describe_shear_gradient(table, "flow", flow.shear_gradient);
  table.rows("flow.gradient", flow.gradient, gradient_columns(),
             {.text = "For kind = \"gradient\": one row of L11, L12, L13, L21, … L33.",
              .example = "[[-0.1, 0, 1, 0, 0.1, 0, 0, 0, 0]]"});
  std::vector<Column> columns = gradient_columns();
  columns.insert(columns.begin(), Column{"time", {"s", "s"}, Range::not_negative()});
  table.rows(
      "flow.table", flow.table, columns,
      {.text = "For kind = \"table\": rows of time and L11 … L33, or the path of a text file with such rows "
               "in SI; the last row holds to the end.",
       .example = R"([["0 s", 0, 0, 1, 0, 0, 0, 0, 0, 0], ["5 s", 0.5, 0, 0, 0, 0, 0, 0, 0, -0.5]])"});
  table.choice("flow.form", flow.form,
               {{GradientForm::steps, "steps", "each row holds until the next"},
                {GradientForm::ramps, "ramps", "linear between the rows"}},
               {.text = "What happens between the rows of the table."});
  table.quantity(
      "flow.temperature", flow.temperature,
      {.text = "Temperature of the melt, for [melt].", .unit = "K", .range = Range::positive(2000)});
  table.quantity("flow.pressure", flow.pressure,
                 {.text = "Pressure in the melt, for [melt].",
                  .unit = "Pa",
                  .friendly = "MPa",
                  .range = Range::between(0, 1e10)});
}

void describe_fibers(KeyTable& table, OrientationFiberChoices& fibers) {
  table.section("fibers", "The fibers at the start.");
  table.orientation("fibers.orientation", fibers.orientation, {.text = "Orientation tensor at the start."});
  table.quantity("fibers.aspect_ratio", fibers.aspect_ratio,
                 {.text = "Length over diameter r; xi = (r²-1)/(r²+1). Not given: slender, xi = 1.",
                  .range = Range::positive(1e9),
                  .example = "25",
                  .source = "thesis 2.14"});
  table.quantity("fibers.potential", fibers.potential,
                 {.text = "Maier-Saupe potential U0, in units of the rate; 0: none.",
                  .range = Range::between(-10, 10),
                  .source = "Latz, Strautins, Niedziela 2010"});
  table.quantity(
      "fibers.volume_fraction", fibers.volume_fraction,
      {.text = "Volume of the fibers over that of the melt; with the aspect ratio r it gives the fiber "
               "term phi r²/(3 ln sqrt(pi/phi)) of the stress.",
       .range = Range::inside(0, 1),
       .example = "\"13.2 %\"",
       .source = "Dinh, Armstrong 1984"});
  table.quantity("fibers.fiber_term", fibers.fiber_term,
                 {.text = "phi N_p of the stress 2 eta (D + phi N_p A4:D), instead of volume_fraction.",
                  .range = Range::between(0, 1e6),
                  .example = "10",
                  .source = "thesis 2.12"});
  table.quantity(
      "fibers.trouton_term", fibers.trouton_term,
      {.text = "R of the informed-isotropic viscosity eta (1 + R (D:A4:D)/(D:D)); not given: the fiber "
               "term, with which it dissipates as the stress does.",
       .range = Range::between(0, 1e6),
       .example = "10",
       .source = "thesis 2.11"});
}

void describe_solution(KeyTable& table, OrientationSolutionChoices& solution) {
  table.section("solution", "How the equation is closed and solved.");
  std::vector<std::pair<std::string, std::string>> names;
  for (const ClosureDescription& one : closures()) names.emplace_back(one.name, one.meaning);
  describe_name(table, "solution.closure", solution.closure, std::move(names),
                {.text = "How A4 is made from A2 (docs/theory/closures.md)."});
  table.quantity("solution.tolerance", solution.tolerance,
                 {.text = "Error of A2 that one step may make.", .range = Range::between(1e-13, 1e-2)});
  table.choice("solution.distribution", solution.distribution,
               {{DistributionChoice::no, "no", "only the tensor equation"},
                {DistributionChoice::yes, "yes", "also the distribution function, which needs no closure"}},
               {.text = "Whether the Fokker-Planck equation is solved beside, from the distribution of the "
                        "same A2 into which "
                        "Jeffery's motion carries the isotropic one."});
  table.count("solution.degree", solution.degree,
              {.text = "Highest degree of the spherical harmonics, even; 6/sqrt(C_I) is plenty.",
               .range = Range::between(4, 200)});
}

}  // namespace

void describe_shear_gradient(KeyTable& table, const std::string& section, ShearGradient& gradient) {
  table.choice(section + ".shear_gradient", gradient,
               {{ShearGradient::y, "y", "v_x = rate y, as in cells of fibers"},
                {ShearGradient::z, "z", "v_x = rate z, as across a cavity"}},
               {.text = "Direction along which the velocity of a shear varies."});
}

void describe_orientation(KeyTable& table, OrientationCase& values) {
  describe_law(table, diffusion_menu(),
               {"diffusion", "Rotary diffusion: how fibers disturb each other (docs/theory/orientation.md).",
                "\"folgar_tucker\"", Need::required},
               values.diffusion);
  describe_law(
      table, retardation_menu(),
      {"retardation", "How much slower the fibers turn than theory says.", "\"rpr\"", Need::optional},
      values.retardation);
  describe_law(table, viscosity_menu(),
               {"melt",
                "Viscosity of the matrix, to compute the stress of the melt with its fibers (docs/theory/"
                "viscosity.md); leave it out when only the orientation matters.",
                "\"newtonian\"", Need::optional},
               values.melt);
  describe_flow(table, values.flow);
  describe_fibers(table, values.fibers);
  describe_solution(table, values.solution);
  table.section("run", "How long.");
  table.quantity("run.duration", values.duration,
                 {.text = "Simulated time.",
                  .unit = "s",
                  .range = Range::positive(1e9),
                  .need = Need::required,
                  .example = "\"100 s\""});
  table.section("output", "What is kept.");
  table.quantity("output.interval", values.interval,
                 {.text = "Time between rows of series.csv; not given: a 200th of the duration.",
                  .unit = "s",
                  .range = Range::positive()});
}

}  // namespace fiberfate
