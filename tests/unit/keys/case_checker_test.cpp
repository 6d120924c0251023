// Tests which faults of a case are kept, and where they are placed.
#include "keys/case_checker.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fiberfate {
namespace {

const char* const text = "[fibers]\nlength = 1\nrows = [\n  [1, 2],\n  [3, 4],\n]\n";

std::vector<std::string> messages(const CaseChecker& checker) {
  std::vector<std::string> all;
  for (const InputProblem& problem : checker.errors()) all.push_back(problem.message());
  return all;
}

TEST(CaseChecker, KeepsEveryFaultOfAKey) {
  const TomlDocument document = TomlDocument::parse(text, "a.toml");
  CaseChecker checker(document, {}, NamedFiles::must_exist);
  checker.error("fibers.length", "is short", "make it long");
  checker.error("fibers.length", "is thin", "make it thick");
  checker.error("fibers.length", "is short", "make it long");
  checker.error_in_row("fibers.rows", 0, "is odd", "");
  checker.error_in_row("fibers.rows", 1, "is odd", "");
  EXPECT_EQ(messages(checker),
            (std::vector<std::string>{"a.toml:2:10: fibers.length = 1: is short: make it long",
                                      "a.toml:2:10: fibers.length = 1: is thin: make it thick",
                                      "a.toml:4:3: fibers.rows = [1, 2]: is odd",
                                      "a.toml:5:3: fibers.rows = [3, 4]: is odd"}));
}

TEST(CaseChecker, SaysNothingMoreOfWhatCouldNotBeRead) {
  const TomlDocument document = TomlDocument::parse(text, "a.toml");
  InputProblem unread = problem_at_key(document, "fibers.length");
  unread.complaint = "is not a length";
  CaseChecker checker(document, {unread}, NamedFiles::must_exist);
  checker.error("fibers.length", "is short", "");
  EXPECT_EQ(checker.errors().size(), 1U);
}

TEST(CaseChecker, LeavesAFaultOfADataFileInItsPlace) {
  const TomlDocument document = TomlDocument::parse(text, "a.toml");
  CaseChecker checker(document, {}, NamedFiles::must_exist);
  EXPECT_FALSE(checker.report_at("fibers.rows", [] {
    throw InputError({{"data.csv", 7, 3, "", "x", "'x' is not a number", "write numbers"},
                      {"data.csv", 9, 1, "", "", "has too few columns", ""}});
  }));
  EXPECT_EQ(messages(checker),
            (std::vector<std::string>{"data.csv:7:3: fibers.rows = x: 'x' is not a number: write numbers",
                                      "data.csv:9:1: fibers.rows: has too few columns"}));
  EXPECT_FALSE(checker.is_sound("fibers.rows"));
}

// What is found with other entries is told once, at the place from which these come.
TEST(CaseChecker, ChecksACaseWithOtherEntries) {
  const TomlDocument document = TomlDocument::parse(text, "a.toml");
  CaseChecker checker(document, {}, NamedFiles::must_exist);
  const TomlEntry& rows = *checker.find("fibers.rows");
  const TomlValue& second = std::get<std::vector<TomlValue>>(rows.value.data).back();
  for (int repeat = 0; repeat < 2; ++repeat) {
    checker.check_with({{"fibers.length", rows.place, second}, {"fibers.width", rows.place, second}},
                       [](CaseChecker& inside) {
                         EXPECT_TRUE(inside.is_given("fibers.width"));
                         inside.error("fibers.length", "is long", "");
                         inside.warn("fibers.width", "is odd", "");
                       });
  }
  EXPECT_EQ(messages(checker), (std::vector<std::string>{"a.toml:5:3: fibers.length = [3, 4]: is long"}));
  ASSERT_EQ(checker.warnings().size(), 1U);
  EXPECT_EQ(checker.warnings().front().message(), "a.toml:5:3: fibers.width = [3, 4]: is odd");
  EXPECT_FALSE(checker.is_given("fibers.width"));
}

}  // namespace
}  // namespace fiberfate
