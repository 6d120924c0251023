// The stress of the melt with its fibers, beside their orientation.
#pragma once

#include <memory>

#include "continuum/viscosity.hpp"
#include "microstructure/flow.hpp"
#include "microstructure/tensor.hpp"
#include "studies/orientation/case.hpp"

namespace fiberfate {

/// What a melt with fibers does at one moment.
struct MeltStress {
  double viscosity = 0;            ///< of the matrix, Pa s
  double effective_viscosity = 0;  ///< informed-isotropic (thesis 2.11), Pa s
  Mat3 extra = Mat3::Zero();       ///< extra stress (thesis 2.12), Pa
};

/// Evaluates the stress, for a case that chooses a law under [melt].
class StressEvaluator {
 public:
  explicit StressEvaluator(const OrientationCase& values);
  /// Takes the flow, of which the velocity gradient counts, and A4.
  [[nodiscard]] MeltStress at(const Flow& flow, const Mat6& fourth) const;
  /// phi N_p.
  [[nodiscard]] double fiber_term() const { return fiber_term_; }

 private:
  std::unique_ptr<ViscosityLaw> melt_;
  double temperature_, pressure_, fiber_term_, trouton_term_;
};

}  // namespace fiberfate
