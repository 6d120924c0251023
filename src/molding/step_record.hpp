// Keeps what moved in every step of a filling, so that lengths can be followed again without another flow.
#pragma once

#include <span>
#include <vector>

#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/length_transport.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// What the transport of lengths reads of one step.
struct RecordedStep {
  StepFlow flow;
  FlowField field;  ///< `inverse_viscosity` and `shares` only
  std::vector<double> stretching;
  std::vector<double> rate;  ///< by point, 1/s
};

/// The steps of a filling from its start. Takes about 0.4 kB a step, node and ten layers of half the
/// gap.
class StepRecord {
 public:
  /// Keeps a step, as the transport of lengths is about to see it.
  void keep(const MeltMotion& motion, const FillingState& state);
  /// Follows lengths from an empty cavity through all steps; gives FillingState::lengths of the last one.
  [[nodiscard]] std::vector<double> follow(const LengthTransport& transport, const Cavity& cavity) const;
  [[nodiscard]] std::size_t step_count() const { return steps_.size(); }

 private:
  std::vector<RecordedStep> steps_;
};

}  // namespace fiberfate
