// Describes the keys of the study attrition.
#include "studies/attrition/case.hpp"

namespace fiberfate {
namespace {

void describe_flow(KeyTable& table, AttritionFlowChoices& flow) {
  table.section("flow", "The shear that breaks the fibers.");
  table.choice("flow.kind", flow.kind,
               {{AttritionFlow::constant, "constant", "flow.rate from the first moment"},
                {AttritionFlow::couette, "couette", "a Couette rheometer at flow.speed"},
                {AttritionFlow::table, "table", "rate, temperature and pressure follow flow.table"}},
               {.text = "What the flow is."});
  table.quantity("flow.rate", flow.rate,
                 {.text = "Shear rate sqrt(2 D:D), for kind = \"constant\".",
                  .unit = "1/s",
                  .range = Range::between(0, 1e7),
                  .need = Need::usual,
                  .example = "\"18.326 1/s\"",
                  .source = "thesis 5.15"});
  table.quantity(
      "flow.speed", flow.speed,
      {.text = "Revolutions per minute of the inner cylinder, a bare number, for kind = \"couette\".",
       .range = Range::between(0, 1e6),
       .example = "50"});
  describe_couette(table, "flow", flow.couette);
  table.quantity("flow.temperature", flow.temperature,
                 {.text = "Temperature of the melt.", .unit = "K", .range = Range::positive(2000)});
  table.quantity(
      "flow.pressure", flow.pressure,
      {.text = "Pressure in the melt.", .unit = "Pa", .friendly = "MPa", .range = Range::between(0, 1e10)});
  table.rows(
      "flow.table", flow.table,
      {{"time", {"s", "s"}, Range::not_negative()},
       {"rate", {"1/s", "1/s"}, Range::between(0, 1e7)},
       {"temperature", {"K", "K"}, Range::positive(2000)},
       {"pressure", {"Pa", "Pa"}, Range::between(0, 1e10)}},
      {.text =
           "For kind = \"table\": rows [time, rate, temperature, pressure] from time 0 on, or the path of a "
           "text file with such rows in SI.",
       .example = R"([["0 s", "10 1/s", "523.15 K", "0 Pa"], ["2 s", "100 1/s", "513.15 K", "10 MPa"]])"});
  table.choice("flow.form", flow.form,
               {{HistoryForm::steps, "steps", "each row of the table holds until the next"},
                {HistoryForm::ramps, "ramps", "linear between the rows"}},
               {.text = "What happens between the rows of the table; the last one holds to the end."});
  table.quantity(
      "flow.compression", flow.compression,
      {.text = "-2 D:A/rate of the fibers' orientation; 1 is the worst direction. Only phelps and durin.",
       .range = Range::between(0, 1),
       .source = "Phelps et al. 2013"});
}

void describe_fibers(KeyTable& table, AttritionFiberChoices& fibers) {
  table.section("fibers", "The lengths at the start; give length, distribution, or both mean lengths.");
  table.quantity("fibers.length", fibers.length,
                 {.text = "One length of all fibers.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(10),
                  .need = Need::usual,
                  .example = "\"15 mm\"",
                  .source = "thesis chapter 5"});
  describe_initial_distribution(table, "fibers", fibers);
  describe_length_form(table, "fibers", fibers);
}

void describe_output(KeyTable& table, AttritionCase& values) {
  table.section("run", "How long.");
  table.quantity("run.duration", values.duration,
                 {.text = "Simulated time.",
                  .unit = "s",
                  .range = Range::positive(1e9),
                  .need = Need::required,
                  .example = "\"150 s\""});
  table.section("output", "What is kept.");
  table.quantity("output.interval", values.output.interval,
                 {.text = "Time between rows of series.csv; not given: a 200th of the duration.",
                  .unit = "s",
                  .range = Range::positive()});
  table.quantities("output.histogram_times", values.output.histogram_times,
                   {.text = "Times of the length histograms; not given: start and end.",
                    .unit = "s",
                    .range = Range::not_negative()});
  table.count(
      "output.histogram_bins", values.output.histogram_bins,
      {.text = "Bins of the histograms, from 0 to the longest fiber.", .range = Range::between(1, 10000)});
}

}  // namespace

void describe_couette(KeyTable& table, const std::string& section, CouetteRheometer& couette) {
  table.quantity(section + ".inner_radius", couette.inner_radius,
                 {.text = "Radius of the rheometer's inner cylinder, which turns.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(10)});
  table.quantity(
      section + ".outer_radius", couette.outer_radius,
      {.text = "Radius of the rheometer's outer cylinder; the default gap gives the thesis' rates.",
       .unit = "m",
       .friendly = "mm",
       .range = Range::positive(10),
       .source = "thesis 5.15: 18.326 1/s at 50 rpm"});
  table.choice(section + ".rate_at", couette.choice,
               {{CouetteRate::narrow_gap, "narrow_gap", "wall speed over gap, as the thesis"},
                {CouetteRate::inner_wall, "inner_wall", "exact, at the inner cylinder"},
                {CouetteRate::outer_wall, "outer_wall", "exact, at the outer cylinder"},
                {CouetteRate::mean, "mean", "exact, averaged over the gap"}},
               {.text = "Which shear rate of the rheometer stands for all of it."});
  table.quantity(section + ".power_law_index", couette.power_law_index,
                 {.text = "Power-law index of the melt for the exact rates; 1 is Newtonian.",
                  .range = Range::positive(2)});
}

void describe_initial_distribution(KeyTable& table, const std::string& section,
                                   AttritionFiberChoices& fibers) {
  table.rows(
      section + ".distribution", fibers.distribution,
      {{"length", {"m", "mm"}, Range::positive(10)}, {"number", {"1", "1"}, Range::not_negative()}},
      {.text = "Classes: rows [length, number of fibers], or the path of a text file with such rows in SI.",
       .example = R"([["0.5 mm", 120], ["1 mm", 60], ["5 mm", 4]])",
       .source = "thesis 4.4"});
  table.quantity(section + ".number_average", fibers.number_average,
                 {.text = "L_N at the start; with form = \"distribution\", of a Weibull distribution.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(10)});
  table.quantity(section + ".weight_average", fibers.weight_average,
                 {.text = "L_W at the start.", .unit = "m", .friendly = "mm", .range = Range::positive(10)});
}

void describe_length_form(KeyTable& table, const std::string& section, AttritionFiberChoices& fibers) {
  table.choice(section + ".form", fibers.form,
               {{LengthForm::distribution, "distribution", "classes of initial length, or bins"},
                {LengthForm::means, "means", "L_N and L_W, each by its own equation"}},
               {.text = "What is followed.", .source = "thesis 4.3 (means), 4.4 (distribution)"});
  table.choice(section + ".weight", fibers.weight,
               {{ClassWeight::length, "length", "the fiber length of the class: nothing is lost"},
                {ClassWeight::number, "number", "the number of its fibers, as the thesis"}},
               {.text = "What a class keeps while it becomes shorter; not for phelps and durin."});
  table.count(section + ".bins", fibers.bins,
              {.text = "Bins of phelps and durin. L_ub should span several of them.",
               .range = Range::between(2, static_cast<double>(most_bins))});
  table.quantity(section + ".largest_length", fibers.largest_length,
                 {.text = "Length of the last bin; not given: the longest fiber at the start.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(10)});
}

void describe_attrition(KeyTable& table, AttritionCase& values) {
  describe_law(table, attrition_menu(),
               {"law", "How fibers break (docs/theory/length.md).", "\"stress_induced\"", Need::required},
               values.law);
  describe_law(
      table, attrition_menu(),
      {"compare", "A second law on the same fibers and flow, for comparison.", "\"phelps\"", Need::optional},
      values.compared);
  describe_law(
      table, viscosity_menu(),
      {"melt", "Viscosity of the matrix (docs/theory/viscosity.md).", "\"newtonian\"", Need::optional},
      values.melt);
  describe_flow(table, values.flow);
  describe_fibers(table, values.fibers);
  describe_output(table, values);
}

}  // namespace fiberfate
