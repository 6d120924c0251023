// Looks up and cuts histories of the flow.
#include "microstructure/flow_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

constexpr double parts_of_a_ramp = 100;

void require_sound(const FlowRow& row) {
  if (!row.flow.gradient.allFinite() || !std::isfinite(row.time))
    throw InputError("a flow history has a time or a velocity gradient that is not finite",
                     "give finite numbers");
  require_number("viscosity", row.flow.viscosity, not_negative);
  require_number("temperature", row.flow.temperature, not_negative);
  require_number("pressure", row.flow.pressure, not_negative);
}

/// The flow at a share of the way from one to the other.
Flow between(const Flow& from, const Flow& to, double part) {
  const auto mean = [part](const auto& a, const auto& b) { return a + part * (b - a); };
  return {mean(from.gradient, to.gradient), mean(from.viscosity, to.viscosity),
          mean(from.temperature, to.temperature), mean(from.pressure, to.pressure)};
}

}  // namespace

FlowHistory::FlowHistory(std::vector<FlowRow> rows, HistoryForm form) : rows_(std::move(rows)), form_(form) {
  if (rows_.empty()) throw InputError("a flow history has no rows", "give at least one");
  if (rows_.front().time != 0)
    throw InputError("a flow history does not begin at time 0", "add a row for it");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i > 0 && !(rows_[i].time > rows_[i - 1].time))
      throw InputError("the times of a flow history do not rise", "sort the rows by time");
    require_sound(rows_[i]);
  }
}

FlowHistory FlowHistory::constant(const Flow& flow) {
  return FlowHistory({{0, flow}});
}

FlowHistory FlowHistory::constant(double rate, double viscosity) {
  return constant(simple_shear(rate, viscosity));
}

FlowHistory FlowHistory::ramp(double rate, double viscosity, double duration, int steps) {
  std::vector<FlowRow> rows;
  for (int i = 0; i <= steps; ++i)
    rows.push_back(
        {duration * i / steps, simple_shear(i < steps ? rate * (i + 1) / steps : rate, viscosity)});
  return FlowHistory(std::move(rows));
}

FlowHistory FlowHistory::in_steps(int pieces) const {
  require_number("pieces", pieces, {.lower = 1});
  std::vector<FlowRow> rows;
  double begin = 0;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!is_ramp(row)) {
      rows.push_back({begin, rows_[row].flow});
      if (row + 1 < rows_.size()) begin = rows_[row + 1].time;
      continue;
    }
    const FlowRow &from = rows_[row], &to = rows_[row + 1];
    for (int piece = 0; piece < pieces; ++piece) {
      rows.push_back({begin, between(from.flow, to.flow, (piece + 0.5) / pieces)});
      begin = from.time + (piece + 1.0) / pieces * (to.time - from.time);
    }
  }
  return FlowHistory(std::move(rows));
}

std::size_t FlowHistory::row_at(double time) const {
  const auto after = std::ranges::upper_bound(rows_, time, {}, &FlowRow::time);
  return after == rows_.begin() ? 0 : after - rows_.begin() - 1;
}

bool FlowHistory::is_ramp(std::size_t row) const {
  return form_ == HistoryForm::ramps && row + 1 < rows_.size();
}

Flow FlowHistory::at(double time) const {
  const std::size_t i = row_at(time);
  if (!is_ramp(i)) return rows_[i].flow;
  return between(rows_[i].flow, rows_[i + 1].flow,
                 (time - rows_[i].time) / (rows_[i + 1].time - rows_[i].time));
}

double FlowHistory::next_change(double time) const {
  const std::size_t i = row_at(time);
  return i + 1 < rows_.size() ? rows_[i + 1].time : std::numeric_limits<double>::infinity();
}

std::vector<FlowPart> FlowHistory::parts(double begin, double end) const {
  require_number("begin", begin, not_negative);
  require_number("end", end, {.lower = begin});
  std::vector<FlowPart> result;
  for (std::size_t i = row_at(begin); i < rows_.size() && begin < end; ++i) {
    const bool last = i + 1 == rows_.size();
    const double until = last ? end : std::min(end, rows_[i + 1].time);
    if (!is_ramp(i)) {
      result.push_back({until - begin, rows_[i].flow});
    } else {
      const double longest = (rows_[i + 1].time - rows_[i].time) / parts_of_a_ramp;
      const double count = std::max(1.0, std::ceil((until - begin) / longest - 1e-9));
      const double duration = (until - begin) / count;
      for (double k = 0; k < count; ++k) result.push_back({duration, at(begin + (k + 0.5) * duration)});
    }
    begin = until;
  }
  return result;
}

void require_steps(const FlowHistory& history) {
  if (history.form() == HistoryForm::ramps)
    throw InputError("a flow history of ramps cannot be followed by steps",
                     "cut the ramps first: FlowHistory::in_steps");
}

}  // namespace fiberfate
