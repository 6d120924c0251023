// Keeps the steps of a filling and repeats the transport of lengths through them.
#include "molding/step_record.hpp"

#include "molding/sweep.hpp"

namespace fiberfate {

void StepRecord::keep(const StepFlow& flow, const FlowField& field, std::span<const double> stretching,
                      const FillingState& state) {
  RecordedStep step;
  step.flow = flow;
  step.field.inverse_viscosity = field.inverse_viscosity;
  step.field.shares = field.shares;
  step.stretching.assign(stretching.begin(), stretching.end());
  step.rate = state.rate;
  steps_.push_back(std::move(step));
}

std::vector<double> StepRecord::follow(const LengthTransport& transport, std::size_t points) const {
  FillingState state;
  state.lengths.assign(points * transport.field_count(), 0);
  for (const RecordedStep& step : steps_) {
    state.rate = step.rate;
    sweep_down_the_flow(step.flow, [&](std::span<const Index> nodes) {
      transport.advance(nodes, step.flow, step.field, step.stretching, state);
    });
  }
  return std::move(state.lengths);
}

}  // namespace fiberfate
