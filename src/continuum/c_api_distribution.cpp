// The distribution of directions itself for C.
#include <Eigen/Core>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/c_api.hpp"
#include "continuum/fokker_planck.hpp"

using namespace fiberfate;

struct fiberfate_distribution {
  FokkerPlanck equation;
};

namespace {

Eigen::VectorXd coefficients(const fiberfate_distribution* distribution, const double* psi) {
  require_pointer(distribution, "distribution");
  require_pointer(psi, "psi");
  Eigen::VectorXd copy = Eigen::Map<const Eigen::VectorXd>(psi, distribution->equation.size());
  require_numbers("psi", copy, any_finite);
  return copy;
}

void write_coefficients(const Eigen::VectorXd& from, double* psi) {
  Eigen::Map<Eigen::VectorXd> to(psi, from.size());
  to = from;
}

}  // namespace

fiberfate_status fiberfate_distribution_create(const char* model, const fiberfate_constant* constants,
                                               size_t constant_count, int degree,
                                               fiberfate_distribution** distribution) {
  return guarded([&] {
    require_pointer(distribution, "distribution");
    *distribution = nullptr;
    // The closure is not used: A4 comes from the distribution.
    const OrientationModel chosen = model_of(model, "ibof", constants_at(constants, constant_count));
    *distribution = new fiberfate_distribution{FokkerPlanck(chosen, degree)};
  });
}

size_t fiberfate_distribution_size(const fiberfate_distribution* distribution) {
  return distribution == nullptr ? 0 : static_cast<size_t>(distribution->equation.size());
}

fiberfate_status fiberfate_distribution_start(const fiberfate_distribution* distribution,
                                              const double* orientation, double* psi) {
  return guarded([&] {
    require_pointer(distribution, "distribution");
    require_pointer(orientation, "orientation");
    require_pointer(psi, "psi");
    write_coefficients(distribution->equation.with_second_moment(tensor_at(orientation)), psi);
  });
}

fiberfate_status fiberfate_distribution_advance(const fiberfate_distribution* distribution,
                                                const double* gradient, double duration, double tolerance,
                                                double* psi) {
  return guarded([&] {
    Eigen::VectorXd state = coefficients(distribution, psi);
    require_pointer(gradient, "gradient");
    distribution->equation.advance(state, matrix_at(gradient), duration,
                                   {.absolute = tolerance, .relative = tolerance});
    write_coefficients(state, psi);
  });
}

fiberfate_status fiberfate_distribution_steady(const fiberfate_distribution* distribution,
                                               const double* gradient, double* psi) {
  return guarded([&] {
    require_pointer(distribution, "distribution");
    require_pointer(gradient, "gradient");
    require_pointer(psi, "psi");
    write_coefficients(distribution->equation.steady(matrix_at(gradient)), psi);
  });
}

fiberfate_status fiberfate_distribution_moments(const fiberfate_distribution* distribution, const double* psi,
                                                double* second, double* fourth) {
  return guarded([&] {
    const Eigen::VectorXd state = coefficients(distribution, psi);
    require_pointer(second, "second");
    write_tensor(distribution->equation.second_moment(state), second);
    if (fourth != nullptr) write_fourth(distribution->equation.fourth_moment(state), fourth);
  });
}

fiberfate_status fiberfate_distribution_density(const fiberfate_distribution* distribution, const double* psi,
                                                size_t n, const double* directions, double* densities) {
  return guarded([&] {
    const Eigen::VectorXd state = coefficients(distribution, psi);
    static_cast<void>(rows_at(directions, n, 3, "directions"));
    static_cast<void>(rows_at(densities, n, 1, "densities"));
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 direction(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]);
      if (!direction.allFinite() || !(direction.norm() > 0))
        throw InputError("a direction has no length", "give vectors other than zero");
      densities[i] = distribution->equation.density(state, direction);
    }
  });
}

void fiberfate_distribution_destroy(fiberfate_distribution* distribution) {
  delete distribution;
}
