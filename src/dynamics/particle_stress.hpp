// Gives the stress that fibers add to the melt, and the power that they take, from the forces of a solved
// step.
#pragma once

#include <array>
#include <string_view>

#include "base/vector.hpp"
#include "dynamics/chain_solver.hpp"
#include "dynamics/contact_loads.hpp"
#include "fibers/state.hpp"

namespace fiberfate {

/// What a share of the particle stress comes from. Drag is that of the rods' thickness against spinning; what
/// the melt does along a fiber is its tension.
enum class StressCause { drag, tension, bending, contact, friction };
inline constexpr std::size_t stress_causes = 5;
[[nodiscard]] const char* name(StressCause cause);

/// Where the power goes that the flow spends on the fibers.
enum class PowerSink { drag, bending, contact, friction };
inline constexpr std::size_t power_sinks = 4;
[[nodiscard]] const char* name(PowerSink sink);

/// What fibers add to the melt, −P I + 2 eta D + stress, each volume of the cell (docs/theory/stress.md).
struct ParticleStress {
  Mat3 stress = Mat3::Zero();                ///< symmetric, tension positive, Pa
  std::array<Mat3, stress_causes> by_cause;  ///< adds up to `stress`, Pa
  std::array<double, power_sinks> power{};   ///< W/m³; elastic energy that is stored counts as spent
  double supplied_power = 0;                 ///< stress : D, W/m³
  Vec3 antisymmetric = Vec3::Zero();         ///< couples that the dropped torsion leaves over, Pa
  /// Mean square of what action and reaction differ by, and of the forces themselves, N²: how far the sweeps
  /// have converged.
  double unanswered = 0, answered = 0;

  ParticleStress() { by_cause.fill(Mat3::Zero()); }
  [[nodiscard]] const Mat3& of(StressCause cause) const { return by_cause[static_cast<std::size_t>(cause)]; }
  [[nodiscard]] double into(PowerSink sink) const { return power[static_cast<std::size_t>(sink)]; }
  [[nodiscard]] double spent_power() const;
  /// Adds `share` times another.
  void add(const ParticleStress& other, double share);
};

/// A step whose velocities are solved and whose fibers have not moved yet.
struct SolvedStep {
  const ChainProblem& problem;  ///< what was solved
  /// w that the solution gave, and λ.
  IndexedSpan<NodeIndex, const Vec3> velocity;
  IndexedSpan<RodIndex, const double> tension;
  const ContactLoads& loads;  ///< about problem.pair_velocity
};

/// Evaluates the particle stress. With F the force of the melt on a rod with centre c and S_r its stresslet,
/// X the centroid of a fiber and f the force of a contact on its first fiber, that of the second with the
/// image H n,
///   V sigma = sum over rods sym[(c − X) F] + S_r − sum over contacts sym[(X_1 − X_2 − H n) f]
/// The forces are those that balance in the solve, f the mean of its two sides: never the law evaluated anew.
/// Bitwise the same for any number of threads, and after a restart.
[[nodiscard]] ParticleStress particle_stress(const SolvedStep& step, const ChainLaws& laws);

}  // namespace fiberfate
