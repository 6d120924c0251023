// Tests the list of attrition laws and the following of populations.
#include "continuum/length_registry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {
namespace {

const LengthClasses population = {{0.5e-3, 2e-3, 6e-3, 12e-3}, {100, 50, 20, 5}};

std::vector<double> plausible_values(const AttritionLawEntry& entry) {
  std::vector<double> values;
  for (const LawParameter& parameter : entry.parameters) {
    const double known = parameter.standard_value;
    double value = std::isnan(known) ? 0.3 : known;
    if (parameter.name == "k_0") value = 1e4;
    if (parameter.name == "L_inf") value = 1e-3;
    if (parameter.name == "zeta") value = 3;
    if (parameter.name == "xi") value = 1e-3;
    values.push_back(value);
  }
  return values;
}

TEST(AttritionLaws, HaveUniqueNamesAndDocumentedParameters) {
  std::set<std::string> names;
  for (const AttritionLawEntry& entry : attrition_laws()) {
    EXPECT_TRUE(names.insert(entry.name).second);
    EXPECT_FALSE(entry.summary.empty());
    std::set<std::string> parameters;
    for (const LawParameter& parameter : entry.parameters) {
      EXPECT_TRUE(parameters.insert(parameter.name).second);
      EXPECT_FALSE(parameter.meaning.empty());
      EXPECT_LT(parameter.lower, parameter.upper);
    }
  }
}

TEST(AttritionLaws, ShortenEveryPopulationAndKeepItsLength) {
  for (const AttritionLawEntry& entry : attrition_laws()) {
    const auto law = make_attrition_law(entry.name, plausible_values(entry));
    const auto evolution =
        law->start({population, {}, LengthForm::distribution, ClassWeight::length, {120, 0}});
    const double length = total_length(evolution->population());
    EXPECT_NEAR(length / total_length(population), 1, 1e-14) << entry.name;
    MeanLengths before = evolution->means();
    for (int i = 0; i < 50; ++i) {
      evolution->advance({80, 250}, 1);
      const MeanLengths now = evolution->means();
      EXPECT_LE(now.number_average, before.number_average * (1 + 1e-15)) << entry.name;
      EXPECT_LE(now.weight_average, before.weight_average * (1 + 1e-15)) << entry.name;
      before = now;
    }
    EXPECT_LT(before.weight_average, mean_lengths(population).weight_average) << entry.name;
    EXPECT_NEAR(total_length(evolution->population()) / length, 1, 1e-12) << entry.name;
  }
}

TEST(AttritionLaws, FollowMeansOneByOne) {
  const auto law = make_attrition_law("constant", std::vector<double>{0.1, 1e-3});
  const auto evolution = law->start({population, {}, LengthForm::means, ClassWeight::length, {}});
  const MeanLengths start = mean_lengths(population);
  evolution->advance({1, 1}, 7);
  EXPECT_NEAR(evolution->means().number_average, 1e-3 + (start.number_average - 1e-3) * std::exp(-0.7),
              1e-17);
  EXPECT_NEAR(evolution->means().weight_average, 1e-3 + (start.weight_average - 1e-3) * std::exp(-0.7),
              1e-17);
  const auto phelps = make_attrition_law("phelps", std::vector<double>{0.02, 3, 0.25, 73e9, 19e-6, 0});
  EXPECT_THROW((void)phelps->start({population, {}, LengthForm::means, ClassWeight::length, {}}), InputError);
}

TEST(AttritionLaws, WeighClassesByLengthOrByNumber) {
  const auto law = make_attrition_law("constant", std::vector<double>{0.1, 1e-3});
  const auto kept = law->start({population, {}, LengthForm::distribution, ClassWeight::number, {}});
  kept->advance({1, 1}, 7);
  EXPECT_EQ(kept->population().numbers, population.numbers);
  EXPECT_EQ(kept->population().lengths[0], 0.5e-3);
  EXPECT_NEAR(kept->population().lengths[3], 1e-3 + 11e-3 * std::exp(-0.7), 1e-17);
  const auto conserved = law->start({population, {}, LengthForm::distribution, ClassWeight::length, {}});
  conserved->advance({1, 1}, 7);
  EXPECT_NEAR(conserved->population().numbers[3] * conserved->population().lengths[3], 5 * 12e-3, 1e-16);
}

TEST(AttritionLaws, SaySoWhenTheyAreMisnamedOrMissAValue) {
  try {
    (void)find_attrition_law("stres_induced");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "there is no attrition law 'stres_induced': did you mean 'stress_induced'?");
  }
  EXPECT_THROW((void)make_attrition_law("constant", std::vector<double>{0.1}), InputError);
  EXPECT_THROW((void)make_attrition_law("constant", std::vector<double>{0.1, std::nan("")}), InputError);
  EXPECT_THROW((void)make_attrition_law("constant", std::vector<double>{-0.1, 1e-3}), InputError);
}

TEST(LengthClassesTest, CountAndAverage) {
  const MeanLengths means = mean_lengths(population);
  EXPECT_NEAR(means.number_average, (50 + 100 + 120 + 60) * 1e-3 / 175, 1e-17);
  EXPECT_NEAR(means.weight_average, (25 + 200 + 720 + 720) * 1e-3 / 330, 1e-17);
  const std::vector<double> edges = {0, 2e-3, 6e-3, 12e-3};
  EXPECT_EQ(histogram(population, edges), (std::vector<double>{100, 50, 25}));
  EXPECT_THROW(LengthClasses({{1, 2}, {1}}).check(), InputError);
  EXPECT_THROW(LengthClasses({{1, 0}, {1, 1}}).check(), InputError);
  EXPECT_THROW(LengthClasses({{1, 2}, {0, 0}}).check(), InputError);
}

}  // namespace
}  // namespace fiberfate
