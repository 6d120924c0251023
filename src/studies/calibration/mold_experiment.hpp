// Predicts the lengths in a molded part for any constants of the length law.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microstructure/mean_lengths.hpp"
#include "molding/filling.hpp"
#include "studies/molding/case.hpp"
#include "studies/molding/setup.hpp"

namespace fiberfate {

/// Stands for one molding of a calibration. Where the flow does not feel the fibers the part fills once, and
/// other constants follow the lengths again through that flow; where it does, every prediction is a filling
/// of its own.
class MoldExperiment {
 public:
  /// Takes a case of the study molding; the law named here replaces the case's own.
  MoldExperiment(MoldingCase values, const std::string& law);

  /// Whether the flow feels the fibers.
  [[nodiscard]] bool is_coupled() const { return values_.fibers.coupling != CouplingChoice::none; }
  [[nodiscard]] const std::vector<NamedPlace>& places() const { return values_.output.places; }
  /// Predicts the mean lengths at every place, m, with the law's parameters in their order, SI. Raises
  /// InputError where no melt comes to a place.
  [[nodiscard]] std::vector<MeanLengths> predict(std::span<const double> parameters);
  /// Counts the fillings so far.
  [[nodiscard]] int fillings() const { return fillings_; }

 private:
  void choose(std::span<const double> parameters);
  void fill();
  [[nodiscard]] std::vector<MeanLengths> lengths_at_places() const;

  MoldingCase values_;
  std::optional<MoldingSetup> setup_;
  std::optional<Filling> filling_;
  int fillings_ = 0;
};

/// Reads the molding of a row of conditions.moldings: a case file, and changes to it, each the name of a
/// variant or "key=value". Raises InputError with what is wrong in that file.
[[nodiscard]] MoldingCase read_molding(const std::vector<std::string>& row);

}  // namespace fiberfate
