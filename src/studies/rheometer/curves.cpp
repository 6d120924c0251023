// What the runs of a rheometer say together.
#include "studies/rheometer/curves.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "continuum/anisotropic_stress.hpp"
#include "studies/rheometer/readings.hpp"

namespace fiberfate {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using Rows = std::vector<std::size_t>;

double mean_of(const std::vector<double>& column, const Rows& rows) {
  const double sum =
      std::accumulate(rows.begin(), rows.end(), 0.0,
                      [&column](double so_far, std::size_t row) { return so_far + column[row]; });
  return sum / static_cast<double>(rows.size());
}

/// The standard error of a mean over replicas, from their scatter; of one replica that of its own mean.
double error_of(const std::vector<double>& means, const std::vector<double>& errors, const Rows& rows) {
  if (rows.size() == 1) return errors[rows.front()];
  const double mean = mean_of(means, rows), count = static_cast<double>(rows.size());
  double squares = 0;
  for (const std::size_t row : rows) squares += std::pow(means[row] - mean, 2);
  return std::sqrt(squares / (count - 1) / count);
}

Rows rows_of_point(const CsvTable& readings, std::size_t point) {
  Rows rows;
  const std::vector<double>& numbers = readings.column("point");
  for (std::size_t row = 0; row < numbers.size(); ++row)
    if (numbers[row] == static_cast<double>(point)) rows.push_back(row);
  return rows;
}

Rows rows_of_fibers(const RheometerCase& values, const CsvTable& readings, std::size_t fibers) {
  Rows rows;
  const std::vector<RheometerPoint> all = points(values.sweep);
  for (std::size_t point = 0; point < all.size(); ++point)
    if (all[point].fibers == fibers)
      for (const std::size_t row : rows_of_point(readings, point)) rows.push_back(row);
  return rows;
}

std::vector<StressReading> stresses(const RheometerCase& values, const CsvTable& readings, const Rows& rows) {
  std::vector<StressReading> all;
  all.reserve(rows.size());
  for (const std::size_t row : rows) all.push_back(stress_reading(values, readings, row));
  return all;
}

double dinh_armstrong(double aspect_ratio, double volume_fraction) {
  return aspect_ratio > 1 && volume_fraction > 0 && volume_fraction < 1
             ? particle_number(aspect_ratio, volume_fraction)
             : unknown;
}

std::vector<std::string> curve_columns() {
  std::vector<std::string> columns = {"point",           "fibers",   "flow",   "rate_per_s", "viscosity_Pa_s",
                                      "volume_fraction", "length_m", "strain", "replicas"};
  for (const ErrorColumns& one : columns_with_errors()) columns.insert(columns.end(), {one.mean, one.error});
  columns.insert(columns.end(), {"relative_viscosity_drift", "stretching_share", "particle_number",
                                 "particle_number_error", "fitted_relative_viscosity", "L_N_m", "L_W_m"});
  return columns;
}

double mean_share(const std::vector<StressReading>& readings) {
  double sum = 0;
  for (const StressReading& one : readings)
    sum += one.fourth.allFinite() ? stretching_share(one.strain_rate, one.fourth) : unknown;
  return sum / static_cast<double>(readings.size());
}

void append_number(std::vector<double>& row, const FittedNumber& number) {
  row.insert(row.end(), {number.value, number.error, number.lower, number.upper});
}

CsvTable fits_table(const std::vector<RheometerFit>& fits) {
  CsvTable table{{"fibers",
                  "volume_fraction",
                  "length_m",
                  "L_N_m",
                  "readings",
                  "particle_number",
                  "particle_number_error",
                  "particle_number_lower",
                  "particle_number_upper",
                  "particle_number_dinh_armstrong",
                  "stress_explained",
                  "viscosity_ratio",
                  "viscosity_ratio_error",
                  "viscosity_ratio_lower",
                  "viscosity_ratio_upper",
                  "trouton_term",
                  "trouton_term_error",
                  "trouton_term_lower",
                  "trouton_term_upper",
                  "trouton_term_told",
                  "least_stretching_share",
                  "largest_stretching_share",
                  "viscosity_scatter"}};
  for (const RheometerFit& fit : fits) {
    std::vector<double> row = {static_cast<double>(fit.fibers), fit.volume_fraction, fit.planned_length,
                               fit.mean_length, static_cast<double>(fit.viscosity.readings)};
    append_number(row, fit.stress.particle_number);
    row.insert(row.end(), {fit.dinh_armstrong, fit.stress.explained});
    append_number(row, fit.viscosity.viscosity_ratio);
    append_number(row, fit.viscosity.trouton_term);
    row.insert(row.end(), {fit.viscosity.is_told() ? 1.0 : 0.0, fit.viscosity.least_share,
                           fit.viscosity.largest_share, fit.viscosity.scatter});
    table.append(row);
  }
  return table;
}

void summarise(const CsvTable& curves, const CsvTable& fits, RunSummary& summary) {
  for (const char* column : {"rate_per_s", "volume_fraction", "length_m"})
    summary.own.emplace_back("point_" + std::string(column), curves.column(column));
  for (const ErrorColumns& one : columns_with_errors())
    for (const char* column : {one.mean, one.error}) summary.own.emplace_back(column, curves.column(column));
  summary.own.emplace_back("stretching_share", curves.column("stretching_share"));
  for (std::size_t i = 0; i < fits.columns.size(); ++i)
    if (fits.columns[i].starts_with("particle_number") || fits.columns[i].starts_with("viscosity_ratio") ||
        fits.columns[i].starts_with("trouton_term"))
      summary.own.emplace_back(fits.columns[i], fits.values[i]);
}

std::string name_of_point(const CsvTable& curves, std::size_t row) {
  const auto at = [&](const char* column) { return curves.column(column)[row]; };
  const auto type = static_cast<FlowType>(at("flow"));
  std::string name = fmt::format("{} at {:.4g} 1/s", name_of(flow_types(), type), at("rate_per_s"));
  const std::vector<double>& fibers = curves.column("fibers");
  if (fibers.front() != fibers.back())
    name += fmt::format(", {:.3g} % by volume, {:.3g} mm", 100 * at("volume_fraction"), 1e3 * at("L_N_m"));
  return name;
}

/// "3.21 ± 0.12", or the value alone where its error is not known.
std::string with_error(double value, double error) {
  return std::isfinite(error) ? fmt::format("{:.4g} ± {:.2g}", value, error) : fmt::format("{:.4g}", value);
}

/// The viscosities of the first points and of the last, a line.
std::string viscosity_line(const CsvTable& curves) {
  constexpr std::size_t most = 4;
  std::vector<std::string> parts;
  for (std::size_t row = 0; row < curves.rows(); ++row) {
    if (curves.rows() > most && row > 0 && row + 1 < curves.rows()) continue;
    parts.push_back(
        with_error(curves.column("relative_viscosity")[row], curves.column("relative_viscosity_error")[row]) +
        " (" + name_of_point(curves, row) + ")");
  }
  return fmt::format("viscosity over the melt's: {}", fmt::join(parts, curves.rows() > most ? " … " : ", "));
}

std::string fit_line(const RheometerFit& fit, std::size_t fits) {
  const FittedNumber& number = fit.stress.particle_number;
  const std::string of = fits > 1 ? fmt::format("{:.3g} % by volume, {:.3g} mm: ", 100 * fit.volume_fraction,
                                                1e3 * fit.mean_length)
                                  : "";
  return fmt::format("{}N_p {} (semi-dilute aligned fibers: {:.4g}); {}", of,
                     with_error(number.value, number.error), fit.dinh_armstrong, words_of(fit.viscosity));
}

}  // namespace

std::vector<RheometerFit> fit_readings(const RheometerCase& values, const CsvTable& readings) {
  std::vector<RheometerFit> fits;
  for (std::size_t kind = 0; kind < kinds_of_fibers(values.sweep); ++kind) {
    const Rows rows = rows_of_fibers(values, readings, kind);
    if (rows.empty()) continue;
    const std::vector<StressReading> all = stresses(values, readings, rows);
    RheometerFit fit;
    fit.fibers = kind;
    fit.volume_fraction = mean_of(readings.column("volume_fraction"), rows);
    fit.planned_length = mean_of(readings.column("length_m"), rows);
    fit.mean_length = mean_of(readings.column("L_N_m"), rows);
    fit.stress = fit_particle_number(all);
    fit.viscosity = fit_trouton_term(all);
    fit.dinh_armstrong =
        dinh_armstrong(fit.mean_length / values.cell.sample.fibers.diameter, fit.volume_fraction);
    fits.push_back(fit);
  }
  return fits;
}

CsvTable curves_of(const RheometerCase& values, const CsvTable& readings,
                   const std::vector<RheometerFit>& fits) {
  CsvTable curves{curve_columns()};
  const std::vector<RheometerPoint> all = points(values.sweep);
  for (std::size_t point = 0; point < all.size(); ++point) {
    const Rows rows = rows_of_point(readings, point);
    if (rows.empty()) continue;
    const std::vector<StressReading> some = stresses(values, readings, rows);
    std::vector<double> row = {static_cast<double>(point), static_cast<double>(all[point].fibers)};
    for (const char* column :
         {"flow", "rate_per_s", "viscosity_Pa_s", "volume_fraction", "length_m", "strain"})
      row.push_back(mean_of(readings.column(column), rows));
    row.push_back(static_cast<double>(rows.size()));
    for (const ErrorColumns& one : columns_with_errors()) {
      const std::vector<double>& means = readings.column(one.mean);
      row.insert(row.end(), {mean_of(means, rows), error_of(means, readings.column(one.error), rows)});
    }
    const ParticleNumberFit stress = fit_particle_number(some);
    const double share = mean_share(some);
    double fitted = unknown;
    for (const RheometerFit& fit : fits)
      if (fit.fibers == all[point].fibers) fitted = fit.viscosity.at(share);
    row.insert(row.end(), {mean_of(readings.column("relative_viscosity_drift"), rows), share,
                           stress.particle_number.value, stress.particle_number.error, fitted,
                           mean_of(readings.column("L_N_m"), rows), mean_of(readings.column("L_W_m"), rows)});
    curves.append(row);
  }
  return curves;
}

std::string words_of(const TroutonFit& fit) {
  const FittedNumber &ratio = fit.viscosity_ratio, &term = fit.trouton_term;
  if (!std::isfinite(term.value))
    return fmt::format("R_T needs three runs with different x = (D:A4:D)/(D:D), {} are there", fit.readings);
  if (!fit.is_told())
    return fmt::format("x = (D:A4:D)/(D:D) goes from {:.3g} to {:.3g} only, too little to tell R_T",
                       fit.least_share, fit.largest_share);
  return fmt::format("R_T {:.4g} (95 %: {:.4g} to {:.4g}), eta_S {:.4g} ({:.4g} to {:.4g}) times the melt's",
                     term.value, term.lower, term.upper, ratio.value, ratio.lower, ratio.upper);
}

std::string words_of_drift(const CsvTable& curves) {
  constexpr double steady = 0.05;  // less than this share of what the fibers add counts as steady
  constexpr double chance = 4;     // standard errors of the mean: two of the difference of its halves
  double largest = 0;
  std::size_t where = 0;
  for (std::size_t row = 0; row < curves.rows(); ++row) {
    const double added = std::abs(curves.column("relative_viscosity")[row] - 1);
    const double drift = curves.column("relative_viscosity_drift")[row], share = drift / added;
    if (std::abs(drift) < chance * curves.column("relative_viscosity_error")[row]) continue;
    if (std::abs(share) <= std::abs(largest)) continue;
    largest = share;
    where = row;
  }
  if (std::abs(largest) < steady) return "";
  return fmt::format(
      "not steady yet: what fibers add to the viscosity {} by {:.2g} % while it is averaged ({})",
      largest > 0 ? "rises" : "falls", 100 * std::abs(largest), name_of_point(curves, where));
}

Outcome evaluate(const RheometerCase& values, const CsvTable& readings) {
  Outcome outcome;
  const std::vector<RheometerFit> fits = fit_readings(values, readings);
  CsvTable curves = curves_of(values, readings, fits), table = fits_table(fits);
  outcome.summary.own = {{"points", static_cast<std::int64_t>(points(values.sweep).size())},
                         {"replicas", values.sweep.replicas},
                         {"runs_done", static_cast<std::int64_t>(readings.rows())}};
  summarise(curves, table, outcome.summary);
  if (curves.rows() > 0) outcome.headlines.push_back(viscosity_line(curves));
  for (const RheometerFit& fit : fits) outcome.headlines.push_back(fit_line(fit, fits.size()));
  outcome.tables = {{"curves", std::move(curves)}, {"fits", std::move(table)}};
  return outcome;
}

}  // namespace fiberfate
