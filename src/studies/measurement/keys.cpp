// Describes the keys of the study measurement.
#include "studies/measurement/case.hpp"

namespace fiberfate {
namespace {

void describe_lengths(KeyTable& table, MeasuredLengthChoices& lengths) {
  table.section("lengths", "Measured fiber lengths; leave the table out when none were measured.");
  table.file("lengths.file", lengths.file,
             {.text = "CSV file with a row a fiber, or a row a length with the number of its fibers.",
              .example = "\"lengths.csv\""});
  describe_text(table, "lengths.column", lengths.column, "column",
                {.text = "Column that holds the lengths; not given: the only one, or the only one whose "
                         "heading says \"length\" with a unit.",
                 .example = "\"length\""});
  describe_text(table, "lengths.number_column", lengths.number_column, "column",
                {.text = "Column that tells how many fibers a row stands for; not given: one.",
                 .example = "\"count\""});
  describe_text(
      table, "lengths.unit", lengths.unit, "unit",
      {.text = "Unit of the lengths in the file; not given: the one in the heading, \"Length [mm]\".",
       .example = "\"um\""});
  table.quantity(
      "lengths.sample_diameter", lengths.sample_diameter,
      {.text =
           "Diameter of the region that was taken out of a larger sample to measure fewer fibers. The longer "
           "a fiber, the more likely it crosses such a region; each counts 1/(1 + 4 L/(pi d)) for it. Not "
           "given: nothing is corrected.",
       .unit = "m",
       .friendly = "mm",
       .range = Range::positive(10),
       .example = "\"5 mm\"",
       .source = "Kunc et al. 2007; thesis 4.3"});
  table.count(
      "lengths.bins", lengths.bins,
      {.text = "Bins of the histogram, from 0 to the longest fiber.", .range = Range::between(1, 10000)});
  table.quantity("lengths.bin_width", lengths.bin_width,
                 {.text = "Width of the bins, instead of their number.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::positive(10),
                  .example = "\"0.25 mm\""});
}

void describe_directions(KeyTable& table, MeasuredDirectionChoices& orientation) {
  table.section("orientation", "Measured fiber directions; leave the table out when none were measured.");
  table.file("orientation.file", orientation.file,
             {.text = "CSV file with a row a fiber.", .example = "\"directions.csv\""});
  table.choice("orientation.form", orientation.form,
               {{DirectionForm::angles, "angles", "theta from axis 3, phi from axis 1 towards axis 2"},
                {DirectionForm::vectors, "vectors", "three components along the fiber, of any length"}},
               {.text = "How the file tells directions.", .source = "thesis 2.1, corrected"});
  describe_texts(table, "orientation.columns", orientation.columns,
                 {.text = "Columns of the angles or components; not given: theta, phi or p1, p2, p3.",
                  .example = R"(["theta", "phi"])"});
  table.choice("orientation.angle_unit", orientation.angle_unit,
               {{AngleUnit::degrees, "degrees", "90 is a right angle"},
                {AngleUnit::radians, "radians", "pi/2 is a right angle"}},
               {.text = "Unit of the angles in the file."});
  describe_text(table, "orientation.weight_column", orientation.weight_column, "column",
                {.text = "Column that tells what each fiber counts, its length, say; not given: all alike.",
                 .example = "\"length\""});
  table.vector(
      "orientation.cut_normal", orientation.cut_normal, KeyTable::Cubic::no,
      {.text = "Normal of the plane cut on which the fibers were found, for ellipses on a polished "
               "section: a cut meets fibers in proportion to |p·n|, so each counts 1/|p·n|. Not given: "
               "nothing is corrected.",
       .example = "[0, 0, 1]",
       .source = "Bay, Tucker 1992"});
  table.quantity(
      "orientation.aspect_ratio", orientation.aspect_ratio,
      {.text = "Length over diameter of the fibers on the cut; it bounds the weight of fibers that lie in "
               "the plane.",
       .range = Range::at_least(1),
       .example = "20",
       .source = "Bay, Tucker 1992"});
}

}  // namespace

void describe_measurement(KeyTable& table, MeasurementCase& values) {
  describe_lengths(table, values.lengths);
  describe_directions(table, values.orientation);
  table.section("statistics", "Percentile-bootstrap intervals.");
  table.quantity("statistics.level", values.level,
                 {.text = "Confidence of the intervals.", .range = Range::inside(0, 1)});
  table.count("statistics.resamples", values.resamples,
              {.text = "Bootstrap samples.", .range = Range::between(10, 1e6), .source = "Efron 1979"});
  table.count("statistics.seed", values.seed,
              {.text = "Seed of the samples.", .range = Range::between(0, 4294967295.0)});
}

}  // namespace fiberfate
