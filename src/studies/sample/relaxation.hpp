// Relaxes packed fibers by letting them move: a slow shear with contact and without breakage.
#pragma once

#include <cstdint>
#include <optional>

#include "dynamics/parameters.hpp"
#include "fibers/state.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"
#include "studies/session.hpp"

namespace fiberfate {

/// [relaxation] (thesis sections 3.2.1, 3.3.3).
struct RelaxationChoices {
  std::optional<double> duration;   ///< most simulated time, s; not given: none
  double rate = 0.1;                ///< of the shear, 1/s
  double viscosity = 200;           ///< Pa s
  double overlap = 0.01;            ///< wanted, largest, diameters
  double minimum_radius = 0;        ///< wanted, smallest, m
  double orientation_bound = 0.01;  ///< most that any component of A2 may change
};

/// Why a relaxation ended; the names go to summary.json as relaxation_end.
enum class RelaxationEnd { met, time_over, orientation_bound };
[[nodiscard]] const char* name(RelaxationEnd end);

/// Relaxed fibers, at rest at time zero, and how they became so.
struct RelaxedFibers {
  FiberState state;
  RelaxationEnd end = RelaxationEnd::met;
  double simulated = 0;          ///< s
  double orientation_drift = 0;  ///< largest change of a component of A2
};

void describe_relaxation(KeyTable& table, RelaxationChoices& choices);
void validate_relaxation(const RelaxationChoices& choices, CaseChecker& checker);

/// Moves the fibers until no overlap and no radius of curvature is worse than wanted, or the time is over, or
/// A2 would change more than it may: then the state before that is kept. Raises NoOutcome when the
/// session is asked to stop.
[[nodiscard]] RelaxedFibers relax_fibers(const RelaxationChoices& choices, const ContactParameters& contact,
                                         const FiberState& start, const Session& session);

}  // namespace fiberfate
