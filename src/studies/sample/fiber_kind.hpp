// What one kind of fibers is: lengths, diameter, stiffness, density and rods.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"
#include "packing/population.hpp"

namespace fiberfate {

/// The smooth laws of length.
enum class LengthDistributionLaw { weibull, log_normal };

/// [fibers.length_distribution]: a smooth law by its two means.
struct LengthDistributionChoices {
  LengthDistributionLaw law = LengthDistributionLaw::weibull;
  std::optional<double> number_average;  ///< L_N, m; not given: no such law is asked for
  std::optional<double> weight_average;  ///< L_W, m
};

/// One kind of fibers. One of length, lengths, length_histogram and length_distribution is given.
struct FiberKind {
  std::optional<double> length;              ///< of every fiber, m
  std::vector<std::vector<double>> lengths;  ///< rows of one measured length, m
  LengthHistogram length_histogram;
  LengthDistributionChoices length_distribution;
  double diameter = 0;               ///< m
  double youngs_modulus = 0;         ///< Pa
  std::optional<double> density;     ///< kg/m³
  std::optional<double> rod_length;  ///< target; a fiber is cut in equal rods nearest to it, m
};

/// The keys of a kind that stand in its table itself: all but its laws of length.
[[nodiscard]] const KeyRows<FiberKind>& fiber_kind_rows();
/// Adds the tables of a kind's laws of length: [table.length_histogram] and [table.length_distribution].
void describe_length_laws(KeyTable& keys, const std::string& table, FiberKind& kind);

/// The keys by which the kind in `table` may give its lengths.
[[nodiscard]] std::vector<std::string> length_keys(const std::string& table);
/// Finds what contradicts what in the kind that `table` describes.
void validate_fiber_kind(const FiberKind& kind, const std::string& table, CaseChecker& checker);

/// The law of the lengths of a kind.
[[nodiscard]] LengthLaw length_law(const FiberKind& kind);
/// The material of a kind.
[[nodiscard]] FiberMaterial material(const FiberKind& kind);

}  // namespace fiberfate
