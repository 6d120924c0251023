// Looks up and cuts histories of the flow.
#include "continuum/length_history.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

constexpr double parts_of_a_ramp = 100;

MeltState state_of(const LengthHistoryRow& row) {
  return {row.rate, row.temperature, row.pressure};
}

}  // namespace

LengthHistory::LengthHistory(std::vector<LengthHistoryRow> rows, HistoryForm form)
    : rows_(std::move(rows)), form_(form) {
  if (rows_.empty()) throw InputError("a history of the flow has no rows", "give at least one");
  if (rows_.front().time != 0)
    throw InputError("a history of the flow does not begin at time 0", "add a row for it");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i > 0 && !(rows_[i].time > rows_[i - 1].time))
      throw InputError("the times of a history do not rise", "sort the rows by time");
    if (!(rows_[i].rate >= 0) || !(rows_[i].pressure >= 0))
      throw InputError("a history has a negative shear rate or pressure", "give magnitudes");
    for (const double number : {rows_[i].time, rows_[i].rate, rows_[i].temperature, rows_[i].pressure})
      if (!std::isfinite(number))
        throw InputError("a history has a number that is not finite", "give finite numbers");
  }
}

LengthHistory LengthHistory::constant(const MeltState& melt) {
  return LengthHistory({{0, melt.rate, melt.temperature, melt.pressure}}, HistoryForm::steps);
}

std::size_t LengthHistory::row_at(double time) const {
  const auto after = std::upper_bound(rows_.begin(), rows_.end(), time,
                                      [](double t, const LengthHistoryRow& row) { return t < row.time; });
  return after == rows_.begin() ? 0 : static_cast<std::size_t>(after - rows_.begin()) - 1;
}

MeltState LengthHistory::at(double time) const {
  const std::size_t i = row_at(time);
  const MeltState from = state_of(rows_[i]);
  if (form_ == HistoryForm::steps || i + 1 == rows_.size()) return from;
  const MeltState to = state_of(rows_[i + 1]);
  const double part = (time - rows_[i].time) / (rows_[i + 1].time - rows_[i].time);
  return {std::lerp(from.rate, to.rate, part), std::lerp(from.temperature, to.temperature, part),
          std::lerp(from.pressure, to.pressure, part)};
}

std::vector<LengthHistoryPart> LengthHistory::parts(double begin, double end) const {
  require_number("begin", begin, not_negative);
  require_number("end", end, {.lower = begin});
  std::vector<LengthHistoryPart> result;
  for (std::size_t i = row_at(begin); i < rows_.size() && begin < end; ++i) {
    const bool last = i + 1 == rows_.size();
    const double until = last ? end : std::min(end, rows_[i + 1].time);
    if (last || form_ == HistoryForm::steps) {
      result.push_back({until - begin, state_of(rows_[i])});
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

}  // namespace fiberfate
