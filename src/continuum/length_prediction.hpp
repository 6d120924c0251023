// Follows a population of fibers through a history of flow and temperature.
#pragma once

#include <functional>
#include <span>

#include "continuum/attrition_law.hpp"
#include "continuum/viscosity.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {

/// Where fibers break: the flow over time, the melt, and how orientation shields the fibers.
struct LengthConditions {
  const FlowHistory& history;  ///< its viscosity is not asked for
  const ViscosityLaw& viscosity;
  double compression = 1;  ///< -2 D:A/rate; only Phelps uses it (LengthFlow)
};

/// Shows the state at one time. The evolution is valid during the visit only.
struct LengthSample {
  double time = 0;  ///< s
  MeltState melt;
  double viscosity = 0;           ///< Pa s
  double unbreakable_length = 0;  ///< L_inf or L_ub in this flow, m
  const LengthEvolution& evolution;
};

/// Follows a population and visits each of `times` (s, not falling, from 0 on). Parts of constant flow are
/// exact; ramps are cut as FlowHistory::parts says. Raises InputError as AttritionLaw::start does.
void follow_lengths(const AttritionLaw& law, const LengthStart& start, const LengthConditions& conditions,
                    std::span<const double> times, const std::function<void(const LengthSample&)>& visit);

}  // namespace fiberfate
