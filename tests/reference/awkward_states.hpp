// States of orientation at which laws and closures are most easily wrong.
#pragma once

#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Without, with two and with three equal principal values; nearly equal ones; planar, nearly planar, aligned
/// and nearly aligned states.
inline std::vector<Mat3> awkward_states() {
  std::vector<Mat3> states;
  for (const Vec3& values :
       {Vec3(0.6, 0.3, 0.1), Vec3(0.5, 0.25, 0.25), Vec3(0.4, 0.4, 0.2), Vec3(0.4, 0.4 - 1e-10, 0.2 + 1e-10),
        Vec3(1.0 / 3, 1.0 / 3, 1.0 / 3), Vec3(0.6, 0.4, 0), Vec3(0.6, 0.4 - 1e-7, 1e-7), Vec3(0.5, 0.5, 0),
        Vec3(1, 0, 0), Vec3(1 - 2e-13, 1e-13, 1e-13)})
    states.emplace_back(values.asDiagonal());
  return states;
}

}  // namespace fiberfate
