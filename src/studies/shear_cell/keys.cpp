// The keys of the study shear_cell.
#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"
#include "dynamics/friction_laws/friction_registry.hpp"
#include "dynamics/hinge_laws/hinge_registry.hpp"
#include "keys/law_keys.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {
namespace {

KeyGroup<BoundaryChoices> boundary_keys() {
  const Choices<Boundary> ends = {
      {Boundary::periodic, "periodic", "the cell repeats, sheared (Lees-Edwards)"},
      {Boundary::walls, "walls", "solid walls that move with the flow at y = 0 and at the far side"}};
  return {"boundary",
          "What bounds the cell.",
          {key("y", &BoundaryChoices::y, ends,
               "How the cell ends in the direction of the gradient; in x and z it is periodic.")}};
}

KeyGroup<DynamicsParameters> drag_keys() {
  return {"drag",
          "The force of the melt on a rod.",
          {law_key("law", &DynamicsParameters::drag, drag_laws(), "The law of drag.")}};
}

KeyGroup<DynamicsParameters> hinge_keys() {
  return {
      "hinge",
      "The resistance of a fiber to bending.",
      {law_key("law", &DynamicsParameters::hinge, hinge_laws(), "The moment at a hinge between two rods.")}};
}

KeyGroup<ContactParameters> contact_keys() {
  using Contact = ContactParameters;
  const KeyRows<Contact> friction = {
      law_key("friction_law", &Contact::friction_law, friction_laws(),
              "The friction between rods, and between rods and walls."),
      key("friction", &Contact::friction, {}, Range::between(0, 10), "Coefficient of friction between rods."),
      key("wall_friction", &Contact::wall_friction, {}, Range::between(0, 10),
          "Coefficient of friction between rods and walls."),
      key("slip_velocity", &Contact::slip_velocity, {"m/s"}, Range::positive(1),
          "Sliding speed below which friction fades to nothing at rest."),
      key("sweeps", &Contact::sweeps, {}, Range::between(1, 20),
          "Solutions a step; each renews the predicted gaps and slip."),
  };
  return {"contact", "The forces between fibers that touch.",
          joined<Contact>({contact_law_rows(), friction})};
}

KeyGroup<BreakageParameters> breakage_keys() {
  using Breakage = BreakageParameters;
  return {"breakage",
          "When a fiber breaks at a hinge between two rods.",
          {
              law_key("law", &Breakage::law, breakage_laws(), "The criterion."),
              key("critical_radius", &Breakage::critical_radius, {"m", "um"}, Range::positive(1),
                  "Radius of curvature below which law \"fixed\" breaks; the default is the mean of the loop "
                  "tests.",
                  {}, "thesis section 3.3.3 and table 4 (200, 250, 300 um)"),
              key("minimum_radius", &Breakage::minimum_radius, {"m", "um"}, Range::positive(1),
                  "Radius of curvature at which laws \"probability\" and \"strength\" break for certain.", {},
                  "loop test, thesis figure 3.19"),
              key("maximum_radius", &Breakage::maximum_radius, {"m", "um"}, Range::positive(1),
                  "Radius of curvature above which they never break.", {}, "loop test, thesis figure 3.19"),
              key("exponent", &Breakage::exponent, {}, Range::positive(700),
                  "m in their probability (exp(m x) - 1)/(exp(m) - 1), x from 0 to 1 between the two radii.",
                  {}, "thesis equation 3.33"),
              key("check_interval", &Breakage::check_interval, {"s"}, Range::positive(),
                  "Simulated time between two checks, whatever the time step."),
          }};
}

KeyGroup<StepParameters> step_keys() {
  using Step = StepParameters;
  const Choices<StepControl> controls = {
      {StepControl::adaptive, "adaptive", "the step follows the error of a step"},
      {StepControl::fixed, "fixed", "every step is step.initial"}};
  return {
      "step",
      "How time is stepped.",
      {
          key("control", &Step::control, controls, "How the time step is chosen."),
          key("initial", &Step::initial, {"s"}, Range::positive(10),
              "First step of \"adaptive\", every step of \"fixed\"."),
          key("minimum", &Step::minimum, {"s"}, Range::positive(10),
              "Step below which the simulation gives up."),
          key("maximum", &Step::maximum, {"s"}, Range::positive(10), "Largest step of \"adaptive\"."),
          key("tolerance", &Step::tolerance, {}, Range::positive(10),
              "Error of displacement that \"adaptive\" allows in a step, in fiber radii, root mean square "
              "over the nodes."),
          key("maximum_strain", &Step::maximum_strain, {}, Range::positive(1),
              "Most strain of the flow in one step of \"adaptive\"."),
      }};
}

KeyGroup<OutputChoices> output_keys() {
  using Output = OutputChoices;
  const KeyRows<Output> frames = {
      key("frame_interval", &Output::frame_interval, {"s"}, Range::positive(),
          "Simulated time between frames of result.vtkhdf; not given: run.duration / 50.",
          optional("\"0.2 s\""))};
  const KeyRows<Output> others = {
      key("histogram_times", &Output::histogram_times, {"s"}, Range::not_negative(),
          "Simulated times at which histograms of length and curvature are kept, besides the start "
          "and the end.",
          optional("[\"1 s\", \"5 s\"]")),
      key("length_bin", &Output::length_bin, {"m", "mm"}, Range::between(1e-9, 1),
          "Width of the bins of the length histogram."),
      key("radius_bin", &Output::radius_bin, {"m", "um"}, Range::between(1e-9, 1),
          "Width of the bins of the histogram of radii of curvature."),
      key("near_critical", &Output::near_critical, {"m", "um"}, Range::positive(1),
          "Hinges whose radius of curvature is this little above the breaking one are counted.", {},
          "thesis figure 3.31"),
  };
  return {"output", "What is kept, and how often.",
          joined<Output>({rows_of_base<Output, SeriesChoices>(series_rows()), frames, checkpoint_rows(),
                          others, stress_rows()})};
}

}  // namespace

void describe_shear_cell(KeyTable& table, ShearCellCase& values) {
  const KeyGroup<RunChoices> run = {"run",
                                    "How long, with which random numbers, on how many threads.",
                                    {duration_key(1e6, "\"2 s\""), seed_key(), threads_key()}};
  describe(table, run, values.run);
  describe_sample(table, values.sample);
  describe(table, flow_keys(), values.flow);
  describe(table, boundary_keys(), values.boundary);
  describe_dynamics(table, values.dynamics);
  describe(table, output_keys(), values.output);
}

void describe_dynamics(KeyTable& table, DynamicsParameters& dynamics) {
  describe(table, drag_keys(), dynamics);
  describe(table, hinge_keys(), dynamics);
  describe(table, contact_keys(), dynamics.contact);
  describe(table, breakage_keys(), dynamics.breakage);
  describe(table, step_keys(), dynamics.step);
}

KeyRows<OutputChoices> checkpoint_rows() {
  return {key("checkpoint_interval", &OutputChoices::checkpoint_interval, {"s", "min"}, Range::positive(),
              "Wall time between checkpoints.")};
}

KeyRows<OutputChoices> stress_rows() {
  using Output = OutputChoices;
  return {
      key("stress_steps", &Output::stress_steps, {}, Range::between(0, 1e9),
          "Time steps between two readings of the particle stress, whose means stand in series.csv; 0: none "
          "is "
          "read."),
      key("stationary_from", &Output::stationary_from, {"s"}, Range::not_negative(),
          "Simulated time from which on stresses are averaged for the summary; not given: half of "
          "run.duration.",
          optional("\"5 s\""))};
}

}  // namespace fiberfate
