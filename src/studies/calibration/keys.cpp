// The keys of the study calibration.
#include "studies/calibration/case.hpp"

namespace fiberfate {
namespace {

KeyGroup<CalibrationConditions> condition_keys() {
  using Conditions = CalibrationConditions;
  const KeyRows<Conditions> rates = {
      texts_key("names", &Conditions::names, "A name for each condition.",
                required("[\"50 rpm\", \"100 rpm\"]")),
      key("rates", &Conditions::rates, {"1/s"}, Range::between(0, 1e7), "Shear rates sqrt(2 D:D).",
          usual("[\"18.326 1/s\", \"36.652 1/s\"]"), "thesis 5.15"),
      key("speeds", &Conditions::speeds, {}, Range::between(0, 1e6),
          "Revolutions per minute of a Couette rheometer, bare numbers, instead of rates."),
  };
  const KeyRows<Conditions> others = {
      key("viscosities", &Conditions::viscosities, {"Pa s"}, Range::positive(1e9),
          "Viscosities of the matrix, instead of [melt].", usual("[\"270.572 Pa s\", \"225.771 Pa s\"]")),
      key("temperatures", &Conditions::temperatures, {"K"}, Range::positive(2000),
          "Temperatures, for [melt]; not given: 250 degC."),
      key("pressures", &Conditions::pressures, {"Pa", "MPa"}, Range::between(0, 1e10),
          "Pressures, for [melt]; not given: none."),
      key("lengths", &Conditions::lengths, {"m", "mm"}, Range::positive(10),
          "Fiber lengths at the start, where they differ between conditions.", usual("[\"15 mm\"]")),
      key("compressions", &Conditions::compressions, {}, Range::between(0, 1),
          "-2 D:A/rate, for " + laws_of_bins() + "; not given: 1, the worst direction."),
      texts_key("flows", &Conditions::flows,
                "For orientation: shear, planar, uniaxial or biaxial; not given: shear."),
      key("shear_gradient", &Conditions::shear_gradient, shear_gradient_choices(), shear_gradient_text),
      moldings_key(),
      orientation_key("orientation", &Conditions::orientation, "A2 at the start, for orientation."),
  };
  return {"conditions", "The experiments. Lists have one entry for each of conditions.names, or one for all.",
          joined<Conditions>({rates, rows_of(&Conditions::couette, couette_rows()), others})};
}

void describe_series(KeyTable& table, const std::string& name, CalibrationData& data) {
  describe_text_rows(
      table, name, data.series, 2,
      {.text = "Rows [condition, quantity, file]: a CSV file with a column time_s and one named after the "
               "quantity (as series.csv has them: L_N_m, L_W_m, a11 ...), and maybe one more with _sd behind "
               "the name, its standard deviation. Other units are read from headings such as L_N_mm, "
               "\"L_N [mm]\", time_min. Quantities: L_N, L_W, a11 ... a23. Rows [condition, "
               "\"L_inf\" or \"k_f\", value] hold one value. Rows [condition, \"histogram\", file, time] "
               "take the columns length_low_m, length_high_m, number_share.",
       .need = Need::usual,
       .example = R"([["50 rpm", "L_W", "lengths_50rpm.csv"], ["50 rpm", "L_inf", "1.5 mm"]])"});
}

KeyGroup<CalibrationData> data_keys() {
  using Data = CalibrationData;
  const Choices<NoiseScale> noises = {
      {NoiseScale::estimated, "estimated",
       "the uncertainties are relative weights; the misfit tells their scale"},
      {NoiseScale::known, "known", "the uncertainties are true"}};
  return {"data",
          "What was measured.",
          {
              {"series", describe_series},
              molded_lengths_key(),
              key("relative_uncertainty", &Data::relative_uncertainty, {}, Range::positive(10),
                  "Standard deviation of lengths and rate constants over their values, where the file has "
                  "none."),
              key("absolute_uncertainty", &Data::absolute_uncertainty, {}, Range::positive(1),
                  "Standard deviation of components of A2 and of shares in histograms, where the file has "
                  "none."),
              key("noise", &Data::noise, noises, "What the uncertainties mean."),
          }};
}

void describe_bounds(KeyTable& table, const std::string& name, CalibrationSearch& search) {
  describe_text_rows(table, name, search.bounds, -1,
                     {.text = "Rows [parameter, lower, upper], with units; not given: the law's own bounds.",
                      .example = R"([["alpha", 0.1, 5]])"});
}

KeyGroup<CalibrationSearch> search_keys() {
  using Search = CalibrationSearch;
  const Choices<FitScope> scopes = {
      {FitScope::together, "together", "one set of parameters for all conditions"},
      {FitScope::separately, "separately", "one for each condition"}};
  const Choices<ProfileChoice> profiles = {{ProfileChoice::all, "all", "of every free parameter"},
                                           {ProfileChoice::none, "none", "linearised intervals only"}};
  return {"fit",
          "What is sought.",
          {
              texts_key("free", &Search::free,
                        "Parameters to fit; they start from the values of the law's table, the others stay "
                        "there.",
                        required(R"(["lambda", "alpha", "k_0", "beta"])")),
              texts_key("linear", &Search::linear,
                        "Free parameters searched by value; the others are searched by their logarithm."),
              {"bounds", describe_bounds},
              key("scope", &Search::scope, scopes, "Whether conditions share the parameters."),
              key("starts", &Search::starts, {}, Range::between(1, 10000),
                  "Starting points of the search; the best fit is kept."),
              key("level", &Search::level, {}, Range::inside(0, 1), "Confidence of the intervals."),
              key("profiles", &Search::profiles, profiles,
                  "Intervals by profiles of the likelihood; each takes as long as some dozens of fits."),
              key("bootstrap", &Search::bootstrap, {}, Range::between(0, 1e6), "Bootstrap samples; 0: none."),
              key("seed", &Search::seed, {}, Range::between(0, 4294967295.0),
                  "Of the other starts and of the bootstrap."),
          }};
}

KeyGroup<CalibrationSweep> sweep_keys() {
  using Sweep = CalibrationSweep;
  const Choices<ParameterScale> spacings = {{ParameterScale::logarithmic, "logarithmic", "equal ratios"},
                                            {ParameterScale::linear, "linear", "equal differences"}};
  return {"sweep",
          "The average error |predicted - measured|/measured over one parameter (thesis 4.7, 4.8).",
          {
              text_key("parameter", &Sweep::parameter, "parameter",
                       "The parameter; the others stay at the fit.", optional("\"xi\""), "thesis figure 4.2"),
              key("lower", &Sweep::lower, {}, Range::any(),
                  "First value, in the parameter's SI unit; not given: a tenth of the fit."),
              key("upper", &Sweep::upper, {}, Range::any(), "Last value; not given: ten times the fit."),
              key("count", &Sweep::count, {}, Range::between(3, 100000), "Number of values."),
              key("spacing", &Sweep::spacing, spacings, "How the values are spaced."),
          }};
}

}  // namespace

void describe_calibration(KeyTable& table, CalibrationCase& values) {
  const LawTable law = {
      "law",
      "The attrition law that is calibrated: values from which its parameters start, or which they keep.",
      "\"stress_induced\"",
      Need::usual,
      {{"lambda", "1e-5"}, {"alpha", "1.2"}, {"k_0", "\"5000 1/s\""}, {"beta", "1"}}};
  const LawTable orientation = {"orientation", "The orientation law that is calibrated, instead of [law].",
                                "\"rsc\"", Need::optional};
  const LawTable melt = {"melt", "Viscosity of the matrix, where conditions.viscosities is not given.",
                         "\"newtonian\"", Need::optional};
  const KeyRows<CalibrationCase> closure = {
      name_key("closure", &CalibrationCase::closure, closure_names(), "How A4 follows from A2.")};
  const KeyGroup<LengthChoices> fibers = {
      "fibers", "Lengths at the start of every condition, and how they are followed.",
      joined<LengthChoices>({initial_length_rows(), length_form_rows()})};
  describe_law(table, attrition_menu(), law, values.law);
  describe_law(table, orientation_menu(), orientation, values.orientation);
  describe(table, "orientation", closure, values);
  describe_law(table, viscosity_menu(), melt, values.melt);
  describe(table, fibers, values.fibers);
  describe(table, condition_keys(), values.conditions);
  describe(table, data_keys(), values.data);
  describe(table, search_keys(), values.search);
  describe(table, sweep_keys(), values.sweep);
}

}  // namespace fiberfate
