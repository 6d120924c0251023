// Solves for the distribution of directions itself, with real spherical harmonics of even order: no closure.
#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "base/vector.hpp"
#include "continuum/orientation_model.hpp"
#include "continuum/runge_kutta.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Evolves psi(p, t) on the unit sphere,
///   d psi/dt = - div(psi p') + div(rate P·C·P grad psi),  p' = W·p + xi (D·p - (p·D·p) p),  P = I - p p,
/// whose second moment obeys the tensor equation of OrientationLaw with the exact A4. psi is expanded in the
/// real orthonormal harmonics of even degree up to `degree` (Galerkin). The moments converge exponentially
/// with the degree; a diffusion of strength C_I needs about 6 C_I^(-1/2).
///
/// Operators, with R = p × grad: advection by vorticity omega is -omega·R; since P·D·p = grad(q)/2 with q =
/// p·D·p, of degree 2 and Laplacian -6 q, advection by strain is
///   div(psi grad q) = (Lap(q psi) - 6 q psi - q Lap psi)/2,
/// and anisotropic diffusion is (tr C) Lap psi - div((p·C·p) grad psi) - R·C·R psi.
/// Retardation has no counterpart here: models with one (or with a potential) raise InputError, as does a
/// diffusion tensor that is indefinite, for which the equation has no solution. Source: Bird et al., Dynamics
/// of Polymeric Liquids 2 (1987), 14.2; Phelps, Tucker (2009), eq. 12, for diffusion.
class FokkerPlanck {
 public:
  /// Raises InputError unless `degree` is even and 4 to 200.
  FokkerPlanck(const OrientationModel& model, int degree);

  /// Number of coefficients, (degree + 1)(degree + 2)/2; the first is that of the constant.
  [[nodiscard]] int size() const { return static_cast<int>(laplacian_.size()); }

  /// Coefficients of the isotropic distribution, psi = 1/(4 pi).
  [[nodiscard]] Eigen::VectorXd isotropic() const;
  /// Coefficients of a distribution of the given A2: that into which Jeffery's motion carries the isotropic
  /// one, psi = (p·B·p)^(-3/2)/(4 pi), whose A4 is that of the exact closure. Raises InputError where A2 is
  /// not admissible, has a principal value below 1e-9 (psi would be singular), or is too aligned for the
  /// degree.
  [[nodiscard]] Eigen::VectorXd with_second_moment(const Mat3& second) const;
  /// A2 and A4 of a distribution.
  [[nodiscard]] Mat3 second_moment(const Eigen::VectorXd& psi) const;
  [[nodiscard]] Mat6 fourth_moment(const Eigen::VectorXd& psi) const;
  /// psi in one direction, 1/sr.
  [[nodiscard]] double density(const Eigen::VectorXd& psi, const Vec3& direction) const;

  /// Size of the coefficients of the two highest degrees over that of the constant: how far the harmonics are
  /// from resolving the distribution.
  [[nodiscard]] double tail(const Eigen::VectorXd& psi) const;

  /// The equation in one velocity gradient, which costs as much to set up as many steps.
  struct InFlow {
    Mat3 gradient = Mat3::Zero();          ///< 1/s
    Eigen::SparseMatrix<double> constant;  ///< of the rate, the part that does not depend on the distribution
  };
  /// Sets the equation up in a gradient. Raises InputError for an indefinite diffusion tensor.
  [[nodiscard]] InFlow in_flow(const Mat3& gradient) const;

  /// Advances a distribution by `duration` (s) in a constant velocity gradient (1/s). Raises
  /// SimulationFailure when the step size falls to nothing, or when the distribution has become too sharp for
  /// the harmonics: its moments would be wrong.
  void advance(Eigen::VectorXd& psi, const Mat3& gradient, double duration,
               const IntegrationTolerance& tolerance) const;
  /// Does the same where the flow is set up already.
  void advance(Eigen::VectorXd& psi, const InFlow& flow, double duration,
               const IntegrationTolerance& tolerance) const;

  /// Finds the distribution that does not change in a constant velocity gradient; iterates where C depends on
  /// A2. Raises SimulationFailure when there is none (no diffusion, or no convergence in 200 iterations), or
  /// when the harmonics do not resolve it.
  [[nodiscard]] Eigen::VectorXd steady(const Mat3& gradient) const;

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  [[nodiscard]] bool has_fixed_diffusion() const;
  [[nodiscard]] Sparse flow_operator(const Mat3& gradient) const;
  [[nodiscard]] Sparse diffusion_operator(const Mat3& diffusion) const;
  void follow(Eigen::VectorXd& psi, const InFlow& flow, double duration,
              const IntegrationTolerance& tolerance) const;
  void require_resolved(const Eigen::VectorXd& psi) const;
  void require_distribution(const Eigen::VectorXd& psi, const Mat3& gradient) const;
  [[nodiscard]] Mat3 diffusion_at(const Eigen::VectorXd& psi, const Mat3& gradient) const;

  OrientationModel model_;
  int degree_;
  std::array<Sparse, 3> rotation_;  ///< R_i
  std::array<Sparse, 6> product_;   ///< multiplication by p_i p_j
  Eigen::VectorXd laplacian_;       ///< -l (l + 1)
};

}  // namespace fiberfate
