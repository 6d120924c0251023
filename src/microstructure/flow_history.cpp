// Looks up and cuts histories of the flow.
#include "microstructure/flow_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
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

FlowHistory FlowHistory::repeated(std::vector<FlowRow> rows, double period) {
  FlowHistory history(std::move(rows));
  require_number("period", period, {.lower = history.rows_.back().time, .above_lower = true});
  history.period_ = period;
  return history;
}

FlowHistory FlowHistory::in_steps(int pieces) const {
  require_number("pieces", pieces, {.lower = 1});
  if (form_ == HistoryForm::steps) return *this;
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

FlowHistory::Place FlowHistory::place_at(double time) const {
  Place place;
  if (period_ > 0 && time > 0) {
    place.periods = std::floor(time / period_);
    // The quotient may have been rounded up or down to a whole number.
    while (place.periods > 0 && begin_of(place) > time) --place.periods;
    while (begin_of({place.periods + 1, 0}) <= time) ++place.periods;
  }
  const auto rows = std::views::iota(std::size_t{0}, rows_.size());
  const auto begins = [&](std::size_t row) { return begin_of({place.periods, row}); };
  const auto after = std::ranges::upper_bound(rows, time, {}, begins);
  place.row = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - rows.begin() - 1, 0));
  return place;
}

FlowHistory::Place FlowHistory::next(const Place& place) const {
  return place.row + 1 < rows_.size() ? Place{place.periods, place.row + 1} : Place{place.periods + 1, 0};
}

bool FlowHistory::is_last(std::size_t row) const {
  return period_ == 0 && row + 1 == rows_.size();
}

bool FlowHistory::is_ramp(std::size_t row) const {
  return form_ == HistoryForm::ramps && row + 1 < rows_.size();
}

Flow FlowHistory::at(double time) const {
  const std::size_t i = place_at(time).row;
  if (!is_ramp(i)) return rows_[i].flow;
  return between(rows_[i].flow, rows_[i + 1].flow,
                 (time - rows_[i].time) / (rows_[i + 1].time - rows_[i].time));
}

double FlowHistory::next_change(double time) const {
  const Place place = place_at(time);
  return is_last(place.row) ? std::numeric_limits<double>::infinity() : begin_of(next(place));
}

std::vector<FlowPart> FlowHistory::parts(double begin, double end) const {
  require_number("begin", begin, not_negative);
  require_number("end", end, {.lower = begin});
  std::vector<FlowPart> result;
  for (Place place = place_at(begin); begin < end; place = next(place)) {
    const std::size_t i = place.row;
    const double until = is_last(i) ? end : std::min(end, begin_of(next(place)));
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
