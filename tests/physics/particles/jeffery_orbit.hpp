// States Jeffery's theory of a rigid particle of revolution in simple shear, and measures orbits against it.
#pragma once

#include <cmath>

#include "base/constants.hpp"
#include "scenes.hpp"

namespace fiberfate::jeffery {

/// Period T = 2 pi (r_e + 1/r_e) / rate of a particle of equivalent aspect ratio r_e (Jeffery 1922), s.
inline double period(double aspect_ratio, double rate) {
  return 2 * pi * (aspect_ratio + 1 / aspect_ratio) / rate;
}

/// Equivalent aspect ratio of a straight chain of M touching beads without hydrodynamic interaction:
/// its resistance to turning is 6 pi eta a³ M (M² − 1)/3 + 8 pi eta a³ M, of which the strain drives the
/// first part, so (r_e² − 1)/(r_e² + 1) = (M² − 1)/(M² + 3) and r_e = sqrt((M² + 1)/2).
inline double aspect_ratio_of_beads(double beads) {
  return std::sqrt((beads * beads + 1) / 2);
}

/// Orbit constant C = sqrt(p_y² + p_x²/r_e²) / p_z, constant in time for u_x = rate · y (Jeffery 1922).
inline double orbit_constant(const Vec3& p, double aspect_ratio) {
  return std::hypot(p.y(), p.x() / aspect_ratio) / p.z();
}

/// What a run of one fiber through half a turn about the vorticity axis shows.
struct MeasuredOrbit {
  double period = 0;                ///< twice the time of the half turn, s
  double orbit_constant_error = 0;  ///< largest relative change of the orbit constant on the way
};

/// Turns the fiber from where it crosses the plane p_x = 0 to where it crosses it again, half a period later.
/// The orbit constant is only followed when the fiber has a component along the vorticity.
inline MeasuredOrbit measure_half_turn(Simulation& simulation, double aspect_ratio) {
  MeasuredOrbit orbit;
  const Vec3 start = scenes::end_to_end(simulation.state()).normalized();
  const bool tilted = start.z() != 0;
  const double constant = tilted ? orbit_constant(start, aspect_ratio) : 1;
  double before = start.x();
  double time_before = simulation.state().time;
  for (bool left = false;;) {
    simulation.advance(1e9);
    const Vec3 p = scenes::end_to_end(simulation.state()).normalized();
    const double time = simulation.state().time;
    if (tilted) {
      const double error = std::abs(orbit_constant(p, aspect_ratio) / constant - 1);
      orbit.orbit_constant_error = std::max(orbit.orbit_constant_error, error);
    }
    if (left && before * p.x() <= 0) {
      orbit.period = 2 * (time_before + (time - time_before) * before / (before - p.x()));
      return orbit;
    }
    left = left || std::abs(p.x()) > 0.5 * std::hypot(p.x(), p.y());
    before = p.x();
    time_before = time;
  }
}

}  // namespace fiberfate::jeffery
