// Follows the stress of the melt with its fibers beside their orientation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continuum/viscosity.hpp"
#include "microstructure/tensor.hpp"
#include "results/summary.hpp"
#include "studies/orientation/case.hpp"

namespace fiberfate {

/// Computes the extra stress (thesis 2.12) and the informed-isotropic viscosity (2.11) at one moment after
/// another, for a case that chooses a law under [melt].
class OrientationStress {
 public:
  explicit OrientationStress(const OrientationCase& values);

  /// Names the columns that append() adds.
  static std::vector<std::string> columns();
  /// Computes the stress at a velocity gradient (1/s) and A4, and adds it to a row of series.csv.
  void append(const Mat3& gradient, const Mat6& fourth, std::vector<double>& row);
  /// Adds the last values to the summary.
  void append(RunSummary& summary) const;

 private:
  std::unique_ptr<ViscosityLaw> melt_;
  double temperature_, pressure_, fiber_term_, trouton_term_;
  double viscosity_ = 0, effective_viscosity_ = 0;  // Pa s
  Mat3 stress_ = Mat3::Zero();                      // Pa
};

}  // namespace fiberfate
