// Tests tables as instruments and spreadsheets write them.
#include "io/delimited_table.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

using Numbers = std::vector<double>;

DelimitedTable table_of(const std::string& text) {
  const ScratchFolder folder;
  replace_file(folder / "l.csv", text);
  return DelimitedTable(folder / "l.csv");
}

/// Gives what is said, from the line on, when a column is read.
std::string refusal(const std::string& text, const std::string& column) {
  try {
    const DelimitedTable table = table_of(text);
    static_cast<void>(table.numbers(table.column_named(column)));
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find("l.csv:") + 6);
  }
  return "read";
}

TEST(DelimitedTable, ReadsSemicolonsAndDecimalCommas) {
  const DelimitedTable table =
      table_of("Nr.;Länge [mm];Durchmesser\n1;0,512;0,017\n2;1,204;0,017\n\n3;0;0,018\n4;0,087;0,018\n");
  EXPECT_EQ(table.numbers(table.column_named("Länge [mm]")), (Numbers{0.512, 1.204, 0, 0.087}));
  EXPECT_EQ(table.column_named("Länge"), 1u);
  EXPECT_EQ(table.empty_lines(), 1u);
  EXPECT_EQ(table.line_of(3), 6);
}

TEST(DelimitedTable, ReadsTabsBlanksQuotesAndAllLineEnds) {
  const DelimitedTable tabs = table_of("\xEF\xBB\xBFlabel\tL\r\na b\t1,5\r\nc\t0.5e1\r\n");
  EXPECT_EQ(refusal("a\tL\nx\t1,5\ny\t0.5\n", "L").substr(0, 4), "3:3:");
  EXPECT_EQ(tabs.headings(), (std::vector<std::string>{"label", "L"}));
  EXPECT_EQ(tabs.rows(), 2u);
  EXPECT_EQ(table_of("1 2\n3   4\n").numbers(1), (Numbers{2, 4}));
  EXPECT_EQ(table_of("a,b\r1,2\r3,4\r").numbers(1), (Numbers{2, 4}));
  const DelimitedTable quoted = table_of("\"Length, mm\",\"n\"\n\"1.5\",2\n");
  EXPECT_EQ(quoted.headings()[0], "Length, mm");
  EXPECT_EQ(quoted.numbers(0), (Numbers{1.5}));
  EXPECT_EQ(table_of("sep=;\na;b\n1;2\n").numbers(1), (Numbers{2}));
  EXPECT_EQ(table_of("a;b;\n1;2;\n").numbers(1), (Numbers{2}));
  EXPECT_EQ(table_of("L\xE4nge;b\n1;2\n").headings()[0], "Länge");  // Latin-1
  EXPECT_EQ(table_of("# made by hand\n1.5\n2\n").headings(), (std::vector<std::string>{"1"}));
}

TEST(DelimitedTable, ReadsOnlyTheColumnsThatAreAskedFor) {
  const DelimitedTable table = table_of("file,L\nfiber_1.tif,1\nfiber 2.tif,2\n");
  EXPECT_EQ(table.numbers(table.column_named("L")), (Numbers{1, 2}));
  EXPECT_NE(refusal("file,L\nfiber_1.tif,1\n", "file").find("'fiber_1.tif' is not a finite number"),
            std::string::npos);
}

TEST(DelimitedTable, NeverTakesPartOfANumber) {
  for (const char* text : {"L, mm\n1,204\n3,512\n2,087\n", "L,mm\n1,5\n2,25\n", "L,n\n1,05\n2,7\n",
                           "1,05\n2,70\n", "L\n1,5\n", "L,x\n\"1,5\",2\n"})
    EXPECT_NE(refusal(text, "L").find("decimal comma"), std::string::npos) << text;
  EXPECT_EQ(table_of("length,count\n1,3\n4,1\n").numbers(0), (Numbers{1, 4}));
  EXPECT_NE(refusal("a\tL\nx\t1,204\ny\t3,512\n", "L").find("decimal comma or be in thousands"),
            std::string::npos);
  EXPECT_EQ(table_of("a\tL\nx\t1,204\ny\t0,512\n").numbers(1), (Numbers{1.204, 0.512}));
  EXPECT_NE(refusal("a;L\nx;1.204,5\n", "L").find("is not a finite number"), std::string::npos);
}

TEST(DelimitedTable, SaysWhereItIsWrong) {
  EXPECT_EQ(refusal("a,L\n1,2\n3\n", "L").substr(0, 43), "3:1: 1 values for 2 columns: give one value");
  EXPECT_EQ(refusal("a,L\n1,two\n", "L").substr(0, 33), "2:3: 'two' is not a finite number");
  EXPECT_EQ(refusal("a,L\n1,\n", "L").substr(0, 24), "2:3: a number is missing");
  EXPECT_EQ(refusal("a,L\n1,nan\n", "L").substr(0, 5), "2:3: ");
  EXPECT_EQ(refusal("a,L\n\"1,2\n", "L").substr(0, 37), "2:1: a quote does not end in its line");
  EXPECT_EQ(
      refusal(" ,Area,Length\n1,2,3\n", "Lenght"),
      "1:1: there is no column 'Lenght': did you mean 'Length'? its columns are column 1 without a name, "
      "'Area', 'Length'");
  EXPECT_NE(refusal("L,L\n1,2\n", "L").find("there are several columns 'L'"), std::string::npos);
  EXPECT_EQ(refusal(std::string("a,L\n1,\0\n", 8), "L").substr(0, 5), "2:3: ");
  EXPECT_NE(refusal("a,L\n", "x").find("there is no column"), std::string::npos);
}

}  // namespace
}  // namespace fiberfate
