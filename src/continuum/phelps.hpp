// States the Phelps-Tucker model of fiber attrition: how often a fiber of a length breaks, and into which
// pieces.
#pragma once

#include <span>
#include <vector>

#include "continuum/length_flow.hpp"
#include "continuum/phelps_breakage.hpp"

namespace fiberfate {

/// How the breakage rate grows: P/(C_B rate) in [0, 1] over B = (L/L_ub)^4 times the compression, for B > 0.
using BreakageShare = double (*)(double buckling_number);

/// The constants of the model.
struct PhelpsConstants {
  double breakage_coefficient = 0;  ///< C_B, 1
  double drag_coefficient = 0;      ///< zeta, 1
  double spread = 0;                ///< S: standard deviation of a child's length over the parent's length, 1
  double modulus = 0;               ///< E_f of the fiber, Pa
  double diameter = 0;              ///< d_f of the fiber, m
  double unbreakable_length = 0;    ///< L_ub, m, when it is given; 0 computes it from the flow
  BreakageShare share = PhelpsBreakage::share;
};

/// The unbreakable length L_ub = (pi^3 E_f d_f^4/(4 zeta eta rate))^(1/4), m: the length at which the
/// drag on a fiber in the most compressed direction of the flow equals its Euler buckling load. Infinite
/// without flow. Raises InputError for an impossible flow. Source: Phelps, Abd El-Rahman, Kunc, Tucker, "A
/// model for fiber length attrition in injection-molded long-fiber composites", Composites A 51 (2013) 11;
/// thesis (2.7), (2.8).
[[nodiscard]] double unbreakable_length(const PhelpsConstants& constants, const LengthFlow& flow);

/// 1/L_ub^4, 1/m^4, times the compression, which is what the rates below are computed from: 0 without
/// flow.
[[nodiscard]] double buckling_coefficient(const PhelpsConstants& constants, const LengthFlow& flow);

/// P/(C_B rate) in [0, 1] of a fiber whose buckling number is B; 0 where nothing presses on it.
[[nodiscard]] inline double breakage_share(const PhelpsConstants& constants, double buckling_number) {
  return buckling_number > 0 ? constants.share(buckling_number) : 0;
}

/// More bins than these gain nothing: their matrix of children (half of bins² numbers) would take gigabytes.
inline constexpr std::size_t most_bins = 20000;

/// Fills one column of child_numbers: the children of lengths 1 to k-1 of a parent of length k >= 2, in bins.
void fill_children(std::size_t parent_bins, double spread, std::span<double> children);

/// Raises InputError for fewer than two bins, more than most_bins (with the memory that they would take), or
/// a spread S below 0.005.
void require_child_bins(std::size_t bins, double spread);

/// The mean number of children of each length that a broken fiber leaves: element [i-1 + (k-1) bins] is
/// that of length i, in bins, from a parent of length k. A Gaussian of standard deviation S k around k/2, cut
/// at 1 and k-1 and scaled so that two children, and the parent's whole length, result. A fiber of length 1
/// cannot break: its column is zero. Column-major, bins x bins, strictly upper triangular. Raises InputError
/// as require_child_bins (below S = 0.005 the Gaussian falls between the bins).
[[nodiscard]] std::vector<double> child_numbers(std::size_t bins, double spread);

}  // namespace fiberfate
