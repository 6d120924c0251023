// Lets lengths decay towards an unbreakable length: the equation that the length laws without bins share.
#pragma once

#include <memory>
#include <span>

#include "base/number_checks.hpp"
#include "continuum/length_flow.hpp"

namespace fiberfate {

/// The coefficients of DL/Dt = -k_f max(0, L - L_inf) at a point (thesis 4.5).
struct LengthRelaxation {
  double rate_constant = 0;       ///< k_f, 1/s, not negative
  double equilibrium_length = 0;  ///< L_inf, m; infinite where nothing breaks
};

/// The length after `duration` s of constant flow, exactly: L_inf + (L - L_inf) exp(-k_f t)
/// (thesis 5.7). A fiber that is already at or below L_inf keeps its length. The result neither exceeds
/// `length` nor undershoots L_inf, round-off included. Raises InputError for a length or duration that is
/// negative or not finite.
[[nodiscard]] double relax_length(double length, const LengthRelaxation& relaxation, double duration);

/// Gives k_f and L_inf from the flow; one call handles many points.
class RelaxationLaw {
 public:
  RelaxationLaw() = default;
  RelaxationLaw(const RelaxationLaw&) = delete;
  RelaxationLaw& operator=(const RelaxationLaw&) = delete;
  virtual ~RelaxationLaw() = default;

  /// Evaluates the law at one point. Raises InputError for an impossible flow, as `evaluate` does.
  [[nodiscard]] virtual LengthRelaxation at(const LengthFlow& flow) const = 0;
  /// Evaluates the law at n points: `rate_constants` (1/s) and `equilibrium_lengths` (m) have n elements
  /// each.
  virtual void evaluate(const LengthFlows& flows, std::span<double> rate_constants,
                        std::span<double> equilibrium_lengths) const = 0;
};

/// Makes a RelaxationLaw of a functor `LengthRelaxation operator()(const LengthFlow&) const`, so that the
/// loop over points exists once and calls the functor inline.
template <class Formula>
class RelaxationLawOf final : public RelaxationLaw {
 public:
  explicit RelaxationLawOf(const Formula& formula) : formula_(formula) {}
  [[nodiscard]] LengthRelaxation at(const LengthFlow& flow) const override {
    flow.check();
    return formula_(flow);
  }
  void evaluate(const LengthFlows& flows, std::span<double> rate_constants,
                std::span<double> equilibrium_lengths) const override {
    flows.check();
    require_same_size("rate_constants", rate_constants.size(), flows.size());
    require_same_size("equilibrium_lengths", equilibrium_lengths.size(), flows.size());
    for (std::size_t i = 0; i < flows.size(); ++i) {
      const LengthRelaxation relaxation = formula_(flows[i]);
      rate_constants[i] = relaxation.rate_constant;
      equilibrium_lengths[i] = relaxation.equilibrium_length;
    }
  }

 private:
  Formula formula_;
};

/// Advances lengths at n points by `duration` s in which the flow at each point is constant.
/// `lengths` (m) is [class][point]: any number of initial-length classes (one for a mean length), n points
/// each. Runs on all threads; the result does not depend on how many there are. Raises InputError, which
/// names the point, for impossible flows or lengths, before anything is changed.
void relax_lengths(const RelaxationLaw& law, const LengthFlows& flows, double duration,
                   std::span<double> lengths);

}  // namespace fiberfate
