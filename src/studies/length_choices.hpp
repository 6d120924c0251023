// Fiber lengths at the start of a study that follows them by a length law, and how they are followed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "continuum/attrition_law.hpp"
#include "continuum/length_classes.hpp"
#include "io/csv_table.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"
#include "keys/law_choice.hpp"

namespace fiberfate {

/// [fibers] of attrition and calibration.
struct LengthChoices {
  std::optional<double> length;                   ///< of all fibers, m
  std::vector<std::vector<double>> distribution;  ///< rows (length m, number)
  std::optional<double> number_average;           ///< L_N, m
  std::optional<double> weight_average;           ///< L_W, m
  LengthForm form = LengthForm::distribution;
  ClassWeight weight = ClassWeight::length;
  std::int64_t bins = 100;
  std::optional<double> largest_length;  ///< of the bins, m
};

/// The keys of classes and means at the start, and of how lengths are followed.
[[nodiscard]] KeyRows<LengthChoices> initial_length_rows();
[[nodiscard]] KeyRows<LengthChoices> length_form_rows();

/// Whether no key of classes or means was given with a fault, so that what is missing was never given.
[[nodiscard]] bool lengths_are_read(const CaseChecker& checker);
/// Whether both or one of the means at the start is given.
[[nodiscard]] bool gives_means(const LengthChoices& fibers);
/// The laws that follow lengths in bins: "phelps and durin".
[[nodiscard]] std::string laws_of_bins();
/// Whether a law is one of them.
[[nodiscard]] bool needs_bins(const LawChoice& law);
/// Finds mean lengths of which one is missing, or that contradict each other.
void validate_mean_lengths(const LengthChoices& fibers, CaseChecker& checker);
/// Finds a distribution without fibers in fibers.distribution.
void validate_distribution(const std::vector<std::vector<double>>& rows, CaseChecker& checker);
/// Makes classes of rows (length m, number).
[[nodiscard]] LengthClasses length_classes(const std::vector<std::vector<double>>& rows);
/// Makes what the laws of length begin with.
[[nodiscard]] LengthStart length_start(const LengthChoices& fibers);

/// Tells how well bins place an unbreakable length, m, where that is worse than a share of it: half a bin.
/// zeta goes with its fourth power.
[[nodiscard]] std::string remark_on_bins(const LengthChoices& fibers, double unbreakable_length,
                                         double share);

/// Adds a row for each bin: what leads the row, the bin's edges, and its shares of the number and of the
/// total length.
void append_length_shares(CsvTable& table, const std::vector<double>& leading,
                          const LengthClasses& population, const std::vector<double>& edges);

}  // namespace fiberfate
