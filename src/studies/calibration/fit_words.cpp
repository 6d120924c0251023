// Says in words what the numbers of a fit mean.
#include <fmt/format.h>

#include <cmath>

#include "studies/calibration/fit_report.hpp"

namespace fiberfate {
namespace {

/// Residuals this small beside the uncertainties are what arithmetic leaves.
constexpr double round_off = 1e-6;

/// How many standard deviations a number must be off to be told.
constexpr double telling = 2;

std::string size_in_words(double ratio, double freedom) {
  if (ratio < round_off) return "The residuals are round-off: the law gives the data exactly.";
  // sqrt(chi²/ν) scatters about 1 by 1/sqrt(2 ν).
  const double scatter = 1 / std::sqrt(2 * freedom);
  const std::string size = fmt::format("The residuals are {:.2g} times the uncertainties of [data]", ratio);
  if (ratio > 1 + telling * scatter)
    return size +
           ": the law misses something, or the uncertainties are stated too small. A pattern in the "
           "residuals "
           "points to the law as the cause.";
  if (ratio < 1 - telling * scatter)
    return size + ": smaller than they should be, so the uncertainties are stated too large.";
  return size + ": the law describes the data within what is known of them.";
}

std::string runs_in_words(double runs, double expected, double deviations) {
  const std::string counts = fmt::format(
      "The residuals form {:.0f} runs of one sign, where noise would form {:.3g}", runs, expected);
  if (deviations < -telling) return counts + ": neighbours go together, so the law does not follow the data.";
  if (deviations > telling) return counts + ": neighbours alternate more than noise would.";
  return counts + ": no pattern.";
}

const char* told_apart(double correlation) {
  const double size = std::abs(correlation);
  if (size > 0.99) return "hardly told apart: more of one makes up for the other";
  if (size > 0.9)
    return "correlated: more of one makes up for part of the other; further conditions would tell them apart";
  if (size > 0.5) return "weakly correlated";
  return "told apart well";
}

}  // namespace

std::vector<Fact> misfit_facts(const CalibrationCase& values, const SummaryFile& summary,
                               const FitName& name) {
  const auto freedom = static_cast<double>(summary.count(name.prefix + "degrees_of_freedom"));
  if (!(freedom > 0))
    return {{"Misfit", std::string("The law passes through the data whatever they are: nothing is left that "
                                   "could test it.")}};
  const double ratio = std::sqrt(summary.number(name.prefix + "chi_square") / freedom);
  std::string words = size_in_words(ratio, freedom);
  if (values.data.noise == NoiseScale::estimated && ratio >= round_off)
    words += " Intervals rest on the scatter that was found, not on the stated one.";
  std::vector<Fact> facts = {{"Misfit", words}};
  const double runs = summary.number(name.prefix + "residual_runs");
  if (!std::isnan(runs) && ratio >= round_off)
    facts.push_back({"Pattern", runs_in_words(runs, summary.number(name.prefix + "residual_runs_expected"),
                                              summary.number(name.prefix + "residual_runs_deviations"))});
  return facts;
}

std::vector<Fact> correlation_facts(const std::vector<std::string>& parameters, const SummaryFile& summary,
                                    const FitName& name) {
  std::vector<Fact> facts;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const double correlation =
          summary.number(fmt::format("{}correlation_{}_{}", name.prefix, parameters[k], parameters[i]));
      if (std::isnan(correlation)) continue;
      facts.push_back({fmt::format("Correlation of {} and {}", parameters[k], parameters[i]), correlation, "",
                       told_apart(correlation)});
    }
  return facts;
}

}  // namespace fiberfate
