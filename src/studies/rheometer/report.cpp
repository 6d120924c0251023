// The report of the study rheometer from the files of its result folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "studies/rheometer/curves.hpp"
#include "studies/rheometer/readings.hpp"
#include "studies/rheometer/run.hpp"
#include "studies/sample/fiber_sections.hpp"

namespace fiberfate {
namespace {

using Place = std::optional<std::size_t> RheometerPoint::*;

/// The list along which curves are drawn, its column in curves.csv, and its axis.
struct CurveAxis {
  Place place;
  const char* column;
  ReportAxis axis;
};

CurveAxis curve_axis(const RheometerCase& values, const CsvTable& curves) {
  const RheometerSweep& sweep = values.sweep;
  const std::vector<double>& rates = curves.column("rate_per_s");
  const bool positive = std::all_of(rates.begin(), rates.end(), [](double rate) { return rate > 0; });
  if (!sweep.rates.empty())
    return {&RheometerPoint::rate,
            "rate_per_s",
            {"rate", "1/s", positive ? AxisScale::logarithmic : AxisScale::linear}};
  if (!sweep.volume_fractions.empty())
    return {&RheometerPoint::volume_fraction, "volume_fraction", {"volume fraction"}};
  if (!sweep.lengths.empty()) return {&RheometerPoint::length, "length_m", {"length", "m"}};
  return {&RheometerPoint::flow, "flow", {"flow", "", AxisScale::linear, sweep.flows}};
}

/// Names the curve to which a point belongs, by what is swept beside the axis.
std::string curve_name(const RheometerCase& values, const RheometerPoint& point, Place axis) {
  const RheometerSweep& sweep = values.sweep;
  std::vector<std::string> parts;
  if (point.flow && axis != &RheometerPoint::flow) parts.push_back(sweep.flows[*point.flow]);
  if (point.volume_fraction && axis != &RheometerPoint::volume_fraction)
    parts.push_back(fmt::format("{:.3g} % by volume", 100 * sweep.volume_fractions[*point.volume_fraction]));
  if (point.length && axis != &RheometerPoint::length)
    parts.push_back(fmt::format("{:.3g} mm", 1e3 * sweep.lengths[*point.length]));
  return parts.empty() ? "" : fmt::format("{}", fmt::join(parts, ", "));
}

/// A quantity of curves.csv that is drawn; one that goes with the rate over the viscosity times the rate.
struct Drawn {
  const char *column, *error, *label;
  enum class Scale { as_it_is, of_melt } scale = Scale::as_it_is;

  [[nodiscard]] double unit(const CsvTable& curves, std::size_t row) const {
    if (scale == Scale::as_it_is) return 1;
    return curves.column("viscosity_Pa_s")[row] * std::abs(curves.column("rate_per_s")[row]);
  }
};

/// Labels a curve by its quantity, where several are drawn, and by its name.
std::string label_of(const Drawn& quantity, const std::string& name, std::size_t quantities) {
  if (name.empty()) return quantity.label;
  return quantities == 1 ? name : fmt::format("{}, {}", quantity.label, name);
}

void append_point(ReportSeries& series, double x, double value, double error) {
  series.x.push_back(x);
  series.values.push_back(value);
  const double bar = std::isfinite(error) ? error : 0;
  series.low.push_back(value - bar);
  series.high.push_back(value + bar);
}

/// Draws quantities with bars of one standard error over an axis.
LinesSection section_of(const RheometerCase& values, const CsvTable& curves, LinesSection section,
                        const std::vector<Drawn>& quantities) {
  const CurveAxis axis = curve_axis(values, curves);
  const std::vector<RheometerPoint> all = points(values.sweep);
  section.x = axis.axis;
  section.caption = "Means of the replicas; bars are one standard error to either side.";
  for (const Drawn& one : quantities) {
    std::vector<ReportSeries> drawn;
    for (std::size_t row = 0; row < curves.rows(); ++row) {
      const RheometerPoint& point = all.at(static_cast<std::size_t>(curves.column("point")[row]));
      const double unit = one.unit(curves, row), value = curves.column(one.column)[row] / unit;
      if (!std::isfinite(value)) continue;
      const std::string label = label_of(one, curve_name(values, point, axis.place), quantities.size());
      auto series = std::find_if(drawn.begin(), drawn.end(),
                                 [&label](const ReportSeries& other) { return other.label == label; });
      if (series == drawn.end()) series = drawn.insert(series, {label, {}, CurveStyle::points});
      const bool by_flow = axis.place == &RheometerPoint::flow;
      const double x =
          by_flow ? static_cast<double>(point.flow.value_or(0) + 1) : curves.column(axis.column)[row];
      append_point(*series, x, value, curves.column(one.error)[row] / unit);
    }
    append(section.series, std::move(drawn));
  }
  return section;
}

/// Sets the relative viscosities against those of the fitted law.
LinesSection parity(const CsvTable& curves) {
  LinesSection section{
      "parity", "Relative viscosity and the informed-isotropic law", {"fitted"}, {"measured"}, {}, {}};
  section.caption =
      "eta_S/eta (1 + R_T x) with x = (D:A4:D)/(D:D), fitted to all runs with the same fibers; on the dashed "
      "line "
      "both agree.";
  ReportSeries points{"points", {}, CurveStyle::points}, line{"equal", {}, CurveStyle::dashed};
  const std::vector<double>&fitted = curves.column("fitted_relative_viscosity"),
        &measured = curves.column("relative_viscosity"), &errors = curves.column("relative_viscosity_error");
  for (std::size_t row = 0; row < curves.rows(); ++row)
    if (std::isfinite(fitted[row]) && std::isfinite(measured[row]))
      append_point(points, fitted[row], measured[row], errors[row]);
  if (points.x.empty()) return section;
  const auto [low, high] = std::minmax_element(points.x.begin(), points.x.end());
  line.x = line.values = {*low, *high};
  section.series = {std::move(points), std::move(line)};
  return section;
}

FactsSection asked(const RheometerCase& values) {
  const RheometerSweep& sweep = values.sweep;
  FactsSection section{"asked", "Inputs", sample_facts(values.cell.sample)};
  const std::string flow = name_of(flow_types(), values.cell.flow.type);
  section.rows.push_back(
      {"Flow", sweep.flows.empty() ? flow : fmt::format("{}", fmt::join(sweep.flows, ", "))});
  section.rows.push_back({"Matrix viscosity", values.cell.flow.viscosity.value_or(0), "Pa s"});
  section.rows.push_back({"Points", static_cast<std::int64_t>(points(sweep).size())});
  section.rows.push_back({"Replicas", sweep.replicas});
  if (sweep.strain)
    section.rows.push_back({"Strain of each point", *sweep.strain});
  else
    section.rows.push_back({"Duration of each point", values.cell.run.duration, "s"});
  section.rows.push_back({"Seed", std::to_string(values.cell.run.seed)});
  return section;
}

std::string interval(const FittedNumber& number) {
  return std::isfinite(number.lower) ? fmt::format("{:.4g} to {:.4g}", number.lower, number.upper) : "";
}

std::string interval_note(const FittedNumber& number) {
  const std::string ends = interval(number);
  return ends.empty() ? ends : "95 %: " + ends;
}

/// What was fitted to fibers of one kind.
FactsSection facts_of(const RheometerFit& fit) {
  const FittedNumber &number = fit.stress.particle_number, &ratio = fit.viscosity.viscosity_ratio,
                     &term = fit.viscosity.trouton_term;
  FactsSection section{
      "outcome",
      "Results",
      {{"Runs", static_cast<std::int64_t>(fit.viscosity.readings)},
       {"N_p", number.value, "", interval_note(number), Prominence::headline},
       {"N_p of semi-dilute aligned fibers", fit.dinh_armstrong, "", "Dinh and Armstrong"},
       {"Share of the stress that N_p explains", 100 * fit.stress.explained, "%"},
       {"phi N_p", fit.volume_fraction * number.value, "", "R_T where the stress is 2 eta phi N_p A4:D"}}};
  if (!fit.viscosity.is_told()) {
    section.rows.push_back({"R_T", words_of(fit.viscosity)});
    return section;
  }
  section.rows.push_back({"R_T", term.value, "", interval_note(term), Prominence::headline});
  section.rows.push_back({"eta_S over the melt's viscosity", ratio.value, "", interval_note(ratio)});
  return section;
}

/// What was fitted to fibers of several kinds, a row each.
TableSection table_of(const std::vector<RheometerFit>& fits) {
  TableSection section{"outcome",
                       "Results",
                       {{"volume fraction", "%"},
                        {"L_N", "m"},
                        {"runs"},
                        {"N_p"},
                        {"95 %"},
                        {"N_p, semi-dilute"},
                        {"stress explained", "%"},
                        {"R_T"},
                        {"95 %"},
                        {"eta_S over the melt's"},
                        {"95 %"}},
                       {}};
  section.caption =
      "Where the stretching share x = (D:A4:D)/(D:D) varies too little between the runs, R_T is not told.";
  for (const RheometerFit& fit : fits) {
    const FittedNumber &number = fit.stress.particle_number, &ratio = fit.viscosity.viscosity_ratio,
                       &term = fit.viscosity.trouton_term;
    std::vector<TableCell> row = {100 * fit.volume_fraction,
                                  fit.mean_length,
                                  static_cast<std::int64_t>(fit.viscosity.readings),
                                  number.value,
                                  interval(number),
                                  fit.dinh_armstrong,
                                  100 * fit.stress.explained};
    if (fit.viscosity.is_told())
      row.insert(row.end(), {term.value, interval(term), ratio.value, interval(ratio)});
    else
      row.insert(row.end(), 4, std::string("–"));
    section.rows.push_back(std::move(row));
  }
  return section;
}

}  // namespace

ReportDocument report_rheometer(const RheometerCase& values, const ResultFolder& folder) {
  ReportDocument document{"Rheology of fibers in melt"};
  document.sections.emplace_back(asked(values));
  const CsvTable readings = read_csv(folder.file("rheometer.csv"));
  if (readings.rows() == 0) return document;
  const std::vector<RheometerFit> fits = fit_readings(values, readings);
  if (fits.size() == 1)
    document.sections.emplace_back(facts_of(fits.front()));
  else
    document.sections.emplace_back(table_of(fits));
  const CsvTable curves = curves_of(values, readings, fits);
  if (const std::string drift = words_of_drift(curves); !drift.empty()) document.subtitle = drift;
  const auto draw = [&](LinesSection section, const std::vector<Drawn>& quantities) {
    section = section_of(values, curves, std::move(section), quantities);
    if (!section.series.empty()) document.sections.emplace_back(std::move(section));
  };
  draw({"viscosity", "Relative viscosity", {}, {"viscosity over the melt's"}, {}, {}},
       {{"relative_viscosity", "relative_viscosity_error", "relative viscosity"}});
  draw({"normal_stress", "Normal stress differences", {}, {"over viscosity times rate of the melt"}, {}, {}},
       {{"N1_Pa", "N1_error_Pa", "N_1", Drawn::Scale::of_melt},
        {"N2_Pa", "N2_error_Pa", "N_2", Drawn::Scale::of_melt}});
  draw({"elongational_viscosity", "Elongational viscosity", {}, {"viscosity", "Pa s"}, {}, {}},
       {{"elongational_viscosity_Pa_s", "elongational_viscosity_error_Pa_s", "elongational viscosity"}});
  draw({"particle_number", "N_p of each point", {}, {"N_p"}, {}, {}},
       {{"particle_number", "particle_number_error", "N_p"}});
  if (LinesSection section = parity(curves); !section.series.empty())
    document.sections.emplace_back(std::move(section));
  return document;
}

}  // namespace fiberfate
