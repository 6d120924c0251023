// Balances of a filling and means over its part.
#include "molding/filling_account.hpp"

#include <algorithm>
#include <numeric>

namespace fiberfate {

double volume_error(const Filling& filling) {
  const FillingState& state = filling.state();
  const double excess = std::accumulate(state.excess.begin(), state.excess.end(), 0.0);
  return (state.injected_volume - state.filled_volume - excess) / filling.mesh().total_volume();
}

double heat_error(const Filling& filling) {
  const HeatAccount& heat = filling.state().heat;
  const double supplied = heat.brought_in + heat.dissipated;
  return (supplied - heat.to_mold - filling.stored_heat()) / supplied;
}

Mat3 part_orientation(const Filling& filling) {
  Mat3 sum = Mat3::Zero();
  double volume = 0;
  for (std::size_t i = 0; i < filling.mesh().node_count(); ++i) {
    if (!(filling.state().filled[i] > 0)) continue;
    const double filled = filling.mesh().volume(i) * filling.state().filled[i];
    sum += filled * filling.mean_orientation(i);
    volume += filled;
  }
  return sum / volume;
}

std::int64_t count_marks(const FillingState& state, NodeMark mark) {
  return std::count(state.mark.begin(), state.mark.end(), mark);
}

}  // namespace fiberfate
