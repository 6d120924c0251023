// Turns the choices about a cell's flow into a history, and measures its strains.
#include "studies/shear_cell/cell_flow.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "studies/flow_choices.hpp"

namespace fiberfate {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double most_parts = 1e6;  ///< of an oscillation; more are a slip of the unit

const Range& viscosities() {
  static const Range range = {0, 1e9, Range::Ends::open_low};
  return range;
}

std::vector<Column> timed_gradient_columns() {
  std::vector<Column> columns = gradient_columns();
  columns.insert(columns.begin(), Column{"end time", {"s", "s"}, Range::positive()});
  columns.push_back({"viscosity", {"Pa s", "Pa s"}, viscosities()});
  return columns;
}

bool has_table_of_gradients(const FlowChoices& flow) {
  return flow.type == FlowType::gradient && flow.kind == FlowKind::table;
}

void validate_rows(const char* key, const std::vector<std::vector<double>>& rows, CaseChecker& checker) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][0] > rows[i - 1][0]) continue;
    checker.error_in_row(key, i,
                         fmt::format("the end time of row {} is not later than that of row {}", i + 1, i),
                         "sort the rows by end time");
    return;
  }
}

void validate_table(const FlowChoices& flow, const std::string& why, CaseChecker& checker) {
  checker.warn_unused({"flow.rate", "flow.viscosity", "flow.gradient"},
                      "flow.kind = \"constant\" or \"ramp\"");
  const bool by_gradient = has_table_of_gradients(flow);
  const char* key = by_gradient ? "flow.gradient_table" : "flow.table";
  checker.require(key, why,
                  by_gradient ? R"([["1 s", 1, 0, 0, 0, -1, 0, 0, 0, 0, "300 Pa s"], ...])"
                              : R"([["0.5 s", "10 1/s", "300 Pa s"], ...])");
  checker.warn_unused({by_gradient ? "flow.table" : "flow.gradient_table"},
                      by_gradient ? "another flow.type" : "flow.type = \"gradient\"");
  validate_rows(key, by_gradient ? flow.gradient_table : flow.table, checker);
}

void validate_oscillation(const FlowChoices& flow, double duration, CaseChecker& checker) {
  checker.require("flow.period", "this kind of flow needs it", "\"0.1 s\"");
  if (flow.period && duration / *flow.period * flow.period_steps > most_parts)
    checker.error(
        "flow.period",
        fmt::format("makes {:.3g} periods in {}", duration / *flow.period, checker.cite("run.duration")),
        fmt::format("give at least {:.3g} s", duration * flow.period_steps / most_parts));
}

FlowHistory history_of_table(const FlowChoices& flow) {
  // Rows of the table say until when they hold, rows of a history from when on.
  const bool by_gradient = has_table_of_gradients(flow);
  const Mat3 unit = by_gradient ? Mat3(Mat3::Zero()) : unit_gradient(flow);
  std::vector<FlowRow> rows;
  double begin = 0;
  for (const std::vector<double>& row : by_gradient ? flow.gradient_table : flow.table) {
    rows.push_back({begin, {by_gradient ? row_gradient(row, 1) : Mat3(row[1] * unit), row.back()}});
    begin = row[0];
  }
  return FlowHistory(std::move(rows));
}

FlowHistory ramp(const FlowChoices& flow, const Flow& last) {
  std::vector<FlowRow> rows;
  for (int i = 0; i <= flow.ramp_steps; ++i) {
    const double share = i < flow.ramp_steps ? (i + 1.0) / flow.ramp_steps : 1;
    rows.push_back({flow.ramp_duration * i / flow.ramp_steps, {share * last.gradient, last.viscosity}});
  }
  return FlowHistory(std::move(rows));
}

/// A rate that swings with the cosine, in steps; each takes the mean of its time, so that strains are exact
/// at its ends.
FlowHistory oscillation(const FlowChoices& flow, const Flow& largest) {
  std::vector<FlowRow> rows;
  const double period = flow.period.value_or(1), part = 2 * pi / flow.period_steps;
  for (int i = 0; i < flow.period_steps; ++i) {
    const double share = (std::sin((i + 1) * part) - std::sin(i * part)) / part;
    rows.push_back({period * i / flow.period_steps, {share * largest.gradient, largest.viscosity}});
  }
  return FlowHistory::repeated(std::move(rows), period);
}

}  // namespace

const Choices<FlowType>& flow_types() {
  static const Choices<FlowType> types = {
      {FlowType::shear, "shear", "simple shear u_x = rate y"},
      {FlowType::planar, "planar", "planar elongation, rate diag(1, -1, 0)"},
      {FlowType::uniaxial, "uniaxial", "uniaxial elongation, rate diag(1, -1/2, -1/2)"},
      {FlowType::biaxial, "biaxial", "biaxial elongation, rate diag(1, 1, -2)"},
      {FlowType::mixed, "mixed", "u_x = rate y, u_y = alpha rate x: 0 shears, 1 stretches, -1 turns"},
      {FlowType::gradient, "gradient", "any gradient that some lattice follows, flow.gradient"}};
  return types;
}

KeyRow<FlowChoices> flow_type_row() {
  return key("type", &FlowChoices::type, flow_types(), "What the melt does.");
}

KeyRows<FlowChoices> constant_flow_rows(Given rate) {
  using Choice = FlowChoices;
  return {key("rate", &Choice::rate, {"1/s"}, Range::between(-1e7, 1e7),
              "Shear rate du_x/dy, or rate of elongation du_x/dx; for a ramp, the last one.", rate,
              "thesis table 3"),
          key("alpha", &Choice::alpha, {}, Range::between(-1, 1),
              "What type \"mixed\" is, from turning to stretching."),
          rows_key("gradient", &Choice::gradient, gradient_columns(),
                   "For type = \"gradient\": one row of L11, L12, L13, L21, … L33, L_ij = d u_i / d x_j.",
                   optional("[[0.3, 1, 0, 0, -0.3, 0, 0, 0, 0]]")),
          key("viscosity", &Choice::viscosity, {"Pa s"}, viscosities(), "Viscosity of the matrix.",
              usual("\"200 Pa s\""), "thesis table 3")};
}

KeyGroup<FlowChoices> flow_keys() {
  using Choice = FlowChoices;
  const Choices<FlowKind> kinds = {
      {FlowKind::constant, "constant", "rate and viscosity from the first moment"},
      {FlowKind::ramp, "ramp", "the rate rises to flow.rate in equal steps"},
      {FlowKind::oscillation, "oscillation", "the rate swings, flow.rate cos(2 pi t / period)"},
      {FlowKind::table, "table", "rate and viscosity follow flow.table"}};
  const KeyRows<Choice> kind = {flow_type_row(),
                                key("kind", &Choice::kind, kinds, "How fast it does so over time.")};
  const KeyRows<Choice> over_time = {
      key("ramp_duration", &Choice::ramp_duration, {"s"}, Range::positive(),
          "Time in which a ramp reaches flow.rate.", {}, "thesis figure 3.24"),
      key("ramp_steps", &Choice::ramp_steps, {}, Range::between(1, 1e6),
          "Number of equal steps of a ramp; the first is flow.rate / ramp_steps.", {}, "thesis figure 3.24"),
      key("period", &Choice::period, {"s"}, Range::positive(), "Time of one swing of an oscillation.",
          optional("\"0.1 s\"")),
      key("period_steps", &Choice::period_steps, {}, Range::between(4, 1e5),
          "Steps of the rate in one swing; strains are exact at their ends."),
      rows_key("table", &Choice::table,
               {{"end time", {"s", "s"}, Range::positive()},
                {"rate", {"1/s", "1/s"}, Range::between(-1e7, 1e7)},
                {"viscosity", {"Pa s", "Pa s"}, viscosities()}},
               "For kind = \"table\": rows [end time, rate, viscosity], the last of which lasts to "
               "the end; or the path of a text file with such rows in s, 1/s and Pa s.",
               optional(R"([["0.5 s", "10 1/s", "300 Pa s"], ["2 s", "100 1/s", "150 Pa s"]])")),
      rows_key("gradient_table", &Choice::gradient_table, timed_gradient_columns(),
               "For type = \"gradient\" with kind = \"table\": rows [end time, L11, … L33, "
               "viscosity]; or the path "
               "of a text file with such rows in SI.",
               optional(R"([["1 s", 1, 0, 0, 0, -1, 0, 0, 0, 0, "300 Pa s"]])")),
  };
  return {"flow", flow_text, joined<Choice>({kind, constant_flow_rows(usual("\"16.65 1/s\"")), over_time})};
}

void validate_flow(const FlowChoices& flow, double duration, CaseChecker& checker) {
  const std::string why = "this kind of flow needs it";
  if (flow.kind != FlowKind::ramp)
    checker.warn_unused({"flow.ramp_duration", "flow.ramp_steps"}, "flow.kind = \"ramp\"");
  if (flow.kind != FlowKind::oscillation)
    checker.warn_unused({"flow.period", "flow.period_steps"}, "flow.kind = \"oscillation\"");
  if (flow.type != FlowType::mixed) checker.warn_unused({"flow.alpha"}, "flow.type = \"mixed\"");
  if (flow.type != FlowType::gradient)
    checker.warn_unused({"flow.gradient", "flow.gradient_table"}, "flow.type = \"gradient\"");
  if (flow.kind == FlowKind::table) {
    validate_table(flow, why, checker);
    return;
  }
  checker.warn_unused({"flow.table", "flow.gradient_table"}, "flow.kind = \"table\"");
  if (flow.type == FlowType::gradient) {
    checker.require("flow.gradient", "this type of flow needs it", "[[0.3, 1, 0, 0, -0.3, 0, 0, 0, 0]]");
    checker.warn_unused({"flow.rate"}, "another flow.type");
  } else {
    checker.require("flow.rate", why, "\"16.65 1/s\"");
  }
  checker.require("flow.viscosity", why, "\"200 Pa s\"");
  if (flow.kind == FlowKind::oscillation) validate_oscillation(flow, duration, checker);
}

Mat3 unit_gradient(const FlowChoices& flow) {
  Mat3 mixed = simple_shear_gradient();
  switch (flow.type) {
    case FlowType::planar:
      return Vec3(1, -1, 0).asDiagonal();
    case FlowType::uniaxial:
      return Vec3(1, -0.5, -0.5).asDiagonal();
    case FlowType::biaxial:
      return Vec3(1, 1, -2).asDiagonal();
    case FlowType::mixed:
      mixed(1, 0) = flow.alpha;
      return mixed;
    case FlowType::gradient:
      return flow.gradient.empty() ? Mat3(Mat3::Zero()) : row_gradient(flow.gradient.front(), 0);
    default:
      return simple_shear_gradient();
  }
}

FlowHistory flow_history(const FlowChoices& flow) {
  if (flow.kind == FlowKind::table) return history_of_table(flow);
  const double rate = flow.type == FlowType::gradient ? 1 : flow.rate.value_or(0);
  const Flow whole = {rate * unit_gradient(flow), flow.viscosity.value_or(0)};
  if (flow.kind == FlowKind::ramp) return ramp(flow, whole);
  if (flow.kind == FlowKind::oscillation) return oscillation(flow, whole);
  return FlowHistory::constant(whole);
}

double flow_rate(const FlowChoices& flow, const Mat3& gradient) {
  if (flow.type == FlowType::gradient) return Flow{gradient}.shear_rate();
  const Mat3 unit = unit_gradient(flow);
  return gradient.cwiseProduct(unit).sum() / unit.squaredNorm();
}

double flow_strain(const FlowChoices& flow, const FlowHistory& history, double time) {
  double strain = 0;
  for (const FlowPart& part : history.parts(0, time))
    strain += flow_rate(flow, part.flow.gradient) * part.duration;
  return strain;
}

double total_strain(const FlowHistory& history, double time) {
  double strain = 0;
  for (const FlowPart& part : history.parts(0, time)) strain += 2 * principal_rate(part.flow) * part.duration;
  return strain;
}

double hencky_strain(const LatticeFrame& frame, const FlowHistory& history, double time) {
  if (frame.kind == LatticeKind::carried || frame.kind == LatticeKind::rotating) return 0;
  Vec3 strain = Vec3::Zero();
  for (const FlowPart& part : history.parts(0, time))
    strain += part.duration * frame.rates(part.flow.gradient);
  return strain.maxCoeff();
}

double elongational_viscosity(FlowType type, const Flow& flow, const Mat3& stress) {
  const Mat3 total = 2 * flow.viscosity * flow.rate_of_strain() + stress;
  const double rate = flow.gradient(0, 0);
  switch (type) {
    case FlowType::planar:
      return (total(0, 0) - total(1, 1)) / rate;
    case FlowType::uniaxial:
      return (total(0, 0) - 0.5 * (total(1, 1) + total(2, 2))) / rate;
    case FlowType::biaxial:
      return (0.5 * (total(0, 0) + total(1, 1)) - total(2, 2)) / rate;
    default:
      return unknown;
  }
}

}  // namespace fiberfate
