// Tests that TOML is read with places, and that slips are answered with what to do.
#include "io/toml_document.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/timer.hpp"

namespace fiberfate {
namespace {

std::string message_of(const std::string& text) {
  try {
    static_cast<void>(TomlDocument::parse(text, "a.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TomlDocument, FlattensKeysInTheirOrderWithPlaces) {
  const TomlDocument document =
      TomlDocument::parse("study = \"x\"\n[fibers]\n  length = \"2 mm\"  # why\ncount=3\n", "a.toml");
  ASSERT_EQ(document.entries().size(), 3u);
  EXPECT_EQ(document.entries()[0].key, "study");
  const TomlEntry& length = document.entries()[1];
  EXPECT_EQ(length.key, "fibers.length");
  EXPECT_EQ(length.place.line, 3);
  EXPECT_EQ(length.place.column, 3);
  EXPECT_EQ(length.value.place.column, 12);
  EXPECT_EQ(length.value.written, "\"2 mm\"");
  EXPECT_EQ(std::get<std::string>(length.value.data), "2 mm");
  EXPECT_EQ(std::get<std::int64_t>(document.find("fibers.count")->value.data), 3);
  ASSERT_EQ(document.tables().size(), 1u);
  EXPECT_EQ(document.tables()[0].name, "fibers");
  EXPECT_EQ(document.tables()[0].place.line, 2);
  EXPECT_EQ(document.find("fibers.diameter"), nullptr);
}

TEST(TomlDocument, CitesListsOfManyLinesInOne) {
  const TomlDocument document = TomlDocument::parse("table = [\n  [1, 2],\n  [3, 4],\n]\n", "a.toml");
  const TomlValue& table = document.find("table")->value;
  EXPECT_EQ(table.written, "[ [1, 2], [3, 4], ]");
  const auto& rows = std::get<std::vector<TomlValue>>(table.data);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].place.line, 3);
  EXPECT_STREQ(table.kind(), "a list");
}

TEST(TomlDocument, ReadsWindowsLinesAndAnEmptyFile) {
  EXPECT_EQ(TomlDocument::parse("a = 1\r\nb = 2\r\n", "a.toml").entries().size(), 2u);
  EXPECT_TRUE(TomlDocument::parse("", "a.toml").entries().empty());
}

TEST(TomlDocument, DoesNotClampNumbersThatAreTooLarge) {
  const TomlDocument document = TomlDocument::parse("a = 1e999\nb = -99999999999999999999\n", "a.toml");
  EXPECT_EQ(std::get<double>(document.find("a")->value.data), INFINITY);
  EXPECT_EQ(std::get<double>(document.find("b")->value.data), -INFINITY);
}

TEST(TomlDocument, OverridesReplaceAndNeedNoSecondQuotes) {
  TomlDocument document = TomlDocument::parse("[fibers]\nlength = \"2 mm\"\n", "a.toml");
  document.override_with("fibers.length = 3 mm");
  document.override_with("fibers.count=7");
  document.override_with("cell.size=[1.0, 2.0, 3.0]");
  document.override_with("flow.kind=ramp");
  document.override_with("fibers.count=8");
  EXPECT_EQ(std::get<std::string>(document.find("fibers.length")->value.data), "3 mm");
  EXPECT_EQ(document.find("fibers.length")->value.place.file, "command line");
  EXPECT_EQ(std::get<std::int64_t>(document.find("fibers.count")->value.data), 8);
  EXPECT_EQ(std::get<std::vector<TomlValue>>(document.find("cell.size")->value.data).size(), 3u);
  EXPECT_EQ(std::get<std::string>(document.find("flow.kind")->value.data), "ramp");
  EXPECT_EQ(document.entries().size(), 4u);
  EXPECT_THROW(document.override_with("fibers.length"), InputError);
  EXPECT_THROW(document.override_with("= 3"), InputError);
}

TEST(TomlSyntax, AnswersSlipsWithWhatToDo) {
  EXPECT_EQ(message_of("[fibers]\nlength = 19 um # long\n"),
            "a.toml:2:10: length = 19 um: the value is not in quotes: write length = \"19 um\"");
  EXPECT_EQ(message_of("rate = 16.65 1/s\n"),
            "a.toml:1:8: rate = 16.65 1/s: the value is not in quotes: write rate = \"16.65 1/s\"");
  EXPECT_EQ(message_of("kind = ramp"),
            "a.toml:1:8: kind = ramp: the value is not in quotes: write kind = \"ramp\"");
  EXPECT_EQ(message_of("a = 1,5"), "a.toml:1:5: a = 1,5: a number has a decimal comma: write a = 1.5");
  EXPECT_EQ(message_of("a = 1,5 mm"),
            "a.toml:1:5: a = 1,5 mm: a number has a decimal comma: write a = \"1.5 mm\"");
  EXPECT_EQ(message_of("a ="), "a.toml:1:4: a: has no value: write one behind '=', or put # before the line");
  EXPECT_EQ(message_of("a = 1\na = 2\n"),
            "a.toml:2:5: a is given twice, first in line 1: keep one of the two");
  EXPECT_EQ(message_of("[b]\nx = 1\n[b]\n"),
            "a.toml:3:1: [b] is given twice, first in line 1: put all its keys under one heading");
  EXPECT_EQ(message_of("a = \"abc\n"),
            "a.toml:1:5: a text does not end, or holds an unknown escape: close it with \" in the same line, "
            "and write "
            "\\\\ for a backslash");
  EXPECT_EQ(
      message_of("x = 1\na = [1, 2\nb = 3\n"),
      "a.toml:2:5: a list does not end, or lacks a comma: separate its values by commas and close it with ]");
  EXPECT_EQ(message_of("a"), "a.toml:1:2: a line has no '=': write key = value");
  EXPECT_EQ(message_of("a = \"\xff\""),
            "a.toml:1:6: the file holds bytes that are not UTF-8: save it as UTF-8 text");
  EXPECT_EQ(message_of("a = .5"),
            "a.toml:1:5: a number is incomplete: write digits on both sides of the point, 0.5 or 5.0");
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(TomlDocument, BoundsNestingBeforeTheLibrarySeesIt) {
  EXPECT_EQ(
      message_of("a = " + repeated("[", 6000)),
      "a.toml:1:69: lists or tables are nested more than 64 deep: this is no case file; a bracket may be "
      "missing");
  EXPECT_NE(message_of("a = " + repeated("{a=", 10000) + "1" + repeated("}", 10000)).find("nested more than"),
            std::string::npos);
  EXPECT_NE(message_of("[a" + repeated(".a", 20000) + "]\n").find("a key has more than 64 parts"),
            std::string::npos);
  EXPECT_NE(message_of("a" + repeated(".a", 20000) + " = 1\n").find("a key has more than 64 parts"),
            std::string::npos);
  EXPECT_EQ(message_of("a = " + repeated("[", 60) + repeated("]", 60)), "no error");
  EXPECT_EQ(message_of("a = '" + repeated("[.", 100) + "'\nb = \"\"\"" + repeated("\\\"[\n.", 100) +
                       "\"\"\" # " + repeated("[.", 100)),
            "no error");
}

TEST(TomlDocument, ReadsFaultyLinesOfAnyLength) {
  const std::string long_value = repeated("x", 1 << 20);
  EXPECT_NE(message_of("key = " + long_value).find("the value is not in quotes"), std::string::npos);
  EXPECT_NE(message_of("key = \"" + long_value).find("a text does not end"), std::string::npos);
  EXPECT_NE(message_of(long_value).find("a line has no '='"), std::string::npos);
  EXPECT_LT(message_of("key = " + long_value).size(), 300u);
}

TEST(TomlDocument, ReadsLongListsInLinearTime) {
  const double begin = cpu_seconds();
  const TomlDocument document = TomlDocument::parse("a = [" + repeated("1.5, ", 200000) + "2]", "a.toml");
  const auto& items = std::get<std::vector<TomlValue>>(document.entries()[0].value.data);
  EXPECT_EQ(items.size(), 200001u);
  EXPECT_EQ(items.back().place.column, 6 + 5 * 200000);
  EXPECT_LT(cpu_seconds() - begin, 20);  // it took minutes when each value looked through the line
  EXPECT_EQ(
      message_of("a = [" + repeated("1.5,", 9999) + "1 5]\n"),
      "a.toml:1:5: a list does not end, or lacks a comma: separate its values by commas and close it with ]");
  EXPECT_NE(message_of("a = [" + repeated("{b=1},", 20000) + "]").find("no error"), std::string::npos);
  EXPECT_NE(message_of("a = {" + repeated("b=1,", 20000) + "}").find("a table in braces is longer than"),
            std::string::npos);
}

TEST(TomlDocument, SaysWhereATextHoldsWhatIsNoText) {
  using namespace std::string_literals;
  EXPECT_EQ(
      message_of("a = 1\nb\0 = 2\n"s),
      "a.toml:2:2: is not a text file: it holds a zero byte: give a text; one in UTF-16 must be saved as "
      "UTF-8 first");
  EXPECT_EQ(message_of("a = 1\rb = 2\n").substr(0, 11), "a.toml:1:6:");
  EXPECT_EQ(message_of("a = 1\nb = \x1b[0m\n").substr(0, 11), "a.toml:2:5:");
  EXPECT_EQ(message_of("a = \"\xC3\"\n").substr(0, 11), "a.toml:1:6:");
  EXPECT_EQ(message_of("\xEF\xBB\xBF"
                       "a = \"µm\"\r\n"),
            "no error");
}

TEST(TomlDocument, RefusesMissingFiles) {
  EXPECT_THROW(static_cast<void>(TomlDocument::read("/nonexistent/case.toml")), InputError);
}

}  // namespace
}  // namespace fiberfate
