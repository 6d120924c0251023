// The keys of one kind of fibers.
#include "studies/sample/fiber_kind.hpp"

namespace fiberfate {
namespace {

KeyGroup<LengthHistogram> histogram_keys(const std::string& section) {
  using Histogram = LengthHistogram;
  const Choices<HistogramHeight> heights = {
      {HistogramHeight::fibers, "fibers", "share of the number of fibers"},
      {HistogramHeight::length, "length", "share of the total length of the fibers"}};
  return {section,
          "Lengths from a histogram, instead of fibers.length; within a bin they are spread evenly.",
          {
              key("edges", &Histogram::edges, {"m", "mm"}, Range::between(0, 0.1),
                  "Edges of the bins, rising: one more than there are bins.",
                  optional(R"(["0.5 mm", "1 mm", "1.5 mm", "2 mm"])")),
              key("heights", &Histogram::heights, {}, Range::not_negative(),
                  "Heights of the bins, on any scale.", optional("[30, 50, 20]"), "thesis equation 3.30"),
              key("height", &Histogram::height, heights, "What the heights count.",
                  "thesis equations 3.30, 3.31"),
          }};
}

KeyGroup<LengthDistributionChoices> distribution_keys(const std::string& section) {
  using Smooth = LengthDistributionChoices;
  const Choices<LengthDistributionLaw> laws = {
      {LengthDistributionLaw::weibull, "weibull", "P(L < x) = 1 - exp(-(x/a)^b), by number"},
      {LengthDistributionLaw::log_normal, "log_normal", "ln L is normal, by number"}};
  return {section,
          "Lengths from a smooth law with given means, instead of one length.",
          {
              key("law", &Smooth::law, laws, "The law."),
              key("number_average", &Smooth::number_average, {"m", "mm"}, Range::between(1e-6, 0.1),
                  "Mean length by number, L_N.", optional("\"1.0 mm\""), "thesis equation 2.5"),
              key("weight_average", &Smooth::weight_average, {"m", "mm"}, Range::between(1e-6, 0.1),
                  "Mean length by weight, L_W; at least L_N.", optional("\"2.0 mm\""), "thesis equation 2.6"),
          }};
}

}  // namespace

const KeyRows<FiberKind>& fiber_kind_rows() {
  using Kind = FiberKind;
  static const KeyRows<Kind> rows = {
      key("length", &Kind::length, {"m", "mm"}, Range::between(1e-6, 0.1),
          "Length of every fiber. Instead of it, lengths, or the table length_histogram or "
          "length_distribution, gives a distribution.",
          usual("\"2.5 mm\""), "thesis section 3.3.3"),
      rows_key("lengths", &Kind::lengths, {{"length", {"m", "mm"}, Range::between(1e-6, 0.1)}},
               "Measured lengths, each of as many fibers as the others: a list, or the path of a text file "
               "with one length in m a line. Of a list longer than the sample, lengths are picked evenly.",
               optional(R"(["0.5 mm", "0.8 mm", "2.1 mm"])")),
      key("diameter", &Kind::diameter, {"m", "um"}, Range::between(1e-7, 1e-3), "Diameter of every fiber.",
          required("\"19 um\""), "thesis table 3"),
      key("youngs_modulus", &Kind::youngs_modulus, {"Pa", "GPa"}, Range::between(1e6, 2e12),
          "Young's modulus of the fibers; with the diameter it gives the bending stiffness E pi d^4/64.",
          required("\"73 GPa\""), "thesis table 3"),
      key("density", &Kind::density, {"kg/m3"}, Range::between(100, 25000),
          "Density of the fibers. Only weight fractions need it.", optional("\"2550 kg/m3\""), "E glass"),
      key("rod_length", &Kind::rod_length, {"m", "mm"}, Range::positive(0.1),
          "Wanted length of the rigid rods of which a flexible fiber is a chain. A fiber is cut into equal "
          "rods, as many as come nearest to this length; a rod is at least one diameter long.",
          usual("\"0.1 mm\""), "thesis section 3.3.3"),
  };
  return rows;
}

void describe_length_laws(KeyTable& keys, const std::string& table, FiberKind& kind) {
  describe(keys, histogram_keys(table + ".length_histogram"), kind.length_histogram);
  describe(keys, distribution_keys(table + ".length_distribution"), kind.length_distribution);
}

}  // namespace fiberfate
