// Evaluates DA/Dt at eight points side by side; only kernels include it.
#pragma once

#include "continuum/orientation_laws/orientation_laws.hpp"
#include "continuum/orientation_model.hpp"
#include "microstructure/closure_pack.hpp"

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

/// Splits the velocity gradient of eight points: D, W and the rate sqrt(2 D:D).
struct LocalFlow {
  Symmetric strain;
  Antisymmetric vorticity;
  Pack rate;
  Pack inverse_rate;  ///< 0 where the rate is
};

/// Diffusion tensor times rate, split so that A4 : I = A need not be computed: rate C = isotropic I + rest.
struct LocalDiffusion {
  Pack isotropic;
  Symmetric rest;
};

FIBERFATE_INLINE LocalFlow split_gradient(const Pack (&l)[9]) {
  const Symmetric d = {l[0], l[4], l[8], 0.5 * (l[5] + l[7]), 0.5 * (l[2] + l[6]), 0.5 * (l[1] + l[3])};
  const Antisymmetric w = {0.5 * (l[1] - l[3]), 0.5 * (l[5] - l[7]), 0.5 * (l[6] - l[2])};
  const Pack rate = square_root(2.0 * double_dot(d, d));
  const Pack inverse = rate > 0.0 ? 1.0 / (rate > 0.0 ? rate : broadcast(1)) : broadcast(0);
  return {d, w, rate, inverse};
}

/// Where a rotary diffusion is evaluated.
struct Place {
  const LocalFlow& flow;
  const Symmetric& second;
  const Frame& frame;            ///< principal axes of A, where a law of the model reads them
  const Symmetric& unit_strain;  ///< D/rate, of order one however slow the flow
  const Symmetric& nothing;      ///< 0
};

/// rate R diag(d1, d2, d3) Rᵀ. At equal principal values of A the axes are those of D; where D has none
/// either, the mean of the constants keeps the answer independent of the frame of computation.
FIBERFATE_OUT_OF_LINE Symmetric along_axes(const Frame& frame, const LocalFlow& flow, double d1, double d2,
                                           double d3) {
  Pack strain[3];
  const Frame axes = guided_frame(frame, flow.strain, strain);
  const EqualPairs same = equal_pairs(frame.value, broadcast(equal_values));
  const EqualPairs aimless = equal_pairs(strain, equal_values * flow.rate);
  const Mask first = same.p12 & aimless.p12, last = same.p23 & aimless.p23;
  const Pack mean_12 = broadcast(0.5 * (d1 + d2)), mean_23 = broadcast(0.5 * (d2 + d3));
  const Pack mean = broadcast((d1 + d2 + d3) / 3);
  const Pack c1 = choose(first & last, mean, choose(first, mean_12, broadcast(d1)));
  const Pack c2 = choose(first & last, mean, choose(first, mean_12, choose(last, mean_23, broadcast(d2))));
  const Pack c3 = choose(first & last, mean, choose(last, mean_23, broadcast(d3)));
  const Pack zero = broadcast(0);
  return flow.rate * out_of_frame(axes, {c1, c2, c3, zero, zero, zero});
}

/// The arithmetic that kernels offer to orientation laws.
struct OrientationMath : ClosureMath {
  using Diffusion = LocalDiffusion;
  using Place = FIBERFATE_ISA::Place;

  [[gnu::always_inline]] static Symmetric along_axes(const Place& at, double d1, double d2, double d3) {
    return FIBERFATE_ISA::along_axes(at.frame, at.flow, d1, d2, d3);
  }
};

/// Takes what a law takes from the rates of the principal values, R diag(taken) Rᵀ, from the rate.
template <class Law>
FIBERFATE_INLINE Symmetric retarded_in_axes(const OrientationConstants& c, const Symmetric& rate,
                                            const Frame& frame) {
  Pack r[3];
  const Frame axes = guided_frame(frame, rate, r);
  const Pack zero = broadcast(0);
  return rate - out_of_frame(axes, {Law::taken(c, r[0], r[1], r[2]), Law::taken(c, r[1], r[2], r[0]),
                                    Law::taken(c, r[2], r[0], r[1]), zero, zero, zero});
}

template <class Law>
inline constexpr bool reads_axes = requires {
  Law::reads_axes;
}
|| requires {
  &Law::left;
};

FIBERFATE_INLINE bool needs_frame(const OrientationModel& model) {
  const auto asks = [](auto law) { return reads_axes<decltype(law)>; };
  return needs_frame(model.closure) ||
         visit_law<bool, OrientationMath, RotaryDiffusions>(static_cast<int>(model.diffusion), asks) ||
         visit_law<bool, OrientationMath, Retardations>(static_cast<int>(model.retardation), asks);
}

FIBERFATE_INLINE LocalDiffusion local_diffusion(const OrientationModel& model, const LocalFlow& flow,
                                                const Symmetric& a, const Frame& frame) {
  // Kept as a variable: where compilers know that the rest is 0 they round products of others otherwise.
  const Symmetric nothing = isotropic(broadcast(0));
  const Symmetric unit_strain = flow.inverse_rate * flow.strain;
  const Place at = {flow, a, frame, unit_strain, nothing};
  return visit_law<LocalDiffusion, OrientationMath, RotaryDiffusions>(
      static_cast<int>(model.diffusion), [&](auto law) __attribute__((always_inline)) {
        return decltype(law)::diffusion(model.constants, at);
      });
}

FIBERFATE_INLINE Symmetric retard(const OrientationModel& model, const Symmetric& rate, const Frame& frame) {
  return visit_law<Symmetric, OrientationMath, Retardations>(
      static_cast<int>(model.retardation), [&](auto law) __attribute__((always_inline)) {
        using Law = decltype(law);
        if constexpr (reads_axes<Law>)
          return retarded_in_axes<Law>(model.constants, rate, frame);
        else
          return Law::retarded(model.constants, rate);
      });
}

/// DA/Dt = W·A - A·W + xi (D·A + A·D - 2 A4:D) + rate [2 C - 2 tr C A - 5 (C·A + A·C) + 10 A4:C]
///         + 2 rate U_0 (A·A - A4:A), retarded. With G = xi D - 5 rate C all of A4 is one contraction.
FIBERFATE_OUT_OF_LINE Symmetric orientation_rate(const OrientationModel& model, const Symmetric& a,
                                                 const Pack (&l)[9]) {
  const LocalFlow flow = split_gradient(l);
  Frame frame{};
  if (needs_frame(model)) frame = find_frame(a);
  const LocalDiffusion c = local_diffusion(model, flow, a, frame);
  const Symmetric g = model.constants.xi * flow.strain - 5.0 * c.rest;
  const Pack potential = model.constants.u0 * flow.rate;
  const Symmetric closed = contract_closure(model.closure, a, frame, g + potential * a);
  Symmetric rate = spin(flow.vorticity, a) + anticommutator(g, a) - 2.0 * closed;
  rate = rate + 2.0 * (c.rest - trace(c.rest) * a) + c.isotropic * (isotropic(broadcast(2)) - 6.0 * a);
  if (model.constants.u0 != 0) rate = rate + (2.0 * potential) * square(a);
  rate = retard(model, rate, frame);
  const Pack drift = trace(rate) / 3.0;  // zero but for round-off
  return rate - isotropic(drift);
}

/// The rotary diffusion tensor C, without the rate: that of the flow scaled to a rate of one.
FIBERFATE_OUT_OF_LINE Symmetric rotary_diffusion_of(const OrientationModel& model, const Symmetric& a,
                                                    const Pack (&l)[9]) {
  LocalFlow flow = split_gradient(l);
  Frame frame{};
  if (needs_frame(model)) frame = find_frame(a);
  flow.strain = flow.inverse_rate * flow.strain;
  flow.rate = flow.inverse_rate = broadcast(1);
  const LocalDiffusion c = local_diffusion(model, flow, a, frame);
  return isotropic(c.isotropic) + c.rest;
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
