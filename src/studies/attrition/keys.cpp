// The keys of the study attrition.
#include "studies/attrition/case.hpp"

namespace fiberfate {
namespace {

KeyGroup<AttritionFlowChoices> flow_keys() {
  using Flow = AttritionFlowChoices;
  const Choices<AttritionFlow> kinds = {
      {AttritionFlow::constant, "constant", "flow.rate from the first moment"},
      {AttritionFlow::couette, "couette", "a Couette rheometer at flow.speed"},
      {AttritionFlow::table, "table", "rate, temperature and pressure follow flow.table"}};
  const Choices<HistoryForm> forms = {
      {HistoryForm::steps, "steps", "each row of the table holds until the next"},
      {HistoryForm::ramps, "ramps", "linear between the rows"}};
  const std::vector<Column> columns = {{"time", {"s", "s"}, Range::not_negative()},
                                       {"rate", {"1/s", "1/s"}, Range::between(0, 1e7)},
                                       {"temperature", {"K", "K"}, Range::positive(2000)},
                                       {"pressure", {"Pa", "Pa"}, Range::between(0, 1e10)}};
  const KeyRows<Flow> kind = {
      key("kind", &Flow::kind, kinds, "What the flow is."),
      key("rate", &Flow::rate, {"1/s"}, Range::between(0, 1e7),
          "Shear rate sqrt(2 D:D), for kind = \"constant\".", usual("\"18.326 1/s\""), "thesis 5.15"),
      key("speed", &Flow::speed, {}, Range::between(0, 1e6),
          "Revolutions per minute of the inner cylinder, a bare number, for kind = \"couette\".",
          optional("50")),
  };
  const KeyRows<Flow> melt = {
      key("temperature", &Flow::temperature, {"K"}, Range::positive(2000), "Temperature of the melt."),
      key("pressure", &Flow::pressure, {"Pa", "MPa"}, Range::between(0, 1e10), "Pressure in the melt."),
      rows_key(
          "table", &Flow::table, columns,
          "For kind = \"table\": rows [time, rate, temperature, pressure] from time 0 on, or the path of "
          "a text file with such rows in SI.",
          optional(R"([["0 s", "10 1/s", "523.15 K", "0 Pa"], ["2 s", "100 1/s", "513.15 K", "10 MPa"]])")),
      key("form", &Flow::form, forms,
          "What happens between the rows of the table; the last one holds to the end."),
      key("compression", &Flow::compression, {}, Range::between(0, 1),
          "-2 D:A/rate of the fibers' orientation; 1 is the worst direction. Only " + laws_of_bins() + ".",
          {}, "Phelps et al. 2013"),
  };
  return {"flow", "The shear that breaks the fibers.",
          joined<Flow>({kind, rows_of(&Flow::couette, couette_rows()), melt})};
}

KeyGroup<LengthChoices> fiber_keys() {
  const KeyRows<LengthChoices> length = {key("length", &LengthChoices::length, {"m", "mm"},
                                             Range::positive(10), "One length of all fibers.",
                                             usual("\"15 mm\""), "thesis chapter 5")};
  return {"fibers", "The lengths at the start; give length, distribution, or both mean lengths.",
          joined<LengthChoices>({length, initial_length_rows(), length_form_rows()})};
}

KeyGroup<AttritionOutputChoices> output_keys() {
  using Output = AttritionOutputChoices;
  const KeyRows<Output> histograms = {
      key("histogram_times", &Output::histogram_times, {"s"}, Range::not_negative(),
          "Times of the length histograms; not given: start and end."),
      key("histogram_bins", &Output::histogram_bins, {}, Range::between(1, 10000),
          "Bins of the histograms, from 0 to the longest fiber."),
  };
  return {"output", "What is kept.",
          joined<Output>({rows_of_base<Output, SeriesChoices>(series_rows()), histograms})};
}

}  // namespace

void describe_attrition(KeyTable& table, AttritionCase& values) {
  const LawTable law = {"law",
                        "How fibers break (docs/theory/length.md).",
                        "\"stress_induced\"",
                        Need::required,
                        {{"lambda", "2e-6"}, {"alpha", "1.35"}, {"k_0", "\"68000 1/s\""}, {"beta", "1.14"}}};
  const LawTable compare = {"compare", "A second law on the same fibers and flow, for comparison.",
                            "\"phelps\"", Need::optional};
  const LawTable melt = {"melt",
                         "Viscosity of the matrix (docs/theory/viscosity.md).",
                         "\"newtonian\"",
                         Need::optional,
                         {{"eta_0", "\"200 Pa s\""}}};
  const KeyGroup<RunChoices> run = {"run", "How long.", {duration_key(1e9, "\"150 s\"")}};
  describe_law(table, attrition_menu(), law, values.law);
  describe_law(table, attrition_menu(), compare, values.compared);
  describe_law(table, viscosity_menu(), melt, values.melt);
  describe(table, flow_keys(), values.flow);
  describe(table, fiber_keys(), values.fibers);
  describe(table, run, values.run);
  describe(table, output_keys(), values.output);
}

}  // namespace fiberfate
