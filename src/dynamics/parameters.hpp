// Everything that a user may choose about the motion of fibers.
#pragma once

#include <cstdint>
#include <string>

#include "dynamics/breakage_laws/breakage_parameters.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"

namespace fiberfate {

/// How the time step is chosen.
enum class StepControl { fixed, adaptive };

/// How time is stepped.
struct StepParameters {
  StepControl control = StepControl::adaptive;
  double initial = 1e-5;     ///< first step of `adaptive`, every step of `fixed`, s
  double minimum = 1e-10;    ///< below this the simulation fails, s
  double maximum = 1e-3;     ///< s
  double tolerance = 0.005;  ///< displacement error a step that `adaptive` allows, rms over nodes, in radii
  double maximum_strain = 0.05;  ///< most strain of the flow in one step of `adaptive`
};

/// All choices about the motion of fibers (physics: docs/theory/particles.md).
struct DynamicsParameters {
  std::string drag = "beads";     ///< law of drag: a row of drag_laws()
  std::string hinge = "elastic";  ///< law of bending: a row of hinge_laws()
  ContactParameters contact;
  BreakageParameters breakage;
  StepParameters step;
  std::uint64_t seed = 1;
};

}  // namespace fiberfate
