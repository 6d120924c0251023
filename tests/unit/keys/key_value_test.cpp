// Tests how single values of case files are read, bounded and written.
#include "keys/key_value.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "keys/orientation_value.hpp"
#include "keys/rows_value.hpp"

namespace fiberfate {
namespace {

const Units micrometres{"m", "um"};

TomlValue value_of(const std::string& toml) {
  return TomlDocument::parse("value = " + toml, "a.toml").find("value")->value;
}

std::string complaint_about(const std::string& toml, const Units& units, const Range& range) {
  const Reading<double> reading = read_quantity(value_of(toml), units, range);
  if (!std::holds_alternative<Complaint>(reading)) return "none";
  return std::get<Complaint>(reading).what + ": " + std::get<Complaint>(reading).remedy;
}

TEST(Quantity, IsReadWithUnitsToTheSameBitsAsInSI) {
  EXPECT_EQ(std::get<double>(read_quantity(value_of("\"19 um\""), micrometres, Range::any())), 19e-6);
  EXPECT_EQ(std::get<double>(read_quantity(value_of("1.9e-5"), micrometres, Range::any())), 19e-6);
  EXPECT_EQ(std::get<double>(read_quantity(value_of("\"204.6 um\""), micrometres, Range::any())), 204.6e-6);
  EXPECT_EQ(std::get<double>(read_quantity(value_of("2"), micrometres, Range::any())), 2.0);
}

TEST(Quantity, IsRefusedWithWhatToDo) {
  const Range diameter = Range::between(1e-7, 1e-3);
  EXPECT_EQ(complaint_about("19", micrometres, diameter),
            "out of range: give 100 nm to 1 mm (a number without unit is in m)");
  EXPECT_EQ(complaint_about("\"-19 um\"", micrometres, diameter), "out of range: give 100 nm to 1 mm");
  EXPECT_EQ(complaint_about("\"19 s\"", micrometres, diameter),
            "'s' does not have the dimension of 'm': give a number with a unit in quotes, such as \"1 um\"");
  EXPECT_EQ(complaint_about("\"19 furlongz\"", micrometres, diameter),
            "'furlongz' is not a unit: give a number with a unit in quotes, such as \"1 um\"");
  EXPECT_EQ(
      complaint_about("\"wide\"", micrometres, diameter),
      "'wide' does not begin with a finite number: give a number with a unit in quotes, such as \"1 um\"");
  EXPECT_EQ(complaint_about("[1]", micrometres, diameter),
            "a list is not a quantity: give a number with a unit in quotes, such as \"1 um\"");
  EXPECT_EQ(complaint_about("nan", {}, Range::any()), "not a finite number: give a number");
  EXPECT_EQ(complaint_about("1e999", {}, Range::any()), "not a finite number: give a number");
}

TEST(Range, KnowsItsEnds) {
  EXPECT_FALSE(Range::positive().contains(0));
  EXPECT_TRUE(Range::not_negative().contains(0));
  EXPECT_FALSE(Range::inside(0, 1).contains(1));
  EXPECT_TRUE(Range::between(0, 1).contains(1));
  EXPECT_FALSE(Range::any().contains(NAN));
  EXPECT_EQ(describe_range(Range::positive(), micrometres), "more than 0");
  EXPECT_EQ(describe_range(Range::positive(1), micrometres), "more than 0 and at most 1 m");
  EXPECT_EQ(describe_range({0, 0.907, Range::Ends::open_low}, {"1", "%"}), "more than 0 and at most 90.7 %");
  EXPECT_EQ(describe_range(Range::between(1e6, 2e12), {"Pa", "GPa"}), "1 MPa to 2000 GPa");
}

TEST(Quantity, IsWrittenForPeopleAndForTheRecord) {
  EXPECT_EQ(write_quantity(19e-6, micrometres, NumberStyle::friendly), "\"19 um\"");
  EXPECT_EQ(write_quantity(19e-6, micrometres, NumberStyle::si), "1.9e-05");
  EXPECT_EQ(write_quantity(1e-5, {"s", ""}, NumberStyle::friendly), "\"10 us\"");
  EXPECT_EQ(write_quantity(0.2, {}, NumberStyle::friendly), "0.2");
  EXPECT_EQ(write_quantity(5, {}, NumberStyle::si), "5.0");
  for (const double value : {0.1 + 0.2, 1.0 / 3, 73e9, 1e-300, 1e300, 123456789.123456789}) {
    const auto again =
        read_quantity(value_of(write_quantity(value, micrometres, NumberStyle::si)), micrometres, {});
    EXPECT_EQ(std::get<double>(again), value);
  }
}

TEST(Text, SurvivesQuotesAndControlLetters) {
  const std::string text = "a \"quoted\" \\ path\n\tnext \x7f";
  EXPECT_EQ(std::get<std::string>(value_of(write_text(text)).data), text);
}

Mat3 orientation_of(const std::string& toml) {
  return std::get<Mat3>(read_orientation(value_of(toml)));
}

std::string orientation_complaint(const std::string& toml) {
  const Reading<Mat3> reading = read_orientation(value_of(toml));
  if (!std::holds_alternative<Complaint>(reading)) return "none";
  return std::get<Complaint>(reading).what;
}

TEST(Orientation, IsReadInEveryForm) {
  EXPECT_EQ(orientation_of("\"isotropic\""), Mat3(Mat3::Identity() / 3));
  EXPECT_EQ(orientation_of("\"aligned\"")(0, 0), 1);
  EXPECT_EQ(orientation_of("[0.6, 0.3, 0.1]"), Mat3(Vec3(0.6, 0.3, 0.1).asDiagonal()));
  // The tensor of thesis figure 3.7, rounded to five digits.
  const Mat3 thesis = orientation_of(
      "[[0.34444, -0.17778, 0.15556], [-0.17778, 0.41112, -0.02222], [0.15556, -0.02222, 0.24444]]");
  EXPECT_EQ(thesis(0, 1), -0.17778);
  EXPECT_NEAR(orientation_of("[0.333, 0.333, 0.333]").trace(), 1, 1e-15);
}

TEST(Orientation, IsRefusedWhenNoFibersCouldHaveIt) {
  EXPECT_EQ(orientation_complaint("[0.6, 0.3, 0.2]"), "the trace of the orientation tensor is 1.1, not 1");
  EXPECT_EQ(orientation_complaint("[1.2, -0.1, -0.1]"),
            "the orientation tensor has the eigenvalue -0.1, and no fibers have a negative one");
  EXPECT_EQ(orientation_complaint("[[0.4, 0.1, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3]]"),
            "the tensor is not symmetric");
  EXPECT_EQ(orientation_complaint("[0.5, 0.5]"), "not an orientation tensor");
  EXPECT_EQ(orientation_complaint("\"isotropc\""), "not an orientation");
  EXPECT_EQ(orientation_complaint("[nan, 0.5, 0.5]"), "not an orientation tensor");
}

TEST(Orientation, IsWrittenToTheSameBits) {
  for (const char* text :
       {"\"isotropic\"", "[0.6, 0.3, 0.1]", "[[0.5, 0.1, 0.0], [0.1, 0.3, 0.0], [0.0, 0.0, 0.2]]"}) {
    const Mat3 tensor = orientation_of(text);
    EXPECT_EQ(orientation_of(write_orientation(tensor, NumberStyle::si)), tensor);
    EXPECT_EQ(orientation_of(write_orientation(tensor, NumberStyle::friendly)), tensor);
  }
  EXPECT_EQ(write_orientation(Mat3::Identity() / 3, NumberStyle::friendly), "\"isotropic\"");
}

TEST(Rows, AreReadAndComplainAboutTheirCells) {
  const std::vector<Column> columns = {{"time", {"s", ""}, Range::positive()},
                                       {"rate", {"1/s", ""}, Range::any()}};
  std::vector<std::vector<double>> rows;
  EXPECT_TRUE(read_rows(value_of("[[\"1 min\", 2.0], [90, \"3 1/s\"]]"), columns, ".", rows).empty());
  EXPECT_EQ(rows, (std::vector<std::vector<double>>{{60, 2}, {90, 3}}));
  const auto before = rows;
  const TomlValue bad = value_of("[[\"1 m\", 2], [-1, 3], [1, 2, 3]]");
  const auto complaints = read_rows(bad, columns, ".", rows);
  ASSERT_EQ(complaints.size(), 3u);
  EXPECT_EQ(complaints[0].what, "time: 'm' does not have the dimension of 's'");
  EXPECT_EQ(complaints[1].at->written, "-1");
  EXPECT_EQ(complaints[2].what, "not a row of 2 quantities");
  EXPECT_EQ(rows, before);
}

}  // namespace
}  // namespace fiberfate
