// Checks how values of a sweep are read and combined, and how its table is written.
#include "app/sweep.hpp"

#include <gtest/gtest.h>

#include "app/sweep_table.hpp"
#include "base/error.hpp"

namespace fiberfate {
namespace {

using Texts = std::vector<std::string>;

std::string refusal(const Texts& given) {
  try {
    std::vector<SweptKey> keys;
    for (const std::string& text : given) keys.push_back(read_swept_key(text));
    static_cast<void>(sweep_runs(keys));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Sweep, CommasInBracketsAndQuotesPartNothing) {
  EXPECT_EQ(read_swept_key("flow.rate=1 1/s, 10 1/s").values, (Texts{"1 1/s", "10 1/s"}));
  EXPECT_EQ(read_swept_key("a.b=isotropic,[0.6, 0.3, 0.1],[[1, 0], [0, 1]]").values,
            (Texts{"isotropic", "[0.6, 0.3, 0.1]", "[[1, 0], [0, 1]]"}));
  EXPECT_EQ(read_swept_key("a.b=\"x,y\",'z'").values, (Texts{"\"x,y\"", "'z'"}));
}

TEST(Sweep, CombinesValuesInOrderTheLastKeyFastest) {
  const std::vector<SweepRun> runs =
      sweep_runs({{"diffusion.C_I", {"0.01", "0.1"}}, {"flow.rate", {"1 1/s", "10 1/s", "100 1/s"}}});
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[1].changes, (Texts{"diffusion.C_I=0.01", "flow.rate=10 1/s"}));
  EXPECT_EQ(runs[1].folder, "2_C_I=0.01_rate=10_1_s");
  EXPECT_EQ(runs[3].values, (Texts{"0.1", "1 1/s"}));
}

TEST(Sweep, FoldersSortAsTheRunsDoAndAreNeverTheSame) {
  SweptKey key{"a.b", {}};
  for (int i = 0; i < 10; ++i) key.values.push_back(i % 2 == 0 ? "1 m" : "1/m");
  const std::vector<SweepRun> runs = sweep_runs({key});
  EXPECT_EQ(runs[0].folder, "01_b=1_m");
  EXPECT_EQ(runs[1].folder, "02_b=1_m");
  EXPECT_EQ(runs[9].folder, "10_b=1_m");
}

TEST(Sweep, RefusesWhatIsNoListOfValues) {
  EXPECT_EQ(
      refusal({"flow.rate"}),
      "command line: --sweep = flow.rate: this is not a key with values: write --sweep key=value,value, for "
      "example --sweep diffusion.C_I=0.001,0.01");
  EXPECT_EQ(
      refusal({"flow.rate=1,,2"}),
      "command line: --sweep = flow.rate=1,,2: a value is missing: write the values with one comma between "
      "them");
  EXPECT_EQ(refusal({"a=1", "b=2", "a=3"}),
            "command line: --sweep = a: the key is given twice: give all of its values at once");
  std::string many = "a=0";
  for (int i = 1; i < 101; ++i) many += ",0";
  EXPECT_EQ(refusal({many, "b" + many}),
            "command line: --sweep = ba: the values combine to 10201 runs: give at most 10000");
}

TEST(SweepTable, HasAColumnForEveryValueOfAnyRun) {
  SweepTable table({"run", "law.name"});
  table.add({"1_name=a", "a"},
            {{"L_N_m", 0.5}, {"law", std::string("a, \"b\"")}, {"list", std::vector<double>{1, 2}}});
  Mat3 tensor = Mat3::Identity();
  tensor(0, 1) = 0.25;
  table.add({"2_name=b", "b"}, {{"steps", std::int64_t{7}}, {"A2", tensor}});
  EXPECT_EQ(table.text(),
            "run,law.name,L_N_m,law,steps,A2_11,A2_12,A2_13,A2_21,A2_22,A2_23,A2_31,A2_32,A2_33\n"
            "1_name=a,a,0.5,\"a, \"\"b\"\"\",,,,,,,,,,\n"
            "2_name=b,b,,,7,1,0.25,0,0,1,0,0,0,1\n");
}

}  // namespace
}  // namespace fiberfate
