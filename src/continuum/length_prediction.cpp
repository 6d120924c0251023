// Steps populations through histories.
#include "continuum/length_prediction.hpp"

#include "base/number_checks.hpp"

namespace fiberfate {

void follow_lengths(const AttritionLaw& law, const LengthStart& start, const LengthConditions& conditions,
                    std::span<const double> times, const std::function<void(const LengthSample&)>& visit) {
  const auto flow_at = [&](const MeltState& melt) {
    return LengthFlow{melt.rate, conditions.viscosity.at(melt), conditions.compression};
  };
  const std::unique_ptr<LengthEvolution> evolution = law.start(start);
  double now = 0;
  for (const double time : times) {
    require_number("times", time, {.lower = now});
    for (const FlowPart& part : conditions.history.parts(now, time))
      evolution->advance(flow_at(melt_of(part.flow)), part.duration);
    now = time;
    const MeltState melt = melt_of(conditions.history.at(time));
    const LengthFlow flow = flow_at(melt);
    visit({time, melt, flow.viscosity, law.unbreakable_length(flow), *evolution});
  }
}

}  // namespace fiberfate
