// Assembles and solves the Fokker-Planck equation of directions.
#include "continuum/fokker_planck.hpp"

#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/spherical_harmonics.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/eigenframe.hpp"
#include "microstructure/exact_closure.hpp"

namespace fiberfate {
namespace {

constexpr int most_iterations = 200;
constexpr int most_degree = 200;
/// Tail above which harmonics do not resolve a distribution. A2 errs by about a hundredth of the tail's
/// square (measured in shear for C_I from 0.001 to 0.03), which is 3e-5 here.
constexpr double unresolved_tail = 0.05;
/// Change of A2 at which the iteration over C(A2) has converged.
constexpr double converged = 1e-12;

}  // namespace

FokkerPlanck::FokkerPlanck(const OrientationModel& model, int degree) : model_(model), degree_(degree) {
  require_admissible(model);
  if (model.retardation != Retardation{} || model.constants.u0 != 0)
    throw InputError("a retardation or a potential acts on A2, not on the distribution of directions",
                     "choose retardation none and u0 = 0");
  if (degree < 4 || degree > most_degree || degree % 2 != 0)
    throw InputError(fmt::format("the degree {} is impossible", degree),
                     "choose an even number from 4 to 200");
  HarmonicOperators operators = harmonic_operators(degree);
  rotation_ = std::move(operators.rotation);
  product_ = std::move(operators.product);
  laplacian_ = std::move(operators.laplacian);
}

Eigen::VectorXd FokkerPlanck::isotropic() const {
  Eigen::VectorXd psi = Eigen::VectorXd::Zero(size());
  psi[0] = 1 / std::sqrt(4 * pi);
  return psi;
}

Eigen::VectorXd FokkerPlanck::with_second_moment(const Mat3& second) const {
  const Eigenframe frame = eigenframe(second);
  Vec3 shape;
  if (!fault_of(second, 1e-6).empty() || !(frame.values[2] > 1e-9) ||
      !find_exact_shape(frame.values.data(), shape.data()))
    throw InputError("no smooth distribution of directions has this orientation tensor",
                     "give three principal values above zero whose sum is 1");
  // F = exp(G) carries directions so that B = (F Fᵀ)⁻¹.
  const Mat3 gradient =
      frame.axes * (-0.5 * shape.array().log()).matrix().asDiagonal() * frame.axes.transpose();
  Eigen::VectorXd psi = isotropic();
  const FokkerPlanck jeffery({}, degree_);
  jeffery.follow(psi, jeffery.in_flow(gradient), 1, {.absolute = 1e-12, .relative = 1e-12});
  if ((second_moment(psi) - second).norm() > 1e-5 || tail(psi) > unresolved_tail)
    throw InputError(fmt::format("harmonics up to degree {} do not resolve so aligned a state", degree_),
                     "raise the degree");
  return psi;
}

Mat3 FokkerPlanck::second_moment(const Eigen::VectorXd& psi) const {
  Vec6 moment;
  for (int m = 0; m < 6; ++m) moment[m] = std::sqrt(4 * pi) * product_[m].row(0).dot(psi);
  return to_matrix(moment);
}

Mat6 FokkerPlanck::fourth_moment(const Eigen::VectorXd& psi) const {
  Mat6 moment;
  for (int n = 0; n < 6; ++n) {
    const Eigen::VectorXd weighted = product_[n] * psi;
    moment.col(n) = to_components(second_moment(weighted));
  }
  return moment;
}

double FokkerPlanck::density(const Eigen::VectorXd& psi, const Vec3& direction) const {
  return harmonics_at(direction, degree_).dot(psi);
}

double FokkerPlanck::tail(const Eigen::VectorXd& psi) const {
  // Coefficients of the degrees `degree` - 2 and `degree` are the last ones.
  const int last = (2 * degree_ + 1) + (2 * degree_ - 3);
  return psi.tail(last).norm() / std::abs(psi[0]);
}

void FokkerPlanck::require_resolved(const Eigen::VectorXd& psi) const {
  const double unresolved = tail(psi);
  if (unresolved <= unresolved_tail) return;
  throw SimulationFailure(
      fmt::format("harmonics up to degree {} do not resolve the distribution of directions: their last "
                  "coefficients are {:.2g} of the first{}",
                  degree_, unresolved,
                  degree_ < most_degree ? "; raise the degree" : ": it is too sharp for harmonics"),
      {});
}

void FokkerPlanck::require_distribution(const Eigen::VectorXd& psi, const Mat3& gradient) const {
  require_same_size("psi", psi.size(), size());
  require_numbers("psi", psi, any_finite);
  require_number("psi[0]", psi[0], positive);
  require_numbers("gradient", gradient.reshaped(), any_finite);
}

FokkerPlanck::Sparse FokkerPlanck::flow_operator(const Mat3& gradient) const {
  const Vec3 omega = 0.5 * Vec3(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                                gradient(1, 0) - gradient(0, 1));
  Sparse result(size(), size());
  for (int i = 0; i < 3; ++i) result -= omega[i] * rotation_[i];
  Vec6 strain = to_components(gradient);
  strain.head<3>().array() -= strain.head<3>().mean();  // an isotropic part does not turn fibers
  Sparse q(size(), size());
  for (int m = 0; m < 6; ++m) q += multiplicity_of[m] * strain[m] * product_[m];
  const Sparse after = laplacian_.asDiagonal() * q, before = q * laplacian_.asDiagonal();
  result -= (0.25 * model_.constants.xi) * (after - before - 6 * q);
  return result;
}

FokkerPlanck::Sparse FokkerPlanck::diffusion_operator(const Mat3& diffusion) const {
  const Vec6 c = to_components(diffusion);
  Sparse q(size(), size()), turn(size(), size());
  for (int m = 0; m < 6; ++m) {
    q += multiplicity_of[m] * c[m] * product_[m];
    const Sparse& first = rotation_[row_of[m]];
    const Sparse& second = rotation_[column_of[m]];
    turn += (0.5 * multiplicity_of[m] * c[m]) * Sparse(first * second + second * first);
  }
  const double mean = diffusion.trace() / 3;
  Sparse identity(size(), size());
  identity.setIdentity();
  const Sparse laplacian = laplacian_.asDiagonal() * identity;
  q -= mean * identity;
  // div(q grad psi) of a q of degree 2, and of its mean.
  const Sparse spread = mean * laplacian + 0.5 * Sparse(laplacian * q + q * laplacian + 6 * q);
  return diffusion.trace() * laplacian - spread - turn;
}

Mat3 FokkerPlanck::diffusion_at(const Eigen::VectorXd& psi, const Mat3& gradient) const {
  const Mat3 strain = 0.5 * (gradient + gradient.transpose());
  const double rate = std::sqrt(2 * double_dot(strain, strain));
  const Mat3 diffusion = rate * rotary_diffusion(model_, second_moment(psi), gradient);
  if (eigenframe(diffusion).values[2] < -1e-12 * rate)
    throw InputError(
        fmt::format("the rotary diffusion tensor of {} is indefinite in this flow, so that no distribution "
                    "function exists",
                    name(model_.diffusion)),
        "lower its anisotropy (C_M at most 3/4 covers every flow of iard)");
  return diffusion;
}

bool FokkerPlanck::has_fixed_diffusion() const {
  return !description_of(model_.diffusion).depends_on_orientation;
}

FokkerPlanck::InFlow FokkerPlanck::in_flow(const Mat3& gradient) const {
  require_numbers("gradient", gradient.reshaped(), any_finite);
  InFlow flow = {gradient, flow_operator(gradient)};
  if (has_fixed_diffusion()) flow.constant += diffusion_operator(diffusion_at(isotropic(), gradient));
  return flow;
}

void FokkerPlanck::advance(Eigen::VectorXd& psi, const Mat3& gradient, double duration,
                           const IntegrationTolerance& tolerance) const {
  advance(psi, in_flow(gradient), duration, tolerance);
}

void FokkerPlanck::advance(Eigen::VectorXd& psi, const InFlow& flow, double duration,
                           const IntegrationTolerance& tolerance) const {
  require_distribution(psi, flow.gradient);
  require_number("duration", duration, not_negative);
  require_number("tolerance", tolerance.absolute + tolerance.relative, positive);
  follow(psi, flow, duration, tolerance);
  require_resolved(psi);
}

void FokkerPlanck::follow(Eigen::VectorXd& psi, const InFlow& flow, double duration,
                          const IntegrationTolerance& tolerance) const {
  const bool fixed = has_fixed_diffusion();
  const auto slope = [&](const Eigen::VectorXd& at, Eigen::VectorXd& rate) {
    rate = flow.constant * at;
    if (!fixed) rate += diffusion_operator(diffusion_at(at, flow.gradient)) * at;
  };
  IntegrationRecord record;
  const auto settle = [](Eigen::VectorXd&) { return false; };
  if (!integrate(slope, psi, duration, tolerance, record, settle))
    throw SimulationFailure("the distribution of directions cannot be integrated within the tolerance",
                            {.step = record.accepted});
}

Eigen::VectorXd FokkerPlanck::steady(const Mat3& gradient) const {
  Eigen::VectorXd psi = isotropic();
  require_distribution(psi, gradient);
  const Sparse flow = flow_operator(gradient);
  Mat3 before = second_moment(psi);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Sparse whole = flow + diffusion_operator(diffusion_at(psi, gradient));
    // The first row is zero (psi is conserved) and the first coefficient known.
    const int rest = size() - 1;
    const Sparse inner = whole.bottomRightCorner(rest, rest);
    Eigen::SparseLU<Sparse> solver(inner);
    if (solver.info() != Eigen::Success)
      throw SimulationFailure(
          "there is no steady distribution of directions: without diffusion it never settles", {});
    psi.tail(rest) = solver.solve(Eigen::VectorXd(-whole.col(0).tail(rest) * psi[0]));
    const Mat3 now = second_moment(psi);
    if ((now - before).cwiseAbs().maxCoeff() < converged) {
      require_resolved(psi);
      return psi;
    }
    before = now;
  }
  throw SimulationFailure(
      fmt::format("the steady distribution did not settle in {} iterations", most_iterations), {});
}

}  // namespace fiberfate
