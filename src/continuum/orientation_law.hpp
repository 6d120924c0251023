// Evaluates and integrates orientation laws at single points and at many.
#pragma once

#include <string>
#include <vector>

#include "base/vector.hpp"
#include "continuum/orientation_model.hpp"
#include "continuum/orientation_points.hpp"

namespace fiberfate {

/// Evaluates one orientation law,
///   DA/Dt = W·A - A·W + xi (D·A + A·D - 2 A4:D) + rate [2 C - 2 tr(C) A - 5 (C·A + A·C) + 10 A4:C]
///           + 2 rate U_0 (A·A - A4:A),
/// retarded as the model says; D, W the symmetric and antisymmetric parts of L_ij = d v_i / d x_j, rate =
/// sqrt(2 D:D).
///
/// Units: L and DA/Dt in 1/s. States are symmetric with unit trace and without negative principal value: what
/// is further from that than forgiven_departure, or not finite, raises InputError that names the point. At D
/// = 0 only W acts. The rate is traceless to round-off. At equal principal values of A the retardation acts
/// in the axes of the rate itself (those of D for an isotropic state); pard and mrd take the axes of D there,
/// and the mean of their constants where D has no axes either. Sources: orientation_laws. Neglected:
/// Brownian motion, inertia, flexibility, variation of L over a fiber.
class OrientationLaw {
 public:
  /// Takes a model; raises InputError as require_admissible.
  explicit OrientationLaw(const OrientationModel& model);
  [[nodiscard]] const OrientationModel& model() const { return model_; }

  /// DA/Dt at one point.
  [[nodiscard]] Mat3 rate(const Mat3& second, const Mat3& gradient) const;
  /// The same for the stages of integrators, which pass through states slightly outside: nothing is checked.
  [[nodiscard]] Mat3 unchecked_rate(const Mat3& second, const Mat3& gradient) const;

  /// Writes DA/Dt of many points, on all threads; nothing is allocated. After an InputError the results are
  /// worthless.
  void evaluate(const OrientationPoints& points) const;

  /// Writes A2 after `step.duration` at constant gradients, on all threads; nothing is allocated. States that
  /// an approximate closure would leave slightly outside are returned to unit trace and no negative principal
  /// value. An InputError comes before anything is changed. Raises SimulationFailure, which names the point,
  /// when one needs more than `step.most_steps` internal steps; the results are worthless then.
  OrientationAdvance advance(const OrientationPoints& points, const OrientationStep& step) const;

 private:
  OrientationModel model_;
};

/// Rotary diffusion tensor C (without the rate) at one state; its trace over 3 is the equivalent C_I.
[[nodiscard]] Mat3 rotary_diffusion(const OrientationModel& model, const Mat3& second, const Mat3& gradient);

/// What is questionable about a law in a flow at a state: an indefinite diffusion tensor (as iARD's in
/// uniaxial flow for C_M > 3/4, for which no distribution function exists), a potential above 8 C_I. Empty
/// when nothing is.
[[nodiscard]] std::vector<std::string> doubts(const OrientationModel& model, const Mat3& second,
                                              const Mat3& gradient);

/// Shape factor (r²-1)/(r²+1); exactly 1 for an infinite aspect ratio. Raises InputError unless r > 0.
[[nodiscard]] double shape_factor(double aspect_ratio);

}  // namespace fiberfate
