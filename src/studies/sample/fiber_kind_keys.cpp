// Describes the keys of one kind of fibers.
#include "studies/sample/fiber_kind.hpp"

namespace fiberfate {
namespace {

void describe_histogram(KeyTable& keys, const std::string& table, LengthHistogram& histogram) {
  keys.section(table + ".length_histogram",
               "Lengths from a histogram, instead of fibers.length; within a bin they are "
               "spread evenly.");
  keys.quantities(table + ".length_histogram.edges", histogram.edges,
                  {.text = "Edges of the bins, rising: one more than there are bins.",
                   .unit = "m",
                   .friendly = "mm",
                   .range = Range::between(0, 0.1),
                   .example = R"(["0.5 mm", "1 mm", "1.5 mm", "2 mm"])"});
  keys.quantities(table + ".length_histogram.heights", histogram.heights,
                  {.text = "Heights of the bins, on any scale.",
                   .range = Range::not_negative(),
                   .example = "[30, 50, 20]",
                   .source = "thesis equation 3.30"});
  keys.choice(table + ".length_histogram.height", histogram.height,
              {{HistogramHeight::fibers, "fibers", "share of the number of fibers"},
               {HistogramHeight::length, "length", "share of the total length of the fibers"}},
              {.text = "What the heights count.", .source = "thesis equations 3.30, 3.31"});
}

void describe_distribution(KeyTable& keys, const std::string& table,
                           LengthDistributionChoices& distribution) {
  keys.section(table + ".length_distribution",
               "Lengths from a smooth law with given means, instead of one length.");
  keys.choice(table + ".length_distribution.law", distribution.law,
              {{LengthDistributionLaw::weibull, "weibull", "P(L < x) = 1 - exp(-(x/a)^b), by number"},
               {LengthDistributionLaw::log_normal, "log_normal", "ln L is normal, by number"}},
              {.text = "The law."});
  keys.quantity(table + ".length_distribution.number_average", distribution.number_average,
                {.text = "Mean length by number, L_N.",
                 .unit = "m",
                 .friendly = "mm",
                 .range = Range::between(1e-6, 0.1),
                 .example = "\"1.0 mm\"",
                 .source = "thesis equation 2.5"});
  keys.quantity(table + ".length_distribution.weight_average", distribution.weight_average,
                {.text = "Mean length by weight, L_W; at least L_N.",
                 .unit = "m",
                 .friendly = "mm",
                 .range = Range::between(1e-6, 0.1),
                 .example = "\"2.0 mm\"",
                 .source = "thesis equation 2.6"});
}

}  // namespace

void describe_fiber_kind(KeyTable& keys, const std::string& table, FiberKind& kind) {
  keys.quantity(table + ".length", kind.length,
                {.text = "Length of every fiber. Instead of it, lengths, or the table length_histogram or "
                         "length_distribution, gives a distribution.",
                 .unit = "m",
                 .friendly = "mm",
                 .range = Range::between(1e-6, 0.1),
                 .need = Need::usual,
                 .example = "\"2.5 mm\"",
                 .source = "thesis section 3.3.3"});
  keys.rows(
      table + ".lengths", kind.lengths, {{"length", {"m", "mm"}, Range::between(1e-6, 0.1)}},
      {.text = "Measured lengths, each of as many fibers as the others: a list, or the path of a text file "
               "with one length in m a line. Of a list longer than the sample, lengths are picked evenly.",
       .example = R"(["0.5 mm", "0.8 mm", "2.1 mm"])"});
  keys.quantity(table + ".diameter", kind.diameter,
                {.text = "Diameter of every fiber.",
                 .unit = "m",
                 .friendly = "um",
                 .range = Range::between(1e-7, 1e-3),
                 .need = Need::required,
                 .example = "\"19 um\"",
                 .source = "thesis table 3"});
  keys.quantity(
      table + ".youngs_modulus", kind.youngs_modulus,
      {.text = "Young's modulus of the fibers; with the diameter it gives the bending stiffness E pi d^4/64.",
       .unit = "Pa",
       .friendly = "GPa",
       .range = Range::between(1e6, 2e12),
       .need = Need::required,
       .example = "\"73 GPa\"",
       .source = "thesis table 3"});
  keys.quantity(table + ".density", kind.density,
                {.text = "Density of the fibers. Only weight fractions need it.",
                 .unit = "kg/m3",
                 .range = Range::between(100, 25000),
                 .example = "\"2550 kg/m3\"",
                 .source = "E glass"});
  keys.quantity(
      table + ".rod_length", kind.rod_length,
      {.text = "Wanted length of the rigid rods of which a flexible fiber is a chain. A fiber is cut into "
               "equal rods, as many as come nearest to this length; a rod is at least one diameter long.",
       .unit = "m",
       .friendly = "mm",
       .range = Range::positive(0.1),
       .need = Need::usual,
       .example = "\"0.1 mm\"",
       .source = "thesis section 3.3.3"});
}

void describe_length_laws(KeyTable& keys, const std::string& table, FiberKind& kind) {
  describe_histogram(keys, table, kind.length_histogram);
  describe_distribution(keys, table, kind.length_distribution);
}

}  // namespace fiberfate
