// Advances length distributions by the Phelps-Tucker model: any number of bins, one point or very many.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "continuum/length_classes.hpp"
#include "continuum/phelps.hpp"

namespace fiberfate {

/// Divides lengths into bins: bin i = 1 ... bins holds fibers of length i largest_length/bins. Children of a
/// fiber in a bin then fall exactly into bins, which is what conserves the length.
struct LengthBins {
  std::size_t bins = 100;
  double largest_length = 0;  ///< m

  /// Raises InputError unless there are 2 to most_bins bins and a length.
  void check() const;
  [[nodiscard]] double width() const { return largest_length / static_cast<double>(bins); }
  /// The length of the bin with this index, counted from 0, m.
  [[nodiscard]] double length(std::size_t index) const { return width() * static_cast<double>(index + 1); }
  /// The lengths of all bins, m.
  [[nodiscard]] std::vector<double> lengths() const;
};

/// Sorts a population into bins. A length between two bins is shared between them so that the number of
/// fibers and their total length are both kept (L_W then rises slightly, by at most a quarter of a squared
/// bin width over L_N); fibers shorter than the first bin enter it with their length. Raises InputError for
/// fibers longer than the last bin, and as LengthBins::check.
[[nodiscard]] std::vector<double> sort_into_bins(const LengthClasses& classes, const LengthBins& bins);

/// Solves dN_i/dt = -P_i N_i + sum_k R_ik N_k, with P from breakage_share and R from child_numbers.
///
/// A step in which the flow is constant is exact to 1e-14 of the events however long it is: the series
/// of PhelpsBlock, ended where its rest is below that, in as many equal parts as its weights need. Numbers
/// stay positive, fiber length is conserved to round-off, L_N and L_W never rise. Fibers of the first bin
/// cannot break, whatever Durin's rate says: their pieces have no bin, and length would be lost.
class PhelpsSolver {
 public:
  /// Raises InputError for constants that are not positive and finite, S below 0.005, and as
  /// LengthBins::check.
  PhelpsSolver(const PhelpsConstants& constants, const LengthBins& bins);

  /// The memory that a solver of so many bins takes, and each thread that uses it, bytes.
  [[nodiscard]] static double memory_bytes(std::size_t bins);
  [[nodiscard]] static double scratch_bytes(std::size_t bins);

  [[nodiscard]] const LengthBins& bins() const { return bins_; }
  [[nodiscard]] const PhelpsConstants& constants() const { return constants_; }

  /// Advances n points by `duration` s of constant flow. `numbers` is [bin][point], n points each.
  /// Runs on all threads, without allocating per point; the result does not depend on how many threads there
  /// are. Raises InputError, which names the point, for impossible flows or numbers before anything is
  /// changed, and SimulationFailure where fibers would break more often than can be followed.
  void advance(const LengthFlows& flows, double duration, std::span<double> numbers) const;
  /// Advances one point.
  void advance(const LengthFlow& flow, double duration, std::span<double> numbers) const;

  /// The breakage rate P of every bin, 1/s.
  [[nodiscard]] std::vector<double> breakage_rates(const LengthFlow& flow) const;
  /// Writes the breakage rates of n points, [bin][point] as the numbers, 1/s; nothing is allocated.
  void breakage_rates(const LengthFlows& flows, std::span<double> rates) const;

 private:
  struct Scratch;
  /// Returns false, and changes nothing, where fibers would break too often.
  bool advance_block(const LengthFlows& flows, double duration, std::size_t first_point,
                     std::span<double> numbers, Scratch& scratch) const;
  /// Fills the shares P/Q and returns the largest Q of the block's points, 1/s.
  double fill_shares(const LengthFlows& flows, std::size_t first_point, Scratch& scratch) const;

  PhelpsConstants constants_;
  LengthBins bins_;
  std::size_t padded_bins_;
  std::vector<double> fourth_powers_;  ///< of the bins' lengths, m^4
  std::vector<double> children_;       ///< packed for the kernel (PhelpsBlock::children)
};

}  // namespace fiberfate
