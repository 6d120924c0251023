// Describes the keys of the study shear_cell.
#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"
#include "dynamics/friction_laws/friction_registry.hpp"
#include "dynamics/hinge_laws/hinge_registry.hpp"
#include "keys/law_keys.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {
namespace {

void describe_flow(KeyTable& table, FlowChoices& flow) {
  table.section("flow", "Simple shear: the melt moves along x, faster with y.");
  table.choice("flow.kind", flow.kind,
               {{FlowKind::constant, "constant", "rate and viscosity from the first moment"},
                {FlowKind::ramp, "ramp", "the rate rises to flow.rate in equal steps"},
                {FlowKind::table, "table", "rate and viscosity follow flow.table"}},
               {.text = "How the flow develops."});
  table.quantity("flow.rate", flow.rate,
                 {.text = "Shear rate, du_x/dy; for a ramp, the last one.",
                  .unit = "1/s",
                  .range = Range::between(0, 1e7),
                  .need = Need::usual,
                  .example = "\"16.65 1/s\"",
                  .source = "thesis table 3"});
  table.quantity("flow.viscosity", flow.viscosity,
                 {.text = "Viscosity of the matrix.",
                  .unit = "Pa s",
                  .range = {0, 1e9, Range::Ends::open_low},
                  .need = Need::usual,
                  .example = "\"200 Pa s\"",
                  .source = "thesis table 3"});
  table.quantity("flow.ramp_duration", flow.ramp_duration,
                 {.text = "Time in which a ramp reaches flow.rate.",
                  .unit = "s",
                  .range = Range::positive(),
                  .source = "thesis figure 3.24"});
  table.count("flow.ramp_steps", flow.ramp_steps,
              {.text = "Number of equal steps of a ramp; the first is flow.rate / ramp_steps.",
               .range = Range::between(1, 1e6),
               .source = "thesis figure 3.24"});
  table.rows(
      "flow.table", flow.table,
      {{"end time", {"s", "s"}, Range::positive()},
       {"rate", {"1/s", "1/s"}, Range::between(0, 1e7)},
       {"viscosity", {"Pa s", "Pa s"}, {0, 1e9, Range::Ends::open_low}}},
      {.text =
           "For kind = \"table\": rows [end time, rate, viscosity], the last of which lasts to the end; or "
           "the path of a text file with such rows in s, 1/s and Pa s.",
       .example = R"([["0.5 s", "10 1/s", "300 Pa s"], ["2 s", "100 1/s", "150 Pa s"]])"});
}

void describe_contact(KeyTable& table, ContactParameters& contact) {
  table.section("contact", "The forces between fibers that touch.");
  describe_contact_law(table, contact);
  describe_law_name(table, "contact.friction_law", contact.friction_law, friction_laws(),
                    {.text = "The friction between rods, and between rods and walls."});
  table.quantity("contact.friction", contact.friction,
                 {.text = "Coefficient of friction between rods.", .range = Range::between(0, 10)});
  table.quantity("contact.wall_friction", contact.wall_friction,
                 {.text = "Coefficient of friction between rods and walls.", .range = Range::between(0, 10)});
  table.quantity("contact.slip_velocity", contact.slip_velocity,
                 {.text = "Sliding speed below which friction fades to nothing at rest.",
                  .unit = "m/s",
                  .range = Range::positive(1)});
  table.count(
      "contact.sweeps", contact.sweeps,
      {.text = "Solutions a step; each renews the predicted gaps and slip.", .range = Range::between(1, 20)});
}

void describe_breakage(KeyTable& table, BreakageParameters& breakage) {
  table.section("breakage", "When a fiber breaks at a hinge between two rods.");
  describe_law_name(table, "breakage.law", breakage.law, breakage_laws(), {.text = "The criterion."});
  table.quantity(
      "breakage.critical_radius", breakage.critical_radius,
      {.text = "Radius of curvature below which law \"fixed\" breaks; the default is the mean of the loop "
               "tests.",
       .unit = "m",
       .friendly = "um",
       .range = Range::positive(1),
       .source = "thesis section 3.3.3 and table 4 (200, 250, 300 um)"});
  table.quantity(
      "breakage.minimum_radius", breakage.minimum_radius,
      {.text = "Radius of curvature at which laws \"probability\" and \"strength\" break for certain.",
       .unit = "m",
       .friendly = "um",
       .range = Range::positive(1),
       .source = "loop test, thesis figure 3.19"});
  table.quantity("breakage.maximum_radius", breakage.maximum_radius,
                 {.text = "Radius of curvature above which they never break.",
                  .unit = "m",
                  .friendly = "um",
                  .range = Range::positive(1),
                  .source = "loop test, thesis figure 3.19"});
  table.quantity(
      "breakage.exponent", breakage.exponent,
      {.text = "m in their probability (exp(m x) - 1)/(exp(m) - 1), x from 0 to 1 between the two radii.",
       .range = Range::positive(700),
       .source = "thesis equation 3.33"});
  table.quantity("breakage.check_interval", breakage.check_interval,
                 {.text = "Simulated time between two checks, whatever the time step.",
                  .unit = "s",
                  .range = Range::positive()});
}

void describe_step(KeyTable& table, StepParameters& step) {
  table.section("step", "How time is stepped.");
  table.choice("step.control", step.control,
               {{StepControl::adaptive, "adaptive", "the step follows the error of a step"},
                {StepControl::fixed, "fixed", "every step is step.initial"}},
               {.text = "Who chooses the time step."});
  table.quantity("step.initial", step.initial,
                 {.text = "First step of \"adaptive\", every step of \"fixed\".",
                  .unit = "s",
                  .range = Range::positive(10)});
  table.quantity(
      "step.minimum", step.minimum,
      {.text = "Step below which the simulation gives up.", .unit = "s", .range = Range::positive(10)});
  table.quantity("step.maximum", step.maximum,
                 {.text = "Largest step of \"adaptive\".", .unit = "s", .range = Range::positive(10)});
  table.quantity(
      "step.tolerance", step.tolerance,
      {.text = "Error of displacement that \"adaptive\" allows in a step, in fiber radii, root mean square "
               "over the nodes.",
       .range = Range::positive(10)});
  table.quantity(
      "step.maximum_strain", step.maximum_strain,
      {.text = "Most strain of the flow in one step of \"adaptive\".", .range = Range::positive(1)});
}

void describe_output(KeyTable& table, OutputChoices& output) {
  table.section("output", "What is kept, and how often.");
  table.quantity("output.interval", output.interval,
                 {.text = "Simulated time between rows of series.csv; not given: run.duration / 200.",
                  .unit = "s",
                  .range = Range::positive(),
                  .example = "\"0.05 s\""});
  table.quantity("output.frame_interval", output.frame_interval,
                 {.text = "Simulated time between frames of result.vtkhdf; not given: run.duration / 50.",
                  .unit = "s",
                  .range = Range::positive(),
                  .example = "\"0.2 s\""});
  table.quantity(
      "output.checkpoint_interval", output.checkpoint_interval,
      {.text = "Wall time between checkpoints.", .unit = "s", .friendly = "min", .range = Range::positive()});
  table.quantities(
      "output.histogram_times", output.histogram_times,
      {.text = "Simulated times at which histograms of length and curvature are kept, besides the start "
               "and the end.",
       .unit = "s",
       .range = Range::not_negative(),
       .example = "[\"1 s\", \"5 s\"]"});
  table.quantity("output.length_bin", output.length_bin,
                 {.text = "Width of the bins of the length histogram.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(1)});
  table.quantity("output.radius_bin", output.radius_bin,
                 {.text = "Width of the bins of the histogram of radii of curvature.",
                  .unit = "m",
                  .friendly = "um",
                  .range = Range::positive(1)});
  table.quantity(
      "output.near_critical", output.near_critical,
      {.text = "Hinges whose radius of curvature is this little above the breaking one are counted.",
       .unit = "m",
       .friendly = "um",
       .range = Range::positive(1),
       .source = "thesis figure 3.31"});
}

}  // namespace

void describe_shear_cell(KeyTable& table, ShearCellCase& values) {
  table.section("run", "How long, with which random numbers, on how many threads.");
  table.quantity("run.duration", values.run.duration,
                 {.text = "Simulated time.",
                  .unit = "s",
                  .range = Range::positive(1e6),
                  .need = Need::required,
                  .example = "\"2 s\""});
  table.count(
      "run.seed", values.dynamics.seed,
      {.text = "Seed of all random numbers: the same seed gives the same result on any number of threads.",
       .range = Range::not_negative()});
  table.count("run.threads", values.run.threads,
              {.text = "Threads; 0 for as many as the machine has.", .range = Range::between(0, 4096)});
  describe_sample(table, values.sample);
  describe_flow(table, values.flow);
  table.section("boundary", "How the cell ends.");
  table.choice(
      "boundary.y", values.boundary_y,
      {{Boundary::periodic, "periodic", "the cell repeats, sheared (Lees-Edwards)"},
       {Boundary::walls, "walls", "solid walls that move with the flow at y = 0 and at the far side"}},
      {.text = "How the cell ends in the direction of the gradient; in x and z it is periodic."});
  table.section("drag", "The force of the melt on a rod.");
  describe_law_name(table, "drag.law", values.dynamics.drag, drag_laws(), {.text = "The law of drag."});
  table.section("hinge", "The resistance of a fiber to bending.");
  describe_law_name(table, "hinge.law", values.dynamics.hinge, hinge_laws(),
                    {.text = "The moment at a hinge between two rods."});
  describe_contact(table, values.dynamics.contact);
  describe_breakage(table, values.dynamics.breakage);
  describe_step(table, values.dynamics.step);
  describe_output(table, values.output);
}

}  // namespace fiberfate
