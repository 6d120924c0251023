// The keys of the study orientation.
#include "studies/orientation/case.hpp"

namespace fiberfate {
namespace {

std::vector<Column> timed_gradient_columns() {
  std::vector<Column> columns = gradient_columns();
  columns.insert(columns.begin(), Column{"time", {"s", "s"}, Range::not_negative()});
  return columns;
}

KeyGroup<OrientationFlowChoices> flow_keys() {
  using Flow = OrientationFlowChoices;
  const Choices<OrientationFlow> kinds = {
      {OrientationFlow::shear, "shear", "simple shear along x at flow.rate"},
      {OrientationFlow::planar, "planar", "planar elongation, diag(1, 0, -1) rate/2"},
      {OrientationFlow::uniaxial, "uniaxial", "uniaxial elongation, diag(2, -1, -1) rate/(2 sqrt 3)"},
      {OrientationFlow::biaxial, "biaxial", "biaxial elongation, the opposite of uniaxial"},
      {OrientationFlow::mixed, "mixed", "simple shear at flow.rate with planar elongation"},
      {OrientationFlow::gradient, "gradient", "any constant gradient, flow.gradient"},
      {OrientationFlow::table, "table", "the gradient follows flow.table"}};
  const Choices<HistoryForm> forms = {{HistoryForm::steps, "steps", "each row holds until the next"},
                                      {HistoryForm::ramps, "ramps", "linear between the rows"}};
  return {
      "flow",
      "The homogeneous flow that turns the fibers; L_ij = d v_i / d x_j.",
      {
          key("kind", &Flow::kind, kinds, "What the flow is."),
          key("rate", &Flow::rate, {"1/s"}, Range::between(0, 1e7),
              "Rate sqrt(2 D:D) of the shear or elongation.", usual("\"1 1/s\"")),
          key("elongation_rate", &Flow::elongation_rate, {"1/s"}, Range::between(-1e7, 1e7),
              "Stretching along x and shrinking along the shear's gradient, for kind = \"mixed\"."),
          key("shear_gradient", &Flow::shear_gradient, shear_gradient_choices(), shear_gradient_text),
          rows_key("gradient", &Flow::gradient, gradient_columns(),
                   "For kind = \"gradient\": one row of L11, L12, L13, L21, … L33.",
                   optional("[[-0.1, 0, 1, 0, 0.1, 0, 0, 0, 0]]")),
          rows_key(
              "table", &Flow::table, timed_gradient_columns(),
              "For kind = \"table\": rows of time and L11 … L33, or the path of a text file with such rows "
              "in SI; the last row holds to the end.",
              optional(R"([["0 s", 0, 0, 1, 0, 0, 0, 0, 0, 0], ["5 s", 0.5, 0, 0, 0, 0, 0, 0, 0, -0.5]])")),
          key("form", &Flow::form, forms, "What happens between the rows of the table."),
          key("temperature", &Flow::temperature, {"K"}, Range::positive(2000),
              "Temperature of the melt, for [melt]."),
          key("pressure", &Flow::pressure, {"Pa", "MPa"}, Range::between(0, 1e10),
              "Pressure in the melt, for [melt]."),
      }};
}

KeyGroup<OrientationFiberChoices> fiber_keys() {
  using Fibers = OrientationFiberChoices;
  return {"fibers",
          "The fibers at the start.",
          {
              orientation_key("orientation", &Fibers::orientation, "Orientation tensor at the start."),
              key("aspect_ratio", &Fibers::aspect_ratio, {}, Range::positive(1e9),
                  "Length over diameter r; xi = (r²-1)/(r²+1). Not given: slender, xi = 1.", optional("25"),
                  "thesis 2.14"),
              key("potential", &Fibers::potential, {}, Range::between(-10, 10),
                  "Maier-Saupe potential U0, in units of the rate; 0: none.", {},
                  "Latz, Strautins, Niedziela 2010"),
              key("volume_fraction", &Fibers::volume_fraction, {}, Range::inside(0, 1),
                  "Volume of the fibers over that of the melt; with the aspect ratio r it gives the fiber "
                  "term phi r²/(3 ln sqrt(pi/phi)) of the stress.",
                  optional("\"13.2 %\""), "Dinh, Armstrong 1984"),
              key("fiber_term", &Fibers::fiber_term, {}, Range::between(0, 1e6),
                  "phi N_p of the stress 2 eta (D + phi N_p A4:D), instead of volume_fraction.",
                  optional("10"), "thesis 2.12"),
              key("trouton_term", &Fibers::trouton_term, {}, Range::between(0, 1e6),
                  "R of the informed-isotropic viscosity eta (1 + R (D:A4:D)/(D:D)); not given: the fiber "
                  "term, with which it dissipates as the stress does.",
                  optional("10"), "thesis 2.11"),
          }};
}

KeyGroup<OrientationSolutionChoices> solution_keys() {
  using Solution = OrientationSolutionChoices;
  const Choices<DistributionChoice> distribution = {
      {DistributionChoice::no, "no", "only the tensor equation"},
      {DistributionChoice::yes, "yes", "also the distribution function, which needs no closure"}};
  const Choices<SteadyChoice> steady = {{SteadyChoice::no, "no", "only the run"},
                                        {SteadyChoice::yes, "yes", "also the steady state"}};
  return {"solution",
          "How the equation is closed and solved.",
          {
              name_key("closure", &Solution::closure, closure_names(),
                       "How A4 is made from A2 (docs/theory/closures.md)."),
              key("tolerance", &Solution::tolerance, {}, Range::between(1e-13, 1e-2),
                  "Error of A2 that one step may make."),
              key("distribution", &Solution::distribution, distribution,
                  "Whether the Fokker-Planck equation is solved beside, from the distribution of the same A2 "
                  "into which Jeffery's motion carries the isotropic one."),
              key("steady", &Solution::steady, steady,
                  "Whether the state that the flow at the end leads to is found beside, directly, however "
                  "long it takes to come there; the run may then be short."),
              key("degree", &Solution::degree, {}, Range::between(4, 200),
                  "Highest degree of the spherical harmonics, even; 6/sqrt(C_I) is plenty."),
          }};
}

}  // namespace

void describe_orientation(KeyTable& table, OrientationCase& values) {
  const LawTable diffusion = {"diffusion",
                              "Rotary diffusion: how fibers disturb each other (docs/theory/orientation.md).",
                              "\"folgar_tucker\"", Need::required};
  const LawTable retardation = {"retardation", "How much slower the fibers turn than theory says.", "\"rpr\"",
                                Need::optional};
  const LawTable melt = {
      "melt",
      "Viscosity of the matrix, to compute the stress of the melt with its fibers (docs/theory/"
      "viscosity.md); leave it out when only the orientation matters.",
      "\"newtonian\"", Need::optional};
  const KeyGroup<RunChoices> run = {"run", "How long.", {duration_key(1e9, "\"100 s\"")}};
  const KeyGroup<SeriesChoices> output = {"output", "What is kept.", series_rows()};
  describe_law(table, diffusion_menu(), diffusion, values.diffusion);
  describe_law(table, retardation_menu(), retardation, values.retardation);
  describe_law(table, viscosity_menu(), melt, values.melt);
  describe(table, flow_keys(), values.flow);
  describe(table, fiber_keys(), values.fibers);
  describe(table, solution_keys(), values.solution);
  describe(table, run, values.run);
  describe(table, output, values.output);
}

}  // namespace fiberfate
