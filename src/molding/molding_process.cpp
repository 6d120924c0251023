// Reads profiles of the flow rate.
#include "molding/molding_process.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {

double FlowProfile::at(double time, double filled_fraction) const {
  const double position = against == ProfileAgainst::time ? time : filled_fraction;
  const auto after = std::upper_bound(rows.begin(), rows.end(), position,
                                      [](double x, const ProfileRow& row) { return x < row.at; });
  if (after == rows.begin()) return rows.front().rate;
  const ProfileRow& from = *(after - 1);
  if (form == ProfileForm::steps || after == rows.end()) return from.rate;
  return std::lerp(from.rate, after->rate, (position - from.at) / (after->at - from.at));
}

double FlowProfile::next_row(double position) const {
  for (const ProfileRow& row : rows)
    if (row.at > position) return row.at;
  return std::numeric_limits<double>::infinity();
}

FlowProfile flow_of_ram(FlowProfile speeds, double barrel_diameter) {
  for (ProfileRow& row : speeds.rows) row.rate *= pi / 4 * barrel_diameter * barrel_diameter;
  return speeds;
}

}  // namespace fiberfate
