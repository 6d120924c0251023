// What parameters and fibers must be so that they can be stepped.
#include "dynamics/simulable.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"
#include "dynamics/friction_laws/friction_registry.hpp"
#include "dynamics/hinge_laws/hinge_registry.hpp"
#include "fibers/contact_laws/contact_registry.hpp"
#include "fibers/lattice_choice.hpp"
#include "fibers/rod_pairs.hpp"
#include "fibers/state_check.hpp"

namespace fiberfate {
namespace {

// Rods of two fibers stand at most their lengths and a few cells apart, and the cell shears by half: this
// much of the images that can be told apart is safe.
constexpr double most_cells = 0.8 * farthest_image;

void require_positive(const char* name, double value) {
  if (!(value > 0) || std::isinf(value))
    throw InputError(std::string(name) + " is not a number above zero", "give one");
}

void require_not_negative(const char* name, double value) {
  if (!(value >= 0) || std::isinf(value))
    throw InputError(std::string(name) + " is not a number from zero on", "give one");
}

void require_contact(const ContactParameters& contact) {
  (void)contact_law_named(contact.law);
  (void)friction_law_named(contact.friction_law);
  require_not_negative("contact.force_constant", contact.force_constant);
  require_not_negative("contact.decay", contact.decay);
  require_positive("contact.cutoff", contact.cutoff);
  require_positive("contact.ramp", contact.ramp);
  require_not_negative("contact.friction", contact.friction);
  require_not_negative("contact.wall_friction", contact.wall_friction);
  require_positive("contact.slip_velocity", contact.slip_velocity);
  if (!(contact.poisson_ratio > -1 && contact.poisson_ratio <= 0.5))
    throw InputError("contact.poisson_ratio is not between -1 and 0.5", "that of glass is 0.22");
  if (contact.sweeps < 1) throw InputError("contact.sweeps is below one", "give at least one");
}

void require_breakage(const BreakageParameters& breakage) {
  if (breakage_law_named(breakage.law).onset_radius(breakage) > 0)
    require_positive("breakage.check_interval", breakage.check_interval);
}

void require_step(const StepParameters& step) {
  require_positive("step.initial", step.initial);
  if (step.control == StepControl::fixed) return;
  require_positive("step.minimum", step.minimum);
  require_positive("step.maximum", step.maximum);
  require_positive("step.tolerance", step.tolerance);
  require_positive("step.maximum_strain", step.maximum_strain);
}

}  // namespace

void require_admissible(const DynamicsParameters& parameters) {
  (void)drag_law_named(parameters.drag);
  (void)hinge_law_named(parameters.hinge);
  require_contact(parameters.contact);
  require_breakage(parameters.breakage);
  require_step(parameters.step);
}

void require_simulable(const FiberState& state) {
  if (state.fiber_count() == 0) throw InputError("there are no fibers", "ask for at least one");
  require_sound(state);
  require_few_images(state, most_cells);
  for (const FiberIndex fiber : state.fibers()) {
    const double diameter = state.material(fiber).diameter();
    for (const RodIndex rod : state.rods(fiber)) {
      if (state.rod_length[rod] <= 0.999 * diameter)
        throw InputError("a rod is shorter than its diameter", "cut fibers into fewer, longer rods");
    }
  }
}

void require_simulable(const FlowHistory& flow) {
  require_steps(flow);
  for (const FlowRow& row : flow.rows()) {
    require_positive("the viscosity of the matrix", row.flow.viscosity);
  }
}

void require_flow(const Cell& cell, const FlowHistory& flow) {
  require_follows(cell, flow);
  const bool is_walled = std::ranges::count(cell.boundary, Boundary::walls) > 0;
  for (const FlowRow& row : flow.rows()) {
    if (is_walled && row.flow.gradient != simple_shear(row.flow.gradient(0, 1)).gradient)
      throw InputError("walls stand in a flow that is not along them",
                       "give simple shear u_x(y), or boundary.y = \"periodic\"");
  }
}

}  // namespace fiberfate
