// Lays out one step of the Phelps-Tucker model for eight points at once, as the compiled kernels take it.
#pragma once

#include <cstddef>

#include "base/kernels.hpp"

namespace fiberfate {

/// Eight points that advance together. Arrays are [bin][8] and aligned to 64 bytes unless said
/// otherwise; bins are counted from 0 and `padded_bins` is the next multiple of 4. Rows beyond `bins` are
/// zero.
///
/// The step is exact for a constant flow. With Q the largest breakage rate of a point, dN/dt = R P N is
///   N(t) = sum_j w_j (I + R P/Q)^j N(0),   w_j = e^(-Qt) (Qt)^j/j!
/// (uniformisation). All terms are positive, so nothing cancels; weights that sum to one conserve the length
/// exactly wherever the series ends. Bins in which nothing breaks only collect: N_i += sum_k R_ik (P_k/Q) u_k
/// with u = sum_j W_j (I + R P/Q)^j N(0) and W_j = sum of the weights after j, which is Q times the integral
/// of N.
struct PhelpsBlock {
  const double* children;  ///< by four rows: the strictly upper part of those rows, column by column
  std::size_t bins;
  std::size_t padded_bins;
  std::size_t first_row;  ///< first row, a multiple of 4, in or above which something breaks in some point
  std::size_t terms;      ///< number of powers of the series
  const double* share;    ///< P/Q
  const double* weights;  ///< w_j, [terms + 1][8]
  const double* tails;    ///< W_j, [terms + 1][8], the last one zero
  double* numbers;        ///< N, in and out
  double* power;          ///< scratch: (I + R P/Q)^j N, what breaks next taken away
  double* broken;         ///< scratch: P/Q times that
  double* integral;       ///< scratch: u
};

FIBERFATE_DECLARE_KERNEL(void advance_phelps(const PhelpsBlock& block))

}  // namespace fiberfate
