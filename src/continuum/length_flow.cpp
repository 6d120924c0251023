// Checks the flows that length laws are given.
#include "continuum/length_flow.hpp"

#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

/// -2 D:A/rate, which round-off may take a little beyond 1.
constexpr NumberRange compressions = {.lower = -1 - 1e-6, .upper = 1 + 1e-6};

}  // namespace

void LengthFlow::check() const {
  require_number("rate", rate, not_negative);
  require_number("viscosity", viscosity, not_negative);
  require_number("compression", compression, compressions);
}

void LengthFlows::check() const {
  require_same_size("viscosity", viscosity.size(), rate.size());
  if (!compression.empty()) require_same_size("compression", compression.size(), rate.size());
  require_numbers("rate", rate, not_negative);
  require_numbers("viscosity", viscosity, not_negative);
  require_numbers("compression", compression, compressions);
}

}  // namespace fiberfate
