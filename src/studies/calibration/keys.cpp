// Describes the keys of the study calibration.
#include "keys/text_keys.hpp"
#include "microstructure/closure.hpp"
#include "studies/calibration/case.hpp"

namespace fiberfate {
namespace {

void describe_conditions(KeyTable& table, CalibrationConditions& conditions) {
  table.section("conditions",
                "The experiments. Lists have one entry for each of conditions.names, or one for all.");
  describe_texts(
      table, "conditions.names", conditions.names,
      {.text = "A name for each condition.", .need = Need::required, .example = "[\"50 rpm\", \"100 rpm\"]"});
  table.quantities("conditions.rates", conditions.rates,
                   {.text = "Shear rates sqrt(2 D:D).",
                    .unit = "1/s",
                    .range = Range::between(0, 1e7),
                    .need = Need::usual,
                    .example = "[\"18.326 1/s\", \"36.652 1/s\"]",
                    .source = "thesis 5.15"});
  table.quantities("conditions.speeds", conditions.speeds,
                   {.text = "Revolutions per minute of a Couette rheometer, bare numbers, instead of rates.",
                    .range = Range::between(0, 1e6)});
  describe_couette(table, "conditions", conditions.couette);
  table.quantities("conditions.viscosities", conditions.viscosities,
                   {.text = "Viscosities of the matrix, instead of [melt].",
                    .unit = "Pa s",
                    .range = Range::positive(1e9),
                    .need = Need::usual,
                    .example = "[\"270.572 Pa s\", \"225.771 Pa s\"]"});
  table.quantities("conditions.temperatures", conditions.temperatures,
                   {.text = "Temperatures, for [melt]; not given: 523.15 K.",
                    .unit = "K",
                    .range = Range::positive(2000)});
  table.quantities("conditions.pressures", conditions.pressures,
                   {.text = "Pressures, for [melt]; not given: none.",
                    .unit = "Pa",
                    .friendly = "MPa",
                    .range = Range::between(0, 1e10)});
  table.quantities("conditions.lengths", conditions.lengths,
                   {.text = "Fiber lengths at the start, where they differ between conditions.",
                    .unit = "m",
                    .friendly = "mm",
                    .range = Range::positive(10),
                    .example = "[\"15 mm\"]"});
  table.quantities("conditions.compressions", conditions.compressions,
                   {.text = "-2 D:A/rate, for phelps and durin; not given: 1, the worst direction.",
                    .range = Range::between(0, 1)});
  describe_texts(table, "conditions.flows", conditions.flows,
                 {.text = "For orientation: shear, planar, uniaxial or biaxial; not given: shear."});
  describe_shear_gradient(table, "conditions", conditions.shear_gradient);
  describe_moldings(table, conditions);
  table.orientation("conditions.orientation", conditions.orientation,
                    {.text = "A2 at the start, for orientation."});
}

void describe_data(KeyTable& table, CalibrationData& data) {
  table.section("data", "What was measured.");
  describe_text_rows(
      table, "data.series", data.series, 2,
      {.text =
           "Rows [condition, quantity, file]: a CSV file with a column time_s and one named after the "
           "quantity (as "
           "series.csv has them: L_N_m, L_W_m, a11 ...), and maybe one more with _sd behind the name, its "
           "standard "
           "deviation. Quantities: L_N, L_W, a11 ... a23. Rows [condition, \"L_inf\" or \"k_f\", value] hold "
           "one "
           "value. Rows [condition, \"histogram\", file, time] take the columns length_low_m, length_high_m, "
           "number_share.",
       .need = Need::usual,
       .example = R"([["50 rpm", "L_W", "lengths_50rpm.csv"], ["50 rpm", "L_inf", "1.5 mm"]])"});
  describe_molded_lengths(table, data);
  table.quantity(
      "data.relative_uncertainty", data.relative_uncertainty,
      {.text = "Standard deviation of lengths and rate constants over their values, where the file has none.",
       .range = Range::positive(10)});
  table.quantity(
      "data.absolute_uncertainty", data.absolute_uncertainty,
      {.text = "Standard deviation of components of A2 and of shares in histograms, where the file has none.",
       .range = Range::positive(1)});
  table.choice("data.noise", data.noise,
               {{NoiseScale::estimated, "estimated",
                 "the uncertainties are relative weights; the misfit tells their scale"},
                {NoiseScale::known, "known", "the uncertainties are true"}},
               {.text = "What the uncertainties mean."});
}

void describe_search(KeyTable& table, CalibrationSearch& search) {
  table.section("fit", "What is sought.");
  describe_texts(
      table, "fit.free", search.free,
      {.text = "Parameters to fit; they start from the values of the law's table, the others stay there.",
       .need = Need::required,
       .example = R"(["lambda", "alpha", "k_0", "beta"])"});
  describe_texts(table, "fit.linear", search.linear,
                 {.text = "Free parameters searched by value; the others are searched by their logarithm."});
  describe_text_rows(table, "fit.bounds", search.bounds, -1,
                     {.text = "Rows [parameter, lower, upper], with units; not given: the law's own bounds.",
                      .example = R"([["alpha", 0.1, 5]])"});
  table.choice("fit.scope", search.scope,
               {{FitScope::together, "together", "one set of parameters for all conditions"},
                {FitScope::separately, "separately", "one for each condition"}},
               {.text = "Whether conditions share the parameters."});
  table.count("fit.starts", search.starts,
              {.text = "Searches from as many places; the best is kept.", .range = Range::between(1, 10000)});
  table.quantity("fit.level", search.level,
                 {.text = "Confidence of the intervals.", .range = Range::inside(0, 1)});
  table.choice(
      "fit.profiles", search.profiles,
      {{ProfileChoice::all, "all", "of every free parameter"},
       {ProfileChoice::none, "none", "linearised intervals only"}},
      {.text = "Intervals by profiles of the likelihood; each takes as long as some dozens of fits."});
  table.count("fit.bootstrap", search.bootstrap,
              {.text = "Bootstrap samples; 0: none.", .range = Range::between(0, 1e6)});
  table.count(
      "fit.seed", search.seed,
      {.text = "Of the other starts and of the bootstrap.", .range = Range::between(0, 4294967295.0)});
}

void describe_sweep(KeyTable& table, CalibrationSweep& sweep) {
  table.section("sweep",
                "The average error |predicted - measured|/measured over one parameter (thesis 4.7, 4.8).");
  describe_text(table, "sweep.parameter", sweep.parameter, "parameter",
                {.text = "The parameter; the others stay at the fit.",
                 .example = "\"xi\"",
                 .source = "thesis figure 4.2"});
  table.quantity("sweep.lower", sweep.lower,
                 {.text = "First value, in the parameter's SI unit; not given: a tenth of the fit."});
  table.quantity("sweep.upper", sweep.upper, {.text = "Last value; not given: ten times the fit."});
  table.count("sweep.count", sweep.count, {.text = "Number of values.", .range = Range::between(3, 100000)});
  table.choice("sweep.spacing", sweep.spacing,
               {{ParameterScale::logarithmic, "logarithmic", "equal ratios"},
                {ParameterScale::linear, "linear", "equal differences"}},
               {.text = "How the values are spaced."});
}

}  // namespace

void describe_calibration(KeyTable& table, CalibrationCase& values) {
  describe_law(
      table, attrition_menu(),
      {"law",
       "The attrition law that is calibrated: values from which its parameters start, or which they keep.",
       "\"stress_induced\"", Need::usual},
      values.law);
  describe_law(
      table, orientation_menu(),
      {"orientation", "The orientation law that is calibrated, instead of [law].", "\"rsc\"", Need::optional},
      values.orientation);
  std::vector<std::pair<std::string, std::string>> names;
  for (const ClosureDescription& one : fiberfate::closures()) names.emplace_back(one.name, one.meaning);
  describe_name(table, "orientation.closure", values.closure, names, {.text = "How A4 follows from A2."});
  describe_law(table, viscosity_menu(),
               {"melt", "Viscosity of the matrix, where conditions.viscosities is not given.",
                "\"newtonian\"", Need::optional},
               values.melt);
  table.section("fibers", "Lengths at the start of every condition, and how they are followed.");
  describe_initial_distribution(table, "fibers", values.fibers);
  describe_length_form(table, "fibers", values.fibers);
  describe_conditions(table, values.conditions);
  describe_data(table, values.data);
  describe_search(table, values.search);
  describe_sweep(table, values.sweep);
}

}  // namespace fiberfate
