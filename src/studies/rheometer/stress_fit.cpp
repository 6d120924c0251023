// Fits laws of the stress that fibers add to readings of it.
#include "studies/rheometer/stress_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "calibration/student.hpp"
#include "continuum/anisotropic_stress.hpp"

namespace fiberfate {
namespace {

constexpr double level = 0.95;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_usable(const StressReading& one) {
  return one.viscosity > 0 && one.volume_fraction > 0 && one.strain_rate.squaredNorm() > 0 &&
         one.stress.allFinite() && one.fourth.allFinite() && std::isfinite(one.relative_viscosity);
}

FittedNumber with_interval(double value, double error, double degrees_of_freedom) {
  const double half = student_quantile(level, degrees_of_freedom) * error;
  return {value, error, value - half, value + half};
}

Mat3 deviator(const Mat3& tensor) {
  return tensor - tensor.trace() / 3 * Mat3::Identity();
}

/// What one reading adds to the sums of the fit of N_p.
struct Products {
  double stress_law = 0, law_law = 0, stress_stress = 0;
};

Products products_of(const StressReading& one) {
  const double rate = one.strain_rate.norm();
  const Mat3 stress = deviator(one.stress) / (2 * one.viscosity * one.volume_fraction * rate);
  const Mat3 law = deviator(contracted(one.fourth, one.strain_rate)) / rate;
  return {double_dot(stress, law), law.squaredNorm(), stress.squaredNorm()};
}

/// Sums of a linear regression.
struct Regression {
  double count = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0;
};

Regression regression_of(const std::vector<double>& x, const std::vector<double>& y) {
  Regression sums{static_cast<double>(x.size())};
  for (std::size_t i = 0; i < x.size(); ++i) {
    sums.mean_x += x[i] / sums.count;
    sums.mean_y += y[i] / sums.count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    sums.xx += (x[i] - sums.mean_x) * (x[i] - sums.mean_x);
    sums.xy += (x[i] - sums.mean_x) * (y[i] - sums.mean_y);
  }
  return sums;
}

}  // namespace

ParticleNumberFit fit_particle_number(std::span<const StressReading> readings) {
  std::vector<Products> all;
  for (const StressReading& one : readings)
    if (is_usable(one)) all.push_back(products_of(one));
  Products sum;
  for (const Products& one : all) {
    sum.stress_law += one.stress_law;
    sum.law_law += one.law_law;
    sum.stress_stress += one.stress_stress;
  }
  if (!(sum.law_law > 0)) return {{unknown, unknown, unknown, unknown}, unknown};
  const double value = sum.stress_law / sum.law_law;
  double variance = 0, squared_weights = 0;
  for (const Products& one : all) {
    const double weight = one.law_law / sum.law_law,
                 residual = (one.stress_law - value * one.law_law) / sum.law_law;
    variance += residual * residual / (1 - weight);
    squared_weights += weight * weight;
  }
  const double error = all.size() > 1 ? std::sqrt(variance) : unknown;
  return {with_interval(value, error, 1 / squared_weights - 1), value * sum.stress_law / sum.stress_stress};
}

bool TroutonFit::is_told() const {
  return trouton_term.upper - trouton_term.lower < std::abs(trouton_term.value);
}

double TroutonFit::at(double share) const {
  return viscosity_ratio.value * (1 + trouton_term.value * share);
}

TroutonFit fit_trouton_term(std::span<const StressReading> readings) {
  std::vector<double> x, y;
  for (const StressReading& one : readings) {
    if (!is_usable(one)) continue;
    x.push_back(stretching_share(one.strain_rate, one.fourth));
    y.push_back(one.relative_viscosity);
  }
  TroutonFit fit;
  fit.readings = x.size();
  fit.viscosity_ratio = fit.trouton_term = {unknown, unknown, unknown, unknown};
  fit.scatter = fit.least_share = fit.largest_share = unknown;
  if (x.empty()) return fit;
  fit.least_share = *std::min_element(x.begin(), x.end());
  fit.largest_share = *std::max_element(x.begin(), x.end());
  const Regression sums = regression_of(x, y);
  if (sums.count < 3 || !(sums.xx > 0)) return fit;
  const double slope = sums.xy / sums.xx, ordinate = sums.mean_y - slope * sums.mean_x;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(y[i] - ordinate - slope * x[i], 2);
  const double degrees_of_freedom = sums.count - 2, variance = squares / degrees_of_freedom;
  const double of_slope = variance / sums.xx, covariance = -sums.mean_x * of_slope,
               of_ordinate = variance / sums.count - sums.mean_x * covariance;
  const double term = slope / ordinate;
  const double of_term =
      (of_slope - 2 * term * covariance + term * term * of_ordinate) / (ordinate * ordinate);
  fit.scatter = std::sqrt(variance);
  fit.viscosity_ratio = with_interval(ordinate, std::sqrt(of_ordinate), degrees_of_freedom);
  fit.trouton_term = with_interval(term, std::sqrt(of_term), degrees_of_freedom);
  return fit;
}

}  // namespace fiberfate
