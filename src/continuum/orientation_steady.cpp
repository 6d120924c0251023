// Newton's method for steady orientations.
#include "continuum/orientation_steady.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/principal_axes_steps.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {
namespace {

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

constexpr int most_iterations = 400;
/// Steps of the implicit Euler method in units of strain: the first, and how much longer the next may be.
constexpr double first_step = 0.1, most_growth = 10;
/// Change of A2 at which Newton's method has converged, and the rate (over the shear rate) that the round-off
/// of the closures' polynomials may leave.
constexpr double converged_change = 1e-13, round_off_rate = 1e-9;
constexpr double difference_step = 1e-6;
/// Decay per unit of strain below which a state counts as not isolated: differences err by about 1e-9.
constexpr double marginal_decay = 1e-6;
/// A closure that errs may place its steady state this far outside; integrators put such states back.
constexpr double tolerated_negative_value = 1e-9;
/// States nearer to each other than this are one, which a flat minimum gives less precisely; principal values
/// nearer than the second are equal.
constexpr double same_state = 1e-4, equal_values = 1e-6;

/// Orthonormal basis of the symmetric tensors without trace.
const std::array<Mat3, 5>& basis() {
  static const std::array<Mat3, 5> tensors = [] {
    std::array<Mat3, 5> all;
    all.fill(Mat3::Zero());
    const double half = std::sqrt(0.5), sixth = std::sqrt(1.0 / 6);
    all[0].diagonal() << half, -half, 0;
    all[1].diagonal() << sixth, sixth, -2 * sixth;
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = static_cast<int>(k), j = (i + 1) % 3;
      all[2 + k](i, j) = all[2 + k](j, i) = half;
    }
    return all;
  }();
  return tensors;
}

Mat3 state_of(const Vec5& x) {
  Mat3 second = Mat3::Identity() / 3;
  for (std::size_t k = 0; k < 5; ++k) second += x[static_cast<int>(k)] * basis()[k];
  return second;
}

Vec5 coordinates_of(const Mat3& tensor) {
  Vec5 x;
  for (std::size_t k = 0; k < 5; ++k) x[static_cast<int>(k)] = double_dot(tensor, basis()[k]);
  return x;
}

/// The rate of a law without retardation, over the shear rate.
class Rate {
 public:
  Rate(const OrientationModel& model, const Mat3& gradient, double shear_rate)
      : law_(unretarded(model)), gradient_(gradient / shear_rate) {}

  [[nodiscard]] Vec5 operator()(const Vec5& x) const {
    return coordinates_of(law_.unchecked_rate(state_of(x), gradient_));
  }
  [[nodiscard]] Mat5 jacobian(const Vec5& x) const {
    Mat5 columns;
    for (int k = 0; k < 5; ++k) {
      const Vec5 aside = difference_step * Vec5::Unit(k);
      columns.col(k) = ((*this)(x + aside) - (*this)(x - aside)) / (2 * difference_step);
    }
    return columns;
  }

 private:
  OrientationLaw law_;
  Mat3 gradient_;
};

/// Follows one start to where nothing changes; nothing when it settles nowhere.
std::optional<Vec5> settled(const Rate& rate, Vec5 x) {
  double step = first_step, before = rate(x).norm();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Vec5 now = rate(x);
    const Vec5 change = (Mat5::Identity() / step - rate.jacobian(x)).partialPivLu().solve(now);
    if (!change.allFinite()) return std::nullopt;
    if (now.norm() < round_off_rate && change.norm() < std::max(converged_change, 1e-3 * now.norm()))
      return x;
    const Vec5 next = coordinates_of(nearest_admissible(state_of(x + change)));
    // Once near, Newton's own step counts: a state that a closure places slightly outside is found, too.
    x = step > 1e6 ? Vec5(x + change) : next;
    const double after = rate(x).norm();
    if (step > 1e6 && now.norm() < round_off_rate && !(after < 0.5 * now.norm())) return x;
    step = std::clamp(step * std::min(most_growth, before / std::max(after, 1e-300)), 1e-3, 1e12);
    before = after;
  }
  return std::nullopt;
}

std::vector<Vec5> starts(const Mat3& strain) {
  const Mat3 axes = eigenframe(strain).axes;
  std::vector<Vec5> all = {Vec5::Zero()};
  for (int i = 0; i < 3; ++i) {
    for (const double value : {0.8, 0.1}) {  // aligned with an axis, planar across it
      Vec3 values = Vec3::Constant((1 - value) / 2);
      values[i] = value;
      all.push_back(coordinates_of(axes * values.asDiagonal() * axes.transpose()));
    }
  }
  return all;
}

/// Factor by which a retardation slows down small changes of the principal values near a steady state.
double slowness(const OrientationModel& model) {
  return description_of(model.retardation).slowness(model.constants);
}

/// Growth rate of the fastest disturbance over the shear rate, of the law with its retardation.
double growth(const OrientationModel& model, const Rate& rate, const Vec5& x) {
  Mat5 jacobian = rate.jacobian(x);
  const Eigenframe frame = eigenframe(state_of(x));
  const double gap = std::min(frame.values[0] - frame.values[1], frame.values[1] - frame.values[2]);
  if (!acts_on_principal_values(model.retardation)) jacobian *= slowness(model);
  if (acts_on_principal_values(model.retardation) && gap > equal_values) {
    // The part along the axes is slowed down; beside equal values a disturbance makes its own axes.
    Mat5 retarded;
    for (int k = 0; k < 5; ++k) {
      Mat3 inside = frame.axes.transpose() * (state_of(jacobian.col(k)) - Mat3::Identity() / 3) * frame.axes;
      inside.diagonal() *= slowness(model);
      retarded.col(k) = coordinates_of(frame.axes * inside * frame.axes.transpose());
    }
    jacobian = retarded;
  }
  const double fastest = Eigen::EigenSolver<Mat5>(jacobian, false).eigenvalues().real().maxCoeff();
  return acts_on_principal_values(model.retardation) && !(gap > equal_values) ? slowness(model) * fastest
                                                                              : fastest;
}

std::string words_for(const Mat3& a) {
  return fmt::format("A11 {:.4f}, A22 {:.4f}, A33 {:.4f}", a(0, 0), a(1, 1), a(2, 2));
}

/// Whether one direction outgrows all others in the flow alone, so that fibers without diffusion align with
/// it: that of the eigenvalue of W + xi D with the largest real part. In shear there is none.
bool flow_aligns(const OrientationModel& model, const Mat3& gradient, double shear_rate) {
  const Mat3 spin = 0.5 * (gradient - gradient.transpose()), strain = 0.5 * (gradient + gradient.transpose());
  const Mat3 stretching = (spin + model.constants.xi * strain) / shear_rate;
  Vec3 growth = Eigen::EigenSolver<Mat3>(stretching, false).eigenvalues().real();
  std::ranges::sort(growth);
  return growth[2] - growth[1] > marginal_decay;
}

/// Whether a state stands only by the error of a closure: where nothing spreads fibers and no direction
/// outgrows the others, every one of them has an orientation of its own or turns for ever.
bool is_of_closure(const OrientationModel& model, const Mat3& gradient, double shear_rate, const Vec5& x) {
  return model.constants.u0 == 0 && rotary_diffusion(model, state_of(x), gradient).isZero() &&
         !flow_aligns(model, gradient, shear_rate);
}

/// What the starts came to.
struct Found {
  std::vector<Vec5> stable;
  std::string fault;  ///< of a state that is not stable
};

void sort_in(const OrientationModel& model, const Rate& rate, const Vec5& x, Found& found) {
  const Mat3 second = state_of(x);
  const double least = eigenframe(second).values[2];
  if (least < -tolerated_negative_value) {
    found.fault = fmt::format(
        "the closure {} places it outside of what fibers can have (smallest principal value "
        "{:.2g}): take another closure",
        name(model.closure), least);
    return;
  }
  const double fastest = growth(model, rate, x);
  if (fastest > marginal_decay) {
    found.fault = fmt::format("that at {} is unstable: disturbances grow by {:.3g} a unit of strain",
                              words_for(second), fastest);
  } else if (fastest > -marginal_decay) {
    found.fault =
        fmt::format("that at {} is not isolated: without enough diffusion fibers align or turn for ever",
                    words_for(second));
  } else if (std::ranges::none_of(found.stable,
                                  [&](const Vec5& other) { return (other - x).norm() < same_state; })) {
    found.stable.push_back(x);
  }
}

void require_approach(const OrientationModel& model, double shear_rate) {
  if (!(shear_rate > 0))
    throw InputError("nothing deforms in this flow, so that every orientation stays (but for its turning)",
                     "give a velocity gradient with a rate of strain");
  if (!(slowness(model) > 0))
    throw InputError("this retardation holds the principal values for ever: every start keeps its own",
                     "choose kappa or srf above 0, or alpha below 1");
}

}  // namespace

SteadyOrientation steady_orientation(const OrientationModel& model, const Mat3& gradient) {
  require_admissible(model);
  require_numbers("gradient", gradient.reshaped(), {.lower = -1e100, .upper = 1e100});
  const Mat3 strain = 0.5 * (gradient + gradient.transpose());
  const double shear_rate = std::sqrt(2 * double_dot(strain, strain));
  require_approach(model, shear_rate);
  const Rate rate(model, gradient, shear_rate);
  Found found;
  for (const Vec5& start : starts(strain))
    if (const std::optional<Vec5> x = settled(rate, start)) sort_in(model, rate, *x, found);
  if (found.stable.empty())
    throw SimulationFailure("there is no steady orientation: " +
                                (found.fault.empty() ? "the state never settles in this flow" : found.fault),
                            {});
  const auto of_closure = std::ranges::find_if(
      found.stable, [&](const Vec5& x) { return is_of_closure(model, gradient, shear_rate, x); });
  if (of_closure != found.stable.end())
    throw SimulationFailure(
        fmt::format("there is no steady orientation: without diffusion fibers align or turn for ever in this "
                    "flow; that at {} stands by the error of the closure {}",
                    words_for(state_of(*of_closure)), name(model.closure)),
        {});
  if (found.stable.size() > 1)
    throw SimulationFailure(
        fmt::format(
            "the steady orientation depends on the start: {} and {} are both stable with the closure {}",
            words_for(state_of(found.stable[0])), words_for(state_of(found.stable[1])), name(model.closure)),
        {});
  const Vec5& x = found.stable.front();
  return {state_of(x), -shear_rate * growth(model, rate, x), shear_rate * rate(x).norm()};
}

}  // namespace fiberfate
