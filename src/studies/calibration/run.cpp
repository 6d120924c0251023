// Runs the study calibration: fits, profiles, bootstraps and sweeps.
#include "studies/calibration/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.hpp"
#include "calibration/bootstrap.hpp"
#include "calibration/fit.hpp"
#include "calibration/prediction_band.hpp"
#include "calibration/profile.hpp"
#include "calibration/residual_runs.hpp"
#include "calibration/sweep.hpp"
#include "results/memory_recorder.hpp"
#include "studies/calibration/fits.hpp"
#include "studies/calibration/model.hpp"
#include "studies/calibration/molds.hpp"
#include "studies/law_facts.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t curve_points = 101;

/// Iterations of a search from afar; a bootstrap sample starts from the best fit and takes this share of
/// them; a profile is so many searches.
constexpr double fit_iterations = 20, bootstrap_share = 0.3, profile_fits = 10;

/// The tables of a run, which several fits fill.
struct Tables {
  CsvTable fit{{"fit", "series", "time_s", "observed", "uncertainty", "predicted"}};
  CsvTable curves{{"fit", "series", "time_s", "predicted", "curve_low", "curve_high", "observation_low",
                   "observation_high"}};
  CsvTable profile{{"fit", "parameter", "value", "chi_square", "limit"}};
  CsvTable bootstrap{{"fit", "parameter", "value"}};
  CsvTable sweep{{"fit", "value", "average_error_percent"}};
  CsvTable optimum{{"fit", "coupled", "length_m", "aspect_ratio", "best_value", "best_error_percent",
                    "fitted", "lower", "upper"}};
};

/// One fit of the run: all series, or those of one condition.
class OneFit {
 public:
  OneFit(const CalibrationCase& values, const FitName& name, std::vector<MeasuredSeries> series)
      : values_(values),
        series_(std::move(series)),
        prefix_(name.prefix),
        number_(name.number),
        problem_(pose_calibration(values, series_)) {}

  /// Shows that the run is alive and lets it be stopped, where a prediction is a filling; elsewhere a fit
  /// takes a moment, but may be stopped, too.
  void show_in(const Session& session) {
    problem_.model = [model = problem_.model, &session, name = title(), count = std::make_shared<int>(0)](
                         std::span<const double> parameters, std::span<double> predictions) {
      session.end_if_stopped("stopped while fitting; resuming will fit again");
      session.show([&] { return fmt::format("{}: {} predictions", name, *count); });
      model(parameters, predictions);
      ++*count;
    };
  }

  /// Counts the predictions of a trial and ends it when its time is used up.
  void try_out(const Pace& trial, std::int64_t& predictions) {
    problem_.model = [model = problem_.model, &trial, &predictions](std::span<const double> parameters,
                                                                    std::span<double> results) {
      model(parameters, results);
      ++predictions;
      if (!trial.has_time()) throw TrialEnd{};
    };
  }

  /// About how many predictions the run makes: searches, profiles, bootstrap samples and sweep, each with the
  /// differences of a Jacobian. Measured on the cases 21 to 26.
  [[nodiscard]] double expected_predictions() const {
    const auto free = static_cast<double>(problem_.free_parameters().size());
    const double profiles = values_.search.profiles == ProfileChoice::none ? 0 : profile_fits * free;
    const double fits = static_cast<double>(values_.search.starts) + profiles +
                        bootstrap_share * static_cast<double>(values_.search.bootstrap);
    return fits * fit_iterations * (free + 1) +
           (values_.sweep.parameter.empty() ? 0 : static_cast<double>(values_.sweep.count));
  }

  void run(Tables& tables, RunSummary& summary, Recorder& log) {
    FitOptions options;
    options.level = values_.search.level;
    options.starts = static_cast<int>(values_.search.starts);
    options.seed = static_cast<std::uint64_t>(values_.search.seed);
    result_ = fit(problem_, options);
    summary.steps = summary.steps.value_or(0) + result_.iterations;
    append_estimates(summary);
    append_runs(summary);
    const std::vector<Profile> profiles = found_profiles(options);
    append_findings(profiles, summary, log);
    append_fit(tables.fit);
    append_curves(tables.curves);
    append_profiles(profiles, tables.profile, summary);
    append_bootstrap(tables.bootstrap, summary);
    append_sweep(tables, summary);
  }

  /// What the bins of its law leave open at the fit; empty where that is little.
  [[nodiscard]] std::string remark_on_bins() const {
    return fiberfate::remark_on_bins(values_, series_, result_.values);
  }

  /// States in a line what was found: "shear: C_I 0.0031 [0.0029, 0.0034]".
  [[nodiscard]] std::string headline() const {
    std::vector<std::string> found;
    for (const ParameterEstimate& one : result_.parameters)
      if (one.outcome == ParameterOutcome::determined) found.push_back(estimate_text(one));
    if (found.empty()) found.emplace_back("the data determine no parameter");
    return fmt::format("{}: {}", title(), fmt::join(found, ", "));
  }

 private:
  /// "L_inf 1.131 mm [1.05, 1.219]".
  [[nodiscard]] std::string estimate_text(const ParameterEstimate& one) const {
    const std::vector<LawParameter>& known =
        chosen_law(calibrated_menu(values_), calibrated_law(values_))->parameters;
    const auto [unit, factor] = shown_as(*std::ranges::find(known, one.name, &LawParameter::name));
    return fmt::format("{} {:.4g}{}{} [{:.4g}, {:.4g}]", one.name, factor * one.value,
                       unit.empty() ? "" : " ", unit, factor * one.interval.lower,
                       factor * one.interval.upper);
  }

  /// What is fitted, for people.
  [[nodiscard]] std::string title() const {
    return prefix_.empty() ? "all conditions" : values_.conditions.names[series_.front().condition];
  }

  void add(RunSummary& summary, const std::string& key, SummaryValue value) const {
    summary.own.emplace_back(prefix_ + key, std::move(value));
  }

  void append_estimates(RunSummary& summary) const {
    for (const ParameterEstimate& estimate : result_.parameters) {
      add(summary, estimate.name, estimate.value);
      if (estimate.outcome == ParameterOutcome::fixed) continue;
      add(summary, estimate.name + "_standard_error", estimate.standard_error);
      add(summary, estimate.name + "_lower", estimate.interval.lower);
      add(summary, estimate.name + "_upper", estimate.interval.upper);
    }
    add(summary, "observations", static_cast<std::int64_t>(problem_.observation_count()));
    add(summary, "degrees_of_freedom", static_cast<std::int64_t>(result_.degrees_of_freedom));
    add(summary, "chi_square", result_.chi_square);
    add(summary, "noise_scale", result_.noise_scale);
    add(summary, "converged", std::string(result_.converged ? "yes" : "no"));
    add(summary, "agreeing_starts", static_cast<std::int64_t>(result_.agreeing_starts));
    const std::vector<std::size_t> free = problem_.free_parameters();
    for (std::size_t i = 0; i < free.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        add(summary,
            fmt::format("correlation_{}_{}", result_.parameters[free[k]].name,
                        result_.parameters[free[i]].name),
            result_.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)));
    std::vector<double> observed;
    for (const FitSeries& one : problem_.series)
      observed.insert(observed.end(), one.observed.begin(), one.observed.end());
    add(summary, "average_error_percent", average_error_percent(observed, result_.predictions));
  }

  /// Counts runs along time and length; samples of one place have no order.
  void append_runs(RunSummary& summary) const {
    std::vector<std::vector<double>> residuals;
    std::size_t at = 0;
    for (const MeasuredSeries& one : series_) {
      std::vector<double> own;
      for (const double value : one.values) own.push_back(value - result_.predictions[at++]);
      if (one.place.empty()) residuals.push_back(std::move(own));
    }
    const ResidualRuns found = count_runs(residuals);
    if (std::isnan(found.deviations)) return;
    add(summary, "residual_runs", found.runs);
    add(summary, "residual_runs_expected", found.expected);
    add(summary, "residual_runs_deviations", found.deviations);
  }

  void append_findings(const std::vector<Profile>& profiles, RunSummary& summary, Recorder& log) const {
    std::vector<std::string> texts;
    for (const Finding& finding : result_.findings) texts.push_back(finding.text);
    for (const Profile& one : profiles)
      for (const Finding& finding : one.findings) texts.push_back(finding.text);
    const std::size_t warnings = texts.size();
    // The strength enters as a ratio to the stress only: which unit it was given in cannot be seen from the
    // fit.
    for (const ParameterEstimate& estimate : result_.parameters)
      if (estimate.name == "sigma_u" && estimate.outcome == ParameterOutcome::fixed)
        texts.push_back(
            fmt::format("sigma_u = {:.4g} GPa enters only as its ratio to the shear stress: another value "
                        "fits as well and "
                        "changes lambda and k_0 by powers of the factor; compare them only at equal sigma_u",
                        1e-9 * estimate.value));
    for (std::size_t i = 0; i < texts.size(); ++i) {
      add(summary, fmt::format("finding_{}", i + 1), texts[i]);
      if (i < warnings) log.warn(prefix_.empty() ? texts[i] : fmt::format("{}: {}", prefix_, texts[i]));
    }
  }

  void append_fit(CsvTable& table) const {
    std::size_t at = 0;
    for (std::size_t s = 0; s < series_.size(); ++s)
      for (std::size_t i = 0; i < series_[s].values.size(); ++i, ++at)
        table.append({number_, static_cast<double>(s), series_[s].times[i], series_[s].values[i],
                      series_[s].deviations[i], result_.predictions[at]});
  }

  /// Writes the predictions of moldings with their bands, one a place and mean.
  void append_molded(CsvTable& table) const {
    PredictionRequest request = {pooled(problem_).model, {}};
    for (const MeasuredSeries& one : series_) request.uncertainty.push_back(one.deviations.front());
    const PredictionBand band = predict_with_band(problem_, result_, request, values_.search.level);
    for (std::size_t s = 0; s < series_.size(); ++s)
      table.append({number_, static_cast<double>(s), 0, band.predicted[s], band.curve[s].lower,
                    band.curve[s].upper, band.observation[s].lower, band.observation[s].upper});
  }

  void append_curves(CsvTable& table) const {
    if (calibrates_in_molds(values_)) return append_molded(table);
    std::vector<MeasuredSeries> fine;
    PredictionRequest request;
    for (const MeasuredSeries& one : series_) {
      fine.push_back(refined(one, curve_points));
      request.uncertainty.insert(request.uncertainty.end(), fine.back().deviations.begin(),
                                 fine.back().deviations.end());
    }
    request.model = calibration_model(values_, fine);
    const PredictionBand band = predict_with_band(problem_, result_, request, values_.search.level);
    std::size_t at = 0;
    for (std::size_t s = 0; s < fine.size(); ++s)
      for (std::size_t i = 0; i < fine[s].values.size(); ++i, ++at)
        table.append({number_, static_cast<double>(s), fine[s].times[i], band.predicted[at],
                      band.curve[at].lower, band.curve[at].upper, band.observation[at].lower,
                      band.observation[at].upper});
  }

  [[nodiscard]] bool is_profiled(std::size_t parameter) const {
    if (values_.search.profiles == ProfileChoice::none) return false;
    if (result_.degrees_of_freedom <= 0 && problem_.noise == NoiseScale::estimated) return false;
    return result_.parameters[parameter].outcome == ParameterOutcome::determined;
  }

  /// One profile a free parameter that is determined, in their order.
  [[nodiscard]] std::vector<Profile> found_profiles(const FitOptions& options) const {
    std::vector<Profile> profiles;
    for (const std::size_t parameter : problem_.free_parameters())
      if (is_profiled(parameter)) profiles.push_back(profile(problem_, result_, parameter, options));
    return profiles;
  }

  void append_profiles(const std::vector<Profile>& profiles, CsvTable& table, RunSummary& summary) const {
    std::size_t next = 0;
    for (const std::size_t parameter : problem_.free_parameters()) {
      if (!is_profiled(parameter)) continue;
      const Profile& found = profiles[next++];
      add(summary, problem_.parameters[parameter].name + "_profile_lower", found.interval.lower);
      add(summary, problem_.parameters[parameter].name + "_profile_upper", found.interval.upper);
      for (std::size_t i = 0; i < found.values.size(); ++i)
        table.append(
            {number_, static_cast<double>(parameter), found.values[i], found.chi_squares[i], found.limit});
    }
  }

  void append_bootstrap(CsvTable& table, RunSummary& summary) const {
    if (values_.search.bootstrap == 0 || result_.degrees_of_freedom <= 0) return;
    BootstrapOptions options;
    options.samples = static_cast<int>(values_.search.bootstrap);
    options.seed = static_cast<std::uint64_t>(values_.search.seed);
    options.level = values_.search.level;
    const Bootstrap samples = bootstrap(problem_, result_, options);
    const std::vector<std::size_t> free = problem_.free_parameters();
    for (std::size_t i = 0; i < free.size(); ++i) {
      const std::string& name = problem_.parameters[free[i]].name;
      add(summary, name + "_bootstrap_standard_error", samples.standard_errors[i]);
      add(summary, name + "_bootstrap_lower", samples.intervals[i].lower);
      add(summary, name + "_bootstrap_upper", samples.intervals[i].upper);
      for (const double value : samples.values[i])
        table.append({number_, static_cast<double>(free[i]), value});
    }
    add(summary, "bootstrap_failed", static_cast<std::int64_t>(samples.failed));
  }

  void append_sweep(Tables& tables, RunSummary& summary) const {
    if (values_.sweep.parameter.empty()) return;
    SweepRequest request;
    while (problem_.parameters[request.parameter].name != values_.sweep.parameter) ++request.parameter;
    const double value = result_.values[request.parameter];
    request.lower = values_.sweep.lower.value_or(0.1 * value);
    request.upper = values_.sweep.upper.value_or(10 * value);
    request.count = values_.sweep.count;
    request.spacing = values_.sweep.spacing;
    const bool molds = calibrates_in_molds(values_);
    if (molds) add(summary, "coupled", std::string(feels_fibers(values_, series_) ? "yes" : "no"));
    const Sweep found = sweep(molds ? pooled(problem_) : problem_, result_.values, request);
    add(summary, "sweep_best_value", found.best_value);
    add(summary, "sweep_best_error_percent", found.best_error);
    for (std::size_t i = 0; i < found.values.size(); ++i)
      tables.sweep.append({number_, found.values[i], found.errors[i]});
    if (molds) append_optimum(found, request.parameter, tables.optimum);
  }

  /// Writes the optimum of one molding beside the aspect ratio of the fibers that came in.
  void append_optimum(const Sweep& found, std::size_t parameter, CsvTable& table) const {
    const std::size_t condition = series_.front().condition;
    for (const MeasuredSeries& one : series_)
      if (one.condition != condition) return;
    const MoldingCase molding = molding_of(values_, condition);
    const double length = inlet_length(values_, condition);
    const ParameterEstimate& estimate = result_.parameters[parameter];
    table.append({number_, molding.fibers.coupling == CouplingChoice::none ? 0.0 : 1.0, length,
                  length / molding.fibers.diameter, found.best_value, found.best_error, estimate.value,
                  estimate.interval.lower, estimate.interval.upper});
  }

  const CalibrationCase& values_;
  std::vector<MeasuredSeries> series_;
  std::string prefix_;
  double number_;
  FitProblem problem_;
  FitResult result_;
};

std::vector<NamedTable> named(Tables tables) {
  std::vector<NamedTable> all = {{"fit", std::move(tables.fit)}, {"curves", std::move(tables.curves)}};
  const std::pair<const char*, CsvTable*> others[] = {{"profile", &tables.profile},
                                                      {"bootstrap", &tables.bootstrap},
                                                      {"sweep", &tables.sweep},
                                                      {"optimum", &tables.optimum}};
  for (const auto& [name, table] : others)
    if (table->rows() > 0) all.push_back({name, std::move(*table)});
  return all;
}

}  // namespace

double calibration_seconds(const CalibrationCase& values) {
  MemoryRecorder recorder;
  Session(recorder).use_threads(1);
  const std::vector<MeasuredSeries> series = read_measurements(values);
  Pace trial(0.2);
  Tables tables;
  RunSummary summary;
  std::int64_t made = 0;
  double expected = 0;
  bool finished = true;
  const Stopwatch watch;
  for (const FitName& name : fit_names(values)) {
    std::vector<MeasuredSeries> some = series_of(name, series);
    if (some.empty()) continue;
    OneFit fit(values, name, std::move(some));
    expected += fit.expected_predictions();
    if (!finished) continue;
    fit.try_out(trial, made);
    try {
      fit.run(tables, summary, recorder);
    } catch (const TrialEnd&) {
      finished = false;
    }
  }
  const double seconds = watch.elapsed();
  return finished || made == 0 ? seconds : seconds * std::max(1.0, expected / static_cast<double>(made));
}

Outcome compute_calibration(const CalibrationCase& values, Session& session) {
  // Fillings use threads; what is fitted at a point is too small to share.
  if (session.options().threads && !calibrates_in_molds(values))
    throw InputError(
        {{"", 0, 0, "--threads", "", "a calibration without conditions.moldings runs on one thread",
          "leave --threads out"}});
  session.use_threads(calibrates_in_molds(values) ? 0 : 1);
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  summary.seed = static_cast<std::uint64_t>(values.search.seed);
  summary.own.emplace_back("law", calibrated_law(values).name);
  const std::vector<MeasuredSeries> series = read_measurements(values);
  Tables tables;
  for (const FitName& name : fit_names(values)) {
    std::vector<MeasuredSeries> some = series_of(name, series);
    if (some.empty()) continue;
    OneFit fit(values, name, std::move(some));
    fit.show_in(session);
    fit.run(tables, summary, session.recorder());
    if (const std::string remark = fit.remark_on_bins(); !remark.empty()) session.recorder().warn(remark);
    outcome.headlines.push_back(fit.headline());
  }
  session.end_progress();
  outcome.tables = named(std::move(tables));
  return outcome;
}

}  // namespace fiberfate
