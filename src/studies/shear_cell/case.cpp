// Checks a case of the study shear_cell and foretells what it needs.
#include "studies/shear_cell/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/friction_laws/friction_registry.hpp"
#include "fibers/contact_laws/contact_registry.hpp"
#include "fibers/lattice_choice.hpp"
#include "keys/law_keys.hpp"
#include "studies/pace.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/shear_cell/effort.hpp"

namespace fiberfate {
namespace {

constexpr double default_frames = 50;  ///< of result.vtkhdf
constexpr double most_frames = 1e6;    ///< more are a slip of the unit
constexpr double most_steps = 1e13;    ///< more end on no machine

/// Finds flows that the cell cannot follow, or only with images that nearly touch.
void validate_lattice(const ShearCellCase& values, CaseChecker& checker) {
  constexpr double closest = 2;  // diameters between images
  if (!checker.is_sound()) return;
  const FlowHistory flow = flow_history(values.flow);
  const char* place = values.flow.kind == FlowKind::table ? "flow.kind" : "flow.type";
  Cell cell;
  if (!checker.report_at(place, [&] { cell = cell_for(flow, Vec3::Ones()); })) return;
  const bool is_shear = cell.frame.kind == LatticeKind::carried;
  if (values.boundary.y == Boundary::walls && !is_shear)
    checker.error("boundary.y", "walls stand in a flow that is not along them, " + checker.cite("flow.type"),
                  "take \"periodic\", or flow.type = \"shear\"");
  const auto plan = plan_sample(values.sample, values.run.seed);
  if (is_shear || !plan) return;
  const double edge = std::cbrt(plan->cell_size.prod()), least = closest * values.sample.fibers.diameter;
  const double nearest = nearest_image_ever(cell);
  if (nearest * edge < least)
    checker.error(
        values.sample.cell.size ? "cell.size" : "fibers.count",
        fmt::format(
            "the cell is too small for this flow: its images come as near as {:.3g} um, {:.2g} of its "
            "edge",
            1e6 * nearest * edge, nearest),
        fmt::format("take a cell of at least {:.3g} mm", 1e3 * least / nearest));
}

void validate_breakage(const ShearCellCase& values, CaseChecker& checker) {
  constexpr double most_checks = 1e9;  // more are a slip of the unit
  const double interval = values.dynamics.breakage.check_interval, duration = values.run.duration;
  if (interval > 0 && duration / interval > most_checks)
    checker.error("breakage.check_interval",
                  fmt::format("makes {:.3g} checks in {}", duration / interval, checker.cite("run.duration")),
                  fmt::format("give at least {:.3g} s", duration / most_checks));
  const BreakageParameters& breakage = values.dynamics.breakage;
  if (!checker.is_sound("breakage.law")) return;
  warn_of_unread_constants("breakage.law", breakage_laws(), breakage.law, checker);
  const BreakageRow& law = breakage_law_named(breakage.law);
  const bool scatters = reads_constant(law.text, "maximum_radius");
  if (scatters && breakage.minimum_radius >= breakage.maximum_radius)
    checker.error("breakage.minimum_radius", "not less than " + checker.cite("breakage.maximum_radius"),
                  "give the radius of certain breakage as minimum_radius, the one of none as maximum_radius");
  const double onset = law.onset_radius(breakage);
  const double tightest = values.sample.fibers.rod_length.value_or(0) / 2;
  if (onset > 0 && onset < tightest)
    checker.warn(
        scatters ? "breakage.maximum_radius" : "breakage.critical_radius",
        fmt::format("nothing can break: rods of this length cannot bend below {:.4g} um", 1e6 * tightest),
        "shorten fibers.rod_length");
}

/// Finds steps so short that a run would never end.
void validate_step_count(const ShearCellCase& values, CaseChecker& checker) {
  const StepParameters& step = values.dynamics.step;
  const bool fixed = step.control == StepControl::fixed;
  const double longest = fixed ? step.initial : step.maximum, duration = values.run.duration;
  if (longest > 0 && duration / longest > most_steps)
    checker.error(fixed ? "step.initial" : "step.maximum",
                  fmt::format("makes {:.2g} steps in {}", duration / longest, checker.cite("run.duration")),
                  fmt::format("give at least {:.2g} s", duration / most_steps));
}

void validate_step(const StepParameters& step, CaseChecker& checker) {
  if (step.control == StepControl::fixed) {
    checker.warn_unused({"step.maximum", "step.tolerance", "step.maximum_strain"},
                        "step.control = \"adaptive\"");
    return;
  }
  if (step.minimum > step.maximum)
    checker.error("step.minimum", "larger than " + checker.cite("step.maximum"),
                  "give minimum <= initial <= maximum");
  else if (step.initial > step.maximum)
    checker.error("step.initial", "larger than " + checker.cite("step.maximum"),
                  "give minimum <= initial <= maximum");
  else if (step.initial < step.minimum)
    checker.error("step.initial", "smaller than " + checker.cite("step.minimum"),
                  "give minimum <= initial <= maximum");
}

void validate_output(const ShearCellCase& values, CaseChecker& checker) {
  const double duration = values.run.duration;
  if (duration <= 0) return;
  for (const auto& [key, interval] :
       {std::pair{"output.interval", series_interval(values.run, values.output)},
        std::pair{"output.frame_interval", frame_interval(values)}})
    if (interval > duration)
      checker.warn(key, "longer than " + checker.cite("run.duration"), "only the start and the end are kept");
  validate_series(values.run, values.output, checker);
  if (duration / frame_interval(values) > most_frames)
    checker.error("output.frame_interval",
                  fmt::format("makes {:.3g} frames in {}", duration / frame_interval(values),
                              checker.cite("run.duration")),
                  fmt::format("give at least {:.3g} s", duration / most_frames));
  validate_times("output.histogram_times", values.output.histogram_times, values.run, checker);
}

void validate_contact(const ShearCellCase& values, CaseChecker& checker) {
  const ContactParameters& contact = values.dynamics.contact;
  warn_of_unread_constants("contact.law", contact_laws(), contact.law, checker);
  warn_of_unread_constants("contact.friction_law", friction_laws(), contact.friction_law, checker);
  const double diameter = values.sample.fibers.diameter;
  if (checker.is_sound("contact.law") && reads_constant(contact_law_named(contact.law).text, "ramp") &&
      diameter > 0 && contact.ramp > diameter)
    checker.error("contact.ramp", "wider than a fiber, " + checker.cite("fibers.diameter"),
                  "about 1 um is usual");
  if (values.boundary.y == Boundary::periodic)
    checker.warn_unused({"contact.wall_friction"}, "boundary.y = \"walls\"");
}

}  // namespace

void validate_shear_cell(const ShearCellCase& values, CaseChecker& checker) {
  validate_sample(values.sample, checker);
  validate_flow(values.flow, values.run.duration, checker);
  validate_contact(values, checker);
  validate_breakage(values, checker);
  validate_step(values.dynamics.step, checker);
  validate_step_count(values, checker);
  validate_output(values, checker);
  validate_lattice(values, checker);
}

CaseEstimate estimate_shear_cell(const ShearCellCase& values) {
  const auto plan = plan_sample(values.sample, values.run.seed);
  CaseEstimate estimate = estimate_sample(values.sample, plan);
  if (plan)
    estimate.facts.emplace_back("time steps",
                                fmt::format("about {:.2g}", expected_steps(values, crowding(values, *plan))));
  foretell(
      estimate, [&] { return shear_cell_seconds(values, plan); }, "from a trial on this machine");
  return estimate;
}

DynamicsParameters dynamics_parameters(const ShearCellCase& values) {
  DynamicsParameters parameters = values.dynamics;
  parameters.seed = values.run.seed;
  return parameters;
}

double critical_radius(const BreakageParameters& breakage) {
  const double certain = breakage_law_named(breakage.law).certain_radius(breakage);
  return certain > 0 ? certain : breakage.critical_radius;
}

double stationary_from(const ShearCellCase& values) {
  return values.output.stationary_from.value_or(0.5 * values.run.duration);
}

double frame_interval(const ShearCellCase& values) {
  return values.output.frame_interval.value_or(values.run.duration / default_frames);
}

}  // namespace fiberfate
