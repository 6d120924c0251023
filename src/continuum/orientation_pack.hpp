// Evaluates DA/Dt at eight points side by side; only kernels include it.
#pragma once

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

FIBERFATE_INLINE bool needs_frame(const OrientationModel& model) {
  return needs_frame(model.closure) || model.diffusion == RotaryDiffusion::pard ||
         model.diffusion == RotaryDiffusion::mrd || model.retardation == Retardation::rsc ||
         model.retardation == Retardation::rpr;
}

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

FIBERFATE_INLINE LocalDiffusion local_diffusion(const OrientationModel& model, const LocalFlow& flow,
                                                const Symmetric& a, const Frame& frame) {
  const OrientationConstants& c = model.constants;
  const Symmetric nothing = isotropic(broadcast(0));
  const Symmetric n = flow.inverse_rate * flow.strain;  // D/rate, of order one however slow the flow
  switch (model.diffusion) {
    case RotaryDiffusion::folgar_tucker:
      return {c.c_i * flow.rate, nothing};
    case RotaryDiffusion::ard:
      return {c.b1 * flow.rate, flow.rate * (c.b2 * a + c.b3 * square(a) + c.b4 * n + c.b5 * square(n))};
    case RotaryDiffusion::iard: {
      const Symmetric n2 = square(n);
      const Pack size = square_root(0.5 * double_dot(n2, n2));
      const Pack factor =
          size > 0.0 ? (c.c_i * c.c_m) * flow.rate / (size > 0.0 ? size : broadcast(1)) : broadcast(0);
      return {c.c_i * flow.rate, -factor * n2};
    }
    case RotaryDiffusion::pard:
      return {broadcast(0), c.c_i * along_axes(frame, flow, 1, c.omega, 1 - c.omega)};
    case RotaryDiffusion::mrd:
      return {broadcast(0), c.c_i * along_axes(frame, flow, c.d1, c.d2, c.d3)};
    case RotaryDiffusion::wpt:
      return {c.b1 * flow.rate, (c.b3 * flow.rate) * square(a)};
    default:
      return {broadcast(0), nothing};
  }
}

/// R diag(alpha (r_i - beta (r_i² + 2 r_j r_k))) Rᵀ, what the retardation takes from the rate.
FIBERFATE_INLINE Symmetric retarded_part(const Symmetric& rate, const Frame& frame, double alpha,
                                         double beta) {
  Pack r[3];
  const Frame axes = guided_frame(frame, rate, r);
  const Pack zero = broadcast(0);
  return out_of_frame(axes, {alpha * (r[0] - beta * (r[0] * r[0] + 2.0 * r[1] * r[2])),
                             alpha * (r[1] - beta * (r[1] * r[1] + 2.0 * r[2] * r[0])),
                             alpha * (r[2] - beta * (r[2] * r[2] + 2.0 * r[0] * r[1])), zero, zero, zero});
}

FIBERFATE_INLINE Symmetric retard(const OrientationModel& model, const Symmetric& rate, const Frame& frame) {
  const OrientationConstants& c = model.constants;
  switch (model.retardation) {
    case Retardation::rsc:
      return rate - retarded_part(rate, frame, 1 - c.kappa, 0);
    case Retardation::rpr:
      return rate - retarded_part(rate, frame, c.alpha, c.beta);
    case Retardation::srf:
      return c.srf * rate;
    default:
      return rate;
  }
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

}  // namespace fiberfate::FIBERFATE_ISA
#endif
