// Integrates smooth differential equations with Dormand and Prince's embedded pair of orders 5 and 4.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/number_checks.hpp"

namespace fiberfate {

/// How finely to integrate.
struct IntegrationTolerance {
  double absolute = 1e-8;             ///< in the units of the state
  double relative = 1e-8;             ///< of the state's norm
  std::int64_t most_steps = 1000000;  ///< accepted and rejected ones together
};

/// Counts what an integration did, and remembers the step size for the next interval.
struct IntegrationRecord {
  std::int64_t accepted = 0;
  std::int64_t rejected = 0;
  double next_step = 0;  ///< s; 0 before the first step
};

/// Advances y' = f(y) by `duration`; f(y, slope) writes the slope. `settle(y)` is called after every accepted
/// step, to take away round-off from invariants; it tells whether it changed y by more than that. Returns
/// false when the steps ran out or shrank to nothing, with y where it came to. The step keeps |error| /
/// (absolute + relative |y|) below 1 in the Euclidean norm; State is a fixed or dynamic Eigen column vector.
/// Raises InputError for a duration that is negative or not finite.
/// Source: Dormand, Prince, J. Comput. Appl. Math. 6, 19 (1980); Hairer, Norsett, Wanner, Solving Ordinary
/// Differential Equations I (1993), II.4 and II.5.
template <class State, class Slope, class Settle>
bool integrate(const Slope& f, State& y, double duration, const IntegrationTolerance& tolerance,
               IntegrationRecord& record, const Settle& settle) {
  require_number("duration", duration, not_negative);
  State k1 = y, k2 = y, k3 = y, k4 = y, k5 = y, k6 = y, k7 = y, next = y, error = y;
  f(y, k1);
  const auto scaled = [&](const State& v, const State& at) {
    return v.norm() / (tolerance.absolute + tolerance.relative * at.norm());
  };
  double h = record.next_step;
  if (!(h > 0)) {
    const double change = k1.norm() / y.norm();
    h = change > 0 ? 0.1 * std::pow(tolerance.absolute + tolerance.relative, 0.2) / change : duration;
  }
  double done = 0;
  for (std::int64_t step = 0; done < duration; ++step) {
    if (step >= tolerance.most_steps || !(h > 1e-14 * duration)) return false;
    const bool last = done + h >= duration;
    const double wanted = h;
    if (last) h = duration - done;
    f(next = y + h * (1.0 / 5 * k1), k2);
    f(next = y + h * (3.0 / 40 * k1 + 9.0 / 40 * k2), k3);
    f(next = y + h * (44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3), k4);
    f(next = y + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3 - 212.0 / 729 * k4),
      k5);
    f(next = y + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4 -
                      5103.0 / 18656 * k5),
      k6);
    next = y +
           h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 + 11.0 / 84 * k6);
    f(next, k7);
    error = h * (71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 - 17253.0 / 339200 * k5 +
                 22.0 / 525 * k6 - 1.0 / 40 * k7);
    const double size = scaled(error, next);
    const bool accept = size <= 1;
    if (accept) {
      y = next;
      k1 = k7;
      if (settle(y)) f(y, k1);
      done = last ? duration : done + h;
      ++record.accepted;
    } else {
      ++record.rejected;
    }
    const double factor =
        size > 0 ? std::clamp(0.9 * std::pow(size, -0.2), 0.2, 5.0) : (size == 0 ? 5.0 : 0.2);
    // A step cut short by the end says little about the next interval.
    h = accept && last ? std::max(wanted, h * factor) : h * factor;
    record.next_step = h;
  }
  return true;
}

}  // namespace fiberfate
