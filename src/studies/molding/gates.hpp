// Makes gates, sensors and inlets from the tables of a molding case.
#pragma once

#include <vector>

#include "studies/molding/setup.hpp"

namespace fiberfate {

/// Places the sensors. Raises InputError as position_of, and for a name of several words.
[[nodiscard]] std::vector<Sensor> sensors_of(const GateChoices& choices, const MoldingPart& part);

/// The gates of part and case with their runners and valves. Raises InputError, with the key, for a
/// gate or sensor that there is not.
[[nodiscard]] std::vector<Gate> gates_of(const GateChoices& choices, const MoldingPart& part);

/// Gives gates that have one an inlet of their own, beginning with that of all; call it when the gates and
/// classes of `setup` stand. Raises InputError for numbers that do not fit.
void add_gate_inlets(const GateChoices& choices, MoldingSetup& setup);

}  // namespace fiberfate
