// Tests concentrations, counts and cell sizes, and what is said about those that contradict each other.
#include "packing/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"

namespace fiberfate {
namespace {

FiberSpecies glass(double length) {
  FiberSpecies species;
  species.material = {9.5e-6, 73e9, 2550};
  species.length = SingleLength{length};
  species.rod_length = 1e-4;
  return species;
}

std::string refusal(const std::vector<FiberSpecies>& species, const ConcentrationRequest& request) {
  try {
    (void)plan_population(species, request, 1);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "accepted";
}

TEST(Population, ConvertsWeightAndVolumeFractions) {
  // The case of the thesis: 30 % by weight of glass (2550) in polypropylene (905) is 13.2 % by volume.
  const double volume = volume_from_weight_fraction(0.3, 2550, 905);
  EXPECT_NEAR(volume, 0.1320, 5e-5);
  EXPECT_NEAR(weight_from_volume_fraction(volume, 2550, 905), 0.3, 1e-14);
}

TEST(Population, CellAndFractionFixTheCount) {
  ConcentrationRequest request;
  request.weight_fraction = 0.3;
  request.matrix_density = 905;
  request.cell_size = Vec3::Constant(1.5e-3);
  const Population population = plan_population({glass(2.5e-3)}, request, 1);
  // 628.6 fibers; the thesis' case rounds down, ours goes to the nearest.
  EXPECT_EQ(population.fibers.size(), 629u);
  EXPECT_EQ(population.fibers[0].rods, 25);
  EXPECT_NEAR(population.volume_fraction, 629 * pi * 9.5e-6 * 9.5e-6 * 2.5e-3 / 3.375e-9, 1e-12);
}

TEST(Population, CountAndFractionFixTheCell) {
  ConcentrationRequest request;
  request.count = 138;
  request.volume_fraction = 0.0379;
  const Population population = plan_population({glass(0.25e-3)}, request, 1);
  EXPECT_EQ(population.fibers.size(), 138u);
  EXPECT_NEAR(population.volume_fraction, 0.0379, 1e-12);
  EXPECT_DOUBLE_EQ(population.cell_size[0], population.cell_size[2]);
}

TEST(Population, CountAndCellFixTheFraction) {
  ConcentrationRequest request;
  request.count = 1000;
  request.cell_size = Vec3::Constant(1.5e-3);
  EXPECT_NEAR(plan_population({glass(2.5e-3)}, request, 1).volume_fraction, 0.2100, 5e-5);
}

TEST(Population, SharesVolumeOutToSeveralKinds) {
  FiberSpecies carbon = glass(0.5e-3);
  carbon.material = {3.5e-6, 230e9, 1800};
  carbon.volume_share = 3;
  ConcentrationRequest request;
  request.volume_fraction = 0.1;
  request.cell_size = Vec3::Constant(1e-3);
  const Population population = plan_population({glass(1e-3), carbon}, request, 1);
  double volumes[2] = {0, 0};
  for (const FiberBlank& fiber : population.fibers) {
    const double radius = population.materials[fiber.material_id].radius;
    volumes[fiber.material_id] += pi * radius * radius * fiber.length;
  }
  // To half a fiber of each kind: 88 glass fibers make up their share.
  EXPECT_NEAR(volumes[1] / volumes[0], 3, 3 * 0.5 / 88);
  EXPECT_NEAR(population.volume_fraction, 0.1, 0.1 * 0.5 / 88);
}

TEST(Population, VolumeOfALengthDistributionIsExact) {
  FiberSpecies species = glass(1);
  species.length = LogNormalLengths{1e-3, 2e-3};
  ConcentrationRequest request;
  request.volume_fraction = 0.05;
  request.cell_size = Vec3::Constant(3e-3);
  const Population population = plan_population({species}, request, 3);
  double length = 0;
  for (const FiberBlank& fiber : population.fibers) length += fiber.length;
  const double asked = 0.05 * 27e-9 / (pi * 9.5e-6 * 9.5e-6);
  EXPECT_NEAR(length / asked, 1, 1e-12);
}

const LengthLaw laws[] = {SingleLength{1e-3},
                          LengthHistogram{{0, 0.5e-3, 1e-3, 2e-3}, {1, 3, 0.5}, HistogramHeight::fibers},
                          LengthHistogram{{0.2e-3, 1e-3, 2e-3}, {2, 1}, HistogramHeight::length},
                          ListedLengths{{0.4e-3, 0.7e-3, 1.6e-3}},
                          WeibullLengths{0.8e-3, 1.3e-3},
                          LogNormalLengths{0.8e-3, 1.3e-3}};

double volume_of(const Population& population) {
  double volume = 0;
  for (const FiberBlank& fiber : population.fibers)
    volume += pi * std::pow(population.materials[fiber.material_id].radius, 2) * fiber.length;
  return volume;
}

TEST(Population, MeanLengthsOfEveryLawAreWithinHalfAPercent) {
  for (const LengthLaw& law : laws) {
    FiberSpecies species = glass(1);
    species.length = law;
    ConcentrationRequest request;
    request.volume_fraction = 0.05;
    for (const std::int64_t count : {500, 1331}) {
      request.count = count;
      double first = 0, second = 0;
      for (const FiberBlank& fiber : plan_population({species}, request, 2).fibers) {
        first += fiber.length;
        second += fiber.length * fiber.length;
      }
      EXPECT_NEAR(first / static_cast<double>(count) / number_average(law), 1, 0.005) << law.index();
      EXPECT_NEAR(second / first / weight_average(law), 1, 0.005) << law.index();
    }
  }
}

// What a cell may be off by: nothing where lengths follow a law; a rod where they are picked from many; half
// a fiber where they are what they are.
double volume_tolerance(const LengthLaw& law, double longest) {
  if (law.index() == 0) return 0.5 * longest;
  if (law.index() != 2) return 1e-12;
  return std::get<ListedLengths>(law).lengths.size() > 100 ? 1e-4 : 0.5 * longest;
}

// A number that was asked for is kept, and the cell is made for it: exact. A cell that was asked for holds
// whole fibers, whose lengths give way as far as their law lets them.
TEST(Population, VolumeIsExactHoweverTheAmountIsGiven) {
  std::vector<LengthLaw> all(std::begin(laws), std::end(laws));
  ListedLengths measured;
  for (int i = 0; i < 300; ++i) measured.lengths.push_back(0.1e-3 + i * 5e-6);
  all.emplace_back(measured);
  for (const LengthLaw& law : all) {
    FiberSpecies species = glass(1);
    species.length = law;
    const double area = pi * 9.5e-6 * 9.5e-6;
    for (const bool by_weight : {false, true}) {
      ConcentrationRequest request;
      request.matrix_density = 905;
      if (by_weight)
        request.weight_fraction = 0.12;
      else
        request.volume_fraction = 0.05;
      const double fraction = by_weight ? volume_from_weight_fraction(0.12, 2550, 905) : 0.05;
      request.count = 700;
      const Population counted = plan_population({species}, request, 2);
      const double cell = counted.cell_size.prod();
      EXPECT_NEAR(volume_of(counted) / (fraction * cell), 1, 1e-12) << law.index();
      EXPECT_NEAR(counted.volume_fraction, fraction, 1e-12) << law.index();
      request.count.reset();
      request.cell_size = Vec3::Constant(3e-3);
      const Population filled = plan_population({species}, request, 2);
      double longest = 0;
      for (const FiberBlank& fiber : filled.fibers) longest = std::max(longest, fiber.length);
      EXPECT_NEAR(volume_of(filled) / area, fraction * 27e-9 / area, volume_tolerance(law, longest))
          << law.index();
      EXPECT_NEAR(filled.volume_fraction, volume_of(filled) / 27e-9, 1e-12) << law.index();
    }
  }
}

// Whatever the size of the cell: the worst case for the number of fibers is a half.
TEST(Population, ACellOfAnySizeHasItsVolumeAndTheMeanLengths) {
  for (const LengthLaw& law : {laws[1], laws[2], laws[4], laws[5]}) {
    FiberSpecies glass_fibers = glass(1), carbon = glass(1);
    glass_fibers.length = law;
    carbon.length = laws[4];
    carbon.material = {3.5e-6, 230e9, 1800};
    carbon.volume_share = 0.5;
    for (int i = 0; i < 20; ++i) {
      ConcentrationRequest request;
      request.volume_fraction = 0.08;
      request.cell_size = Vec3::Constant(1.3e-3 + 7e-6 * i);
      const Population population = plan_population({glass_fibers, carbon}, request, 2);
      double volume[2] = {0, 0}, first = 0, count = 0;
      for (const FiberBlank& fiber : population.fibers) {
        const double radius = population.materials[fiber.material_id].radius;
        volume[fiber.material_id] += pi * radius * radius * fiber.length;
        if (fiber.material_id > 0) continue;
        first += fiber.length;
        count += 1;
      }
      const double asked = 0.08 * request.cell_size->prod();
      EXPECT_NEAR(volume[0] / asked, 2. / 3, 1e-12);
      EXPECT_NEAR(volume[1] / asked, 1. / 3, 1e-12);
      EXPECT_NEAR(first / count / number_average(law), 1, 0.005);
    }
  }
}

TEST(Population, NoRodIsShorterThanItIsThick) {
  FiberSpecies species = glass(1);
  ConcentrationRequest request;
  request.count = 2000;
  request.volume_fraction = 0.05;
  for (const LengthLaw& law : {LengthLaw(WeibullLengths{0.2e-3, 0.4e-3}), LengthLaw(SingleLength{30e-6})}) {
    for (const double rod : {19e-6, 30e-6, 100e-6}) {
      species.length = law;
      species.rod_length = rod;
      for (const FiberBlank& fiber : plan_population({species}, request, 1).fibers)
        EXPECT_GE(fiber.length / fiber.rods, 19e-6 * (1 - 1e-12));
    }
  }
}

TEST(Population, RefusesContradictions) {
  ConcentrationRequest request;
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "the amount of fibers is not fixed: give two of: count, volume or weight fraction, cell size");
  request.count = 10;
  request.volume_fraction = 0.1;
  request.cell_size = Vec3::Constant(1e-3);
  EXPECT_EQ(
      refusal({glass(1e-3)}, request),
      "count, fraction and cell size of the fibers are all given: two of them fix the third: leave one out");
  request.cell_size.reset();
  request.weight_fraction = 0.1;
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "both a volume fraction and a weight fraction are given: give one of them");
}

TEST(Population, RefusesWhatCannotBe) {
  ConcentrationRequest request;
  request.count = 10;
  request.volume_fraction = 0.95;
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "a volume fraction of fibers of 0.95 does not exist: even parallel fibers fill at most 0.9069 "
            "(pi / sqrt 12)");
  request.volume_fraction = 1.5;
  EXPECT_EQ(refusal({glass(1e-3)}, request), "the volume fraction is 1.5: give a number between 0 and 1");
  request.volume_fraction.reset();
  request.weight_fraction = 0.3;
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "a weight fraction is given without the densities: give the densities of fibers and matrix, or "
            "the volume fraction");
  request.weight_fraction.reset();
  request.cell_size = Vec3(1e-3, 1e-3, 1e-5);
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "an edge of the cell is 1e-05 m: give at least two fiber diameters, 3.8e-05 m");
  request.count = 0;
  request.cell_size = Vec3::Constant(1e-3);
  EXPECT_EQ(refusal({glass(1e-3)}, request), "the number of fibers is 0: give at least 1");
  request.count = 100000;
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "100000 fibers fill 28.35 of the cell: even parallel fibers fill at most 0.9069 (pi / sqrt 12)");
  request.count.reset();
  request.volume_fraction = 1e-6;
  EXPECT_EQ(refusal({glass(1e-3)}, request),
            "the cell would hold no fiber: make the cell larger or the fraction higher");
  EXPECT_EQ(refusal({}, request), "no fibers are described: give at least one kind of fiber");
}

}  // namespace
}  // namespace fiberfate
