// The keys of the study measurement.
#include "keys/key_rows.hpp"
#include "studies/measurement/case.hpp"

namespace fiberfate {
namespace {

KeyGroup<MeasuredLengthChoices> length_keys() {
  using Lengths = MeasuredLengthChoices;
  return {
      "lengths",
      "Measured fiber lengths; leave the table out when none were measured.",
      {
          file_key("file", &Lengths::file,
                   "CSV file with a row a fiber, or a row a length with the number of its fibers.",
                   usual("\"lengths.csv\"")),
          text_key(
              "column", &Lengths::column, "column",
              "Column that holds the lengths; not given: the only one, or the only one whose heading says "
              "\"length\" with a unit.",
              optional("\"length\"")),
          text_key("number_column", &Lengths::number_column, "column",
                   "Column that tells how many fibers a row stands for; not given: one.",
                   optional("\"count\"")),
          text_key("unit", &Lengths::unit, "unit",
                   "Unit of the lengths in the file; not given: the one in the heading, \"Length [mm]\".",
                   optional("\"um\"")),
          key("sample_diameter", &Lengths::sample_diameter, {"m", "mm"}, Range::positive(10),
              "Diameter of the region that was taken out of a larger sample to measure fewer fibers. The "
              "longer a fiber, the more likely it crosses such a region; each counts 1/(1 + 4 L/(pi d)) for "
              "it. Not given: nothing is corrected.",
              optional("\"5 mm\""), "Kunc et al. 2007; thesis 4.3"),
          key("bins", &Lengths::bins, {}, Range::between(1, most_histogram_bins),
              "Bins of the histogram, from 0 to the longest fiber."),
          key("bin_width", &Lengths::bin_width, {"m", "mm"}, Range::positive(10),
              "Width of the bins, instead of their number.", optional("\"0.25 mm\"")),
      }};
}

KeyGroup<MeasuredDirectionChoices> direction_keys() {
  using Directions = MeasuredDirectionChoices;
  const Choices<DirectionForm> forms = {
      {DirectionForm::angles, "angles", "theta from axis 3, phi from axis 1 towards axis 2"},
      {DirectionForm::vectors, "vectors", "three components along the fiber, of any length"}};
  const Choices<AngleUnit> units = {{AngleUnit::degrees, "degrees", "90 is a right angle"},
                                    {AngleUnit::radians, "radians", "pi/2 is a right angle"}};
  return {
      "orientation",
      "Measured fiber directions; leave the table out when none were measured.",
      {
          file_key("file", &Directions::file, "CSV file with a row a fiber.", optional("\"directions.csv\"")),
          key("form", &Directions::form, forms, "How the file tells directions.", "thesis 2.1, corrected"),
          texts_key("columns", &Directions::columns,
                    "Columns of the angles or components; not given: theta, phi or p1, p2, p3.",
                    optional(R"(["theta", "phi"])")),
          key("angle_unit", &Directions::angle_unit, units, "Unit of the angles in the file."),
          text_key("weight_column", &Directions::weight_column, "column",
                   "Column that tells what each fiber counts, its length, say; not given: all alike.",
                   optional("\"length\"")),
          vector_key("cut_normal", &Directions::cut_normal, KeyTable::Cubic::no,
                     {.text = "Normal of the plane cut on which the fibers were found, for ellipses on a "
                              "polished section: a cut meets fibers in proportion to |p·n|, so each "
                              "counts 1/|p·n|. Not given: nothing is corrected.",
                      .example = "[0, 0, 1]",
                      .source = "Bay, Tucker 1992"}),
          key("aspect_ratio", &Directions::aspect_ratio, {}, Range::at_least(1),
              "Length over diameter of the fibers on the cut; it bounds the weight of fibers that lie in "
              "the plane.",
              optional("20"), "Bay, Tucker 1992"),
      }};
}

KeyGroup<StatisticsChoices> statistics_keys() {
  using Statistics = StatisticsChoices;
  return {"statistics",
          "Percentile-bootstrap intervals.",
          {
              key("level", &Statistics::level, {}, Range::inside(0, 1), "Confidence of the intervals."),
              key("resamples", &Statistics::resamples, {}, Range::between(10, 1e6), "Bootstrap samples.", {},
                  "Efron 1979"),
              key("seed", &Statistics::seed, {}, Range::between(0, 4294967295.0), "Seed of the samples."),
          }};
}

}  // namespace

void describe_measurement(KeyTable& table, MeasurementCase& values) {
  describe(table, length_keys(), values.lengths);
  describe(table, direction_keys(), values.orientation);
  describe(table, statistics_keys(), values.statistics);
}

}  // namespace fiberfate
