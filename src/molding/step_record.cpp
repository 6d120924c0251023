// Keeps the steps of a filling and repeats the transport of lengths through them.
#include "molding/step_record.hpp"

#include "molding/sweep.hpp"

namespace fiberfate {

void StepRecord::keep(const MeltMotion& motion, const FillingState& state) {
  RecordedStep step;
  step.flow = motion.step;
  step.field.inverse_viscosity = motion.field.inverse_viscosity;
  step.field.shares = motion.field.shares;
  step.stretching.assign(motion.stretching.begin(), motion.stretching.end());
  step.rate = state.rate;
  steps_.push_back(std::move(step));
}

std::vector<double> StepRecord::follow(const LengthTransport& transport, const Cavity& cavity) const {
  FillingState state;
  state.lengths.assign(cavity.mesh.node_count() * cavity.layers.count() * transport.field_count(), 0);
  for (const RecordedStep& step : steps_) {
    state.rate = step.rate;
    sweep_down_the_flow(step.flow, [&](std::span<const Index> nodes) {
      transport.advance(nodes, {cavity.layers, step.flow, step.field, step.stretching}, state);
    });
  }
  return std::move(state.lengths);
}

}  // namespace fiberfate
