// Fits Weibull and log-normal laws to measured lengths, and reads their distributions by number and by
// length.
#pragma once

#include <optional>

#include "microstructure/length_statistics.hpp"

namespace fiberfate {

/// The families of laws that are fitted; both are by number.
enum class LengthFamily {
  weibull,    ///< P(L < x) = 1 − exp(−(x/scale)^shape)
  log_normal  ///< ln L is normal: exp of its mean is the scale, its standard deviation the shape
};

/// A law that was fitted.
struct FittedLengths {
  LengthFamily family = LengthFamily::weibull;
  double shape = 1;
  double scale = 1;  ///< m
};

/// Fits a law to a list by maximum likelihood, every fiber weighted by its number. Gives nothing where the
/// lengths are alike, so that no width can be told. Raises InputError as number_average.
[[nodiscard]] std::optional<FittedLengths> fit_lengths(LengthFamily family, const MeasuredLengths& fibers);

/// L_N of a law, m.
[[nodiscard]] double number_average(const FittedLengths& law);
/// L_W of a law, m.
[[nodiscard]] double weight_average(const FittedLengths& law);
/// The share of the fibers that are shorter than a length.
[[nodiscard]] double number_share_below(const FittedLengths& law, double length);
/// The share of the total length that shorter fibers have.
[[nodiscard]] double length_share_below(const FittedLengths& law, double length);

/// How a list's fibers or their total length are shared out among lengths.
enum class LengthWeight { number, length };

/// A list in the order of its lengths, with the shares of all fibers up to each.
class CumulativeLengths {
 public:
  /// Raises InputError as number_average.
  CumulativeLengths(const MeasuredLengths& fibers, LengthWeight weight);

  /// The share of what is not longer than a length.
  [[nodiscard]] double share_up_to(double length) const;
  /// The shortest length up to which at least a share lies, for a share in (0, 1].
  [[nodiscard]] double quantile(double share) const;
  /// The largest distance between the steps of the list and a law by number (Kolmogorov, Smirnov).
  [[nodiscard]] double distance(const FittedLengths& law) const;

 private:
  std::vector<double> lengths_, shares_;
};

}  // namespace fiberfate
