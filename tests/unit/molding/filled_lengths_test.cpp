// Tests mean lengths of layers, of samples and over the gap, and the properties of plies.
#include "molding/filled_lengths.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "continuum/length_registry.hpp"
#include "continuum/orientation_registry.hpp"
#include "molding/part_properties.hpp"
#include "plate.hpp"

namespace fiberfate {
namespace {

/// Fills a plate of 40 mm from one side, along x; fibers break the more the nearer they are to a wall. Like
/// spheres they turn with the melt, about y, and so keep an orientation that is alike along x and z.
Filling filled_plate(const Mat3& orientation, double share = 1) {
  FillingParams params;
  const double newtonian[] = {200}, breakage[] = {0.5, 0.02, 2e9, 19e-6};
  params.material.viscosity = make_viscosity_law("newtonian", newtonian);
  params.process.flow = FlowProfile::constant(4e-6);
  params.gates = {{}};
  params.gates[0].end = Vec3(0, 0.04, 0);
  params.numerics.heat = HeatModel::none;
  params.numerics.steps = 40;
  params.fibers.length_sets = {{"xi", make_attrition_law("unbreakable_length", breakage)}};
  params.fibers.class_lengths = {0.004, 0.012};
  params.fibers.class_numbers = {3, 1};
  OrientationModel still = orientation_model_named("folgar_tucker", "ibof");
  still.constants.c_i = 0;
  still.constants.xi = 0;
  params.fibers.orientation = still;
  params.fibers.inlet.orientation = orientation;
  Filling filling(test::plate(0.04, 8), params);
  while (!filling.finished() && filling.filled_fraction() < share) filling.advance();
  return filling;
}

/// The means of a population that has so many fibers of each class as keeps its fiber length: n_c = N_c
/// L_c0/L_c in every layer.
TEST(FilledLengths, ASampleHasTheFibersOfAllItsLayers) {
  const Filling filling = filled_plate(Mat3::Identity() / 3);
  const FilledLengths lengths(filling, LengthReading::population);
  const std::vector<Index> sample = {30, 31, 40};
  double numbers = 0, whole = 0, squares = 0, gap = 0, volumes = 0;
  for (const Index node : sample)
    for (std::size_t layer = 0; layer < filling.layers().count(); ++layer) {
      const auto at = static_cast<std::size_t>(node);
      const double volume = filling.mesh().volume(at) * filling.layers().widths()[layer];
      const auto both = filling.lengths(0, at, layer);
      const double few = 3 * 0.004 / both[0], many = 0.012 / both[1];
      numbers += volume * (few + many);
      whole += volume * (few * both[0] + many * both[1]);
      squares += volume * (few * both[0] * both[0] + many * both[1] * both[1]);
      gap += volume * (few * both[0] + many * both[1]) / (few + many);
      volumes += volume;
    }
  EXPECT_NEAR(lengths.sample_means(0, sample).number_average, whole / numbers, 1e-12);
  EXPECT_NEAR(lengths.sample_means(0, sample).weight_average, squares / whole, 1e-12);
  EXPECT_NEAR(lengths.gap_means(0, sample).number_average, gap / volumes, 1e-12);
  EXPECT_LT(whole / numbers, 0.999 * gap / volumes);
  EXPECT_EQ(lengths.means(0, sample).number_average, lengths.sample_means(0, sample).number_average);
}

/// A node at the front counts by the melt that it holds: 3*4 and 1*12 mm of fiber in every unit of volume,
/// which breakage keeps.
TEST(FilledLengths, APopulationHasTheMeltOfItsNodes) {
  const Filling filling = filled_plate(Mat3::Identity() / 3, 0.5);
  const FilledLengths lengths(filling, LengthReading::population);
  std::vector<Index> all(filling.mesh().node_count());
  std::iota(all.begin(), all.end(), 0);
  const LengthClasses population = lengths.population(0, all);
  EXPECT_NEAR(total_length(population) / (0.024 * filling.state().filled_volume), 1, 1e-12);
  EXPECT_EQ(mean_lengths(population).number_average, lengths.sample_means(0, all).number_average);
}

/// Of means that are followed by themselves the sample has the harmonic mean of L_N and the mean of L_W.
TEST(FilledLengths, MeansOfLayersMakeThoseOfTheSample) {
  const Filling filling = filled_plate(Mat3::Identity() / 3);
  const FilledLengths lengths(filling, LengthReading::means);
  const Index node[] = {40};
  double harmonic = 0, number = 0, weight = 0;
  for (std::size_t layer = 0; layer < filling.layers().count(); ++layer) {
    const double width = filling.layers().widths()[layer];
    const auto both = filling.lengths(0, 40, layer);
    harmonic += width / both[0];
    number += width * both[0];
    weight += width * both[1];
  }
  EXPECT_NEAR(lengths.sample_means(0, node).number_average, 1 / harmonic, 1e-12);
  EXPECT_NEAR(lengths.gap_means(0, node).number_average, number, 1e-12);
  EXPECT_NEAR(lengths.sample_means(0, node).weight_average, weight, 1e-12);
  EXPECT_EQ(lengths.means(0, node).number_average, lengths.gap_means(0, node).number_average);
}

TEST(FilledLengths, SamplesAreTheNodesAroundAPlaceOrTheNearest) {
  const ShellMesh mesh = test::plate(0.04, 8);
  EXPECT_EQ(sample_nodes(mesh, {0.021, 0.02, 0}, 1e-4), (std::vector<Index>{40}));
  EXPECT_EQ(sample_nodes(mesh, {0.02, 0.02, 0}, 0.0051), (std::vector<Index>{31, 39, 40, 41, 49}));
}

PartSolid glass_in_polypropylene() {
  PartSolid solid;
  solid.composite = {{73e9, 0.22}, {1.5e9, 0.4}, 5e-6, 1.1e-4, 0.15};
  return solid;
}

/// Fibers at random make a part that is alike in all directions.
TEST(PartProperties, RandomFibersAreIsotropic) {
  const Filling filling = filled_plate(Mat3::Identity() / 3);
  const auto all = triangle_properties({filling, LengthReading::population}, glass_in_polypropylene());
  ASSERT_EQ(all.size(), filling.mesh().triangle_count());
  for (const TriangleProperties& one : all) {
    EXPECT_NEAR(one.constants.e1 / one.constants.e3, 1, 0.02);  // what IBOF makes of isotropic states
    EXPECT_NEAR(one.constants.e1 / one.constants.e2, 1, 0.02);
    EXPECT_GT(one.constants.e1, 1.5e9);
  }
}

/// Plies fill half the gap, from the long fibers of the core to the short ones at the wall; aligned fibers
/// make them stiff along the part's second axis, and their mean is what the whole gap has.
TEST(PartProperties, PliesPartTheGap) {
  const Filling filling = filled_plate(Vec3(0.05, 0.9, 0.05).asDiagonal());
  const FilledLengths lengths(filling, LengthReading::population);
  const std::vector<Ply> all = plies(lengths, glass_in_polypropylene());
  const auto mean = triangle_properties(lengths, glass_in_polypropylene());
  ASSERT_EQ(all.size(), 4u);
  double shares = 0, stiffness = 0;
  const std::size_t triangle = mean.size() / 2;
  for (const Ply& ply : all) {
    EXPECT_NEAR(ply.share, 0.25, 0.1);
    EXPECT_NEAR(std::abs(ply.triangles[triangle].axes(1, 0)), 1, 1e-6);
    EXPECT_GT(ply.triangles[triangle].constants.e1, 2 * ply.triangles[triangle].constants.e2);
    shares += ply.share;
    stiffness += ply.share * ply.triangles[triangle].constants.e1;
  }
  EXPECT_NEAR(shares, 1, 1e-14);
  EXPECT_NEAR(stiffness / mean[triangle].constants.e1, 1, 1e-3);
  EXPECT_GT(all[0].triangles[triangle].constants.e1, all[3].triangles[triangle].constants.e1);
}

}  // namespace
}  // namespace fiberfate
