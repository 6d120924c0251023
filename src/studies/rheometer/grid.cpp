// Lists the points of a sweep and makes their cells.
#include <algorithm>
#include <cmath>

#include "studies/rheometer/case.hpp"

namespace fiberfate {
namespace {

using Place = std::optional<std::size_t>;

/// The places of a list; one without a value where there is no list.
std::vector<Place> places(std::size_t size) {
  std::vector<Place> all;
  for (std::size_t i = 0; i < size; ++i) all.emplace_back(i);
  if (all.empty()) all.emplace_back();
  return all;
}

FlowType flow_type_named(const std::string& name) {
  const Choices<FlowType>& types = flow_types();
  const auto found =
      std::find_if(types.begin(), types.end(), [&name](const auto& one) { return one.name == name; });
  return found == types.end() ? FlowType::shear : found->value;
}

}  // namespace

std::vector<RheometerPoint> points(const RheometerSweep& sweep) {
  const std::vector<Place> lengths = places(sweep.lengths.size()),
                           fractions = places(sweep.volume_fractions.size()),
                           rates = places(sweep.rates.size());
  std::vector<RheometerPoint> all;
  for (const Place flow : places(sweep.flows.size()))
    for (const Place fraction : fractions)
      for (const Place length : lengths)
        for (const Place rate : rates)
          all.push_back(
              {flow, fraction, length, rate, fraction.value_or(0) * lengths.size() + length.value_or(0)});
  return all;
}

std::size_t kinds_of_fibers(const RheometerSweep& sweep) {
  return places(sweep.volume_fractions.size()).size() * places(sweep.lengths.size()).size();
}

ShearCellCase cell_at(const RheometerCase& values, const RheometerPoint& point, std::int64_t replica) {
  ShearCellCase cell = values.cell;
  const RheometerSweep& sweep = values.sweep;
  if (point.flow) cell.flow.type = flow_type_named(sweep.flows[*point.flow]);
  if (point.volume_fraction)
    cell.sample.fibers.volume_fraction = sweep.volume_fractions[*point.volume_fraction];
  if (point.length) cell.sample.fibers.length = sweep.lengths[*point.length];
  if (point.rate) cell.flow.rate = sweep.rates[*point.rate];
  cell.run.seed += static_cast<std::uint64_t>(replica);
  const double rate = std::abs(constant_rate(cell));
  if (sweep.strain && rate > 0) cell.run.duration = *sweep.strain / rate;
  return cell;
}

double constant_rate(const ShearCellCase& cell) {
  return flow_rate(cell.flow, flow_history(cell.flow).at(0).gradient);
}

}  // namespace fiberfate
