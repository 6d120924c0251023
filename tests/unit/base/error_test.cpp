// Tests how problems read and which word a misspelt one means.
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace fiberfate {
namespace {

TEST(InputProblem, LeavesOutWhatIsUnknown) {
  const InputProblem whole{"case.toml", 3, 7, "flow.rate", "\"1 m\"", "is no rate", "give 1/s"};
  EXPECT_EQ(whole.message(), "case.toml:3:7: flow.rate = \"1 m\": is no rate: give 1/s");
  const InputProblem bare{"", 0, 0, "", "", "nothing to do", "give a case"};
  EXPECT_EQ(bare.message(), "nothing to do: give a case");
  const InputProblem no_value{"case.toml", 3, 0, "flow.rate", "", "is missing", ""};
  EXPECT_EQ(no_value.message(), "case.toml:3: flow.rate: is missing");
}

TEST(InputError, ReportsAllProblemsAtOnce) {
  const InputError error({{"a", 1, 1, "k", "v", "one", "do"}, {"a", 2, 1, "l", "w", "two", "do"}});
  EXPECT_STREQ(error.what(), "a:1:1: k = v: one: do\na:2:1: l = w: two: do");
  EXPECT_EQ(error.problems().size(), 2U);
}

TEST(SimulationFailure, NamesFiberStepTimeAndForce) {
  const SimulationFailure failure("no step is small enough", {42, 0.5, 7, 1e-3});
  EXPECT_STREQ(failure.what(),
               "no step is small enough (fiber 7, step 42, time 0.5 s, largest force 0.001 N)");
  EXPECT_EQ(failure.place().fiber, 7);
}

TEST(NearestWord, FindsWhatWasMeant) {
  const std::vector<std::string> keys = {"rate", "viscosity", "duration"};
  EXPECT_EQ(nearest_word("viscocity", keys), "viscosity");
  EXPECT_EQ(nearest_word("duratoin", keys), "duration");
  EXPECT_EQ(nearest_word("temperature", keys), "");
}

}  // namespace
}  // namespace fiberfate
