// Checks what the C interface reaches besides rates and steps: the same numbers as C++.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/threads.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/fiberfate.h"
#include "continuum/fokker_planck.hpp"
#include "continuum/homogenisation.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/orientation_steady.hpp"
#include "continuum/phelps.hpp"
#include "continuum/viscosity.hpp"
#include "continuum/viscosity_cross.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

const std::vector<double> state = {0.5, 0.3, 0.2, 0.02, 0.04, 0.1};
const std::vector<double> gradient = {0.1, 0.4, 2, -0.3, 0.2, 0.5, 0.1, 0, -0.3};

Mat3 second() {
  return to_matrix(Eigen::Map<const Vec6>(state.data()));
}
Mat3 strain() {
  const Mat3 l = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(gradient.data());
  return 0.5 * (l + l.transpose());
}

TEST(CApiLaws, SteadyStatesAndStatesThatWerePutBack) {
  const fiberfate_constant constants[] = {{"C_I", 0.0311}};
  fiberfate_orientation_law* law = nullptr;
  ASSERT_EQ(fiberfate_orientation_create("folgar_tucker", "ibof", constants, 1, &law), FIBERFATE_OK);
  const std::vector<double> shear = {0, 1, 0, 0, 0, 0, 0, 0, 0};
  std::vector<double> steady(6);
  double decay = 0;
  ASSERT_EQ(fiberfate_orientation_steady(law, shear.data(), steady.data(), &decay), FIBERFATE_OK)
      << fiberfate_error_text();
  EXPECT_NEAR(steady[0], 0.6493761451, 1e-10);
  EXPECT_NEAR(steady[5], 0.1133462673, 1e-10);
  EXPECT_GT(decay, 0);
  EXPECT_EQ(fiberfate_orientation_steady(law, std::vector<double>(9, 0.0).data(), steady.data(), nullptr),
            FIBERFATE_BAD_INPUT);
  std::vector<double> off = state;
  off[0] += 5e-4;
  std::size_t put_back = 9;
  ASSERT_EQ(fiberfate_orientation_advance_counted(law, 1, off.data(), shear.data(), 0.1, 1e-6, &put_back),
            FIBERFATE_OK);
  EXPECT_EQ(put_back, 1U);
  fiberfate_orientation_destroy(law);
}

TEST(CApiLaws, LengthsBreakageAndMeans) {
  const fiberfate_constant constants[] = {{"k_f", 0.2}, {"L_inf", 1e-3}};
  fiberfate_length_law* length = nullptr;
  ASSERT_EQ(fiberfate_length_create("constant", constants, 2, &length), FIBERFATE_OK);
  const std::vector<double> rates = {50, 200}, viscosities = {300, 200};
  std::vector<double> k(2), final_length(2);
  ASSERT_EQ(fiberfate_length_coefficients(length, 2, rates.data(), viscosities.data(), k.data(),
                                          final_length.data()),
            FIBERFATE_OK);
  EXPECT_EQ(k[1], 0.2);
  EXPECT_EQ(final_length[0], 1e-3);
  fiberfate_length_destroy(length);

  const fiberfate_constant phelps[] = {{"C_B", 0.02}, {"zeta", 3}, {"S", 0.25}};
  fiberfate_breakage_law* breakage = nullptr;
  ASSERT_EQ(fiberfate_breakage_create("phelps", phelps, 3, 20, 15e-3, &breakage), FIBERFATE_OK);
  std::vector<double> unbreakable(2), children(400), numbers(40, 1.0), number(2), weight(2);
  ASSERT_EQ(fiberfate_breakage_unbreakable_lengths(breakage, 2, rates.data(), viscosities.data(),
                                                   unbreakable.data()),
            FIBERFATE_OK);
  EXPECT_EQ(unbreakable[1], unbreakable_length({0.02, 3, 0.25, 73e9, 19e-6}, {200, 200, 1}));
  ASSERT_EQ(fiberfate_breakage_children(breakage, children.data()), FIBERFATE_OK);
  const std::vector<double> expected = child_numbers(20, 0.25);
  for (std::size_t i = 0; i < 20; ++i)
    for (std::size_t parent = 0; parent < 20; ++parent)
      EXPECT_EQ(children[20 * i + parent], expected[i + 20 * parent]);
  numbers[1] = 5;  // bin 0 of the second point
  ASSERT_EQ(fiberfate_breakage_means(breakage, 2, numbers.data(), number.data(), weight.data()),
            FIBERFATE_OK);
  EXPECT_NEAR(number[0], 15e-3 * 10.5 / 20, 1e-15);
  EXPECT_LT(number[1], number[0]);
  fiberfate_breakage_destroy(breakage);
  EXPECT_NEAR(fiberfate_breakage_memory(100000), 40e9, 1e9);

  const std::vector<double> lengths = {1e-3, 3e-3};
  double l_n = 0, l_w = 0;
  ASSERT_EQ(fiberfate_mean_lengths(2, lengths.data(), nullptr, &l_n, &l_w), FIBERFATE_OK);
  EXPECT_NEAR(l_n, 2e-3, 1e-18);
  EXPECT_NEAR(l_w, 2.5e-3, 1e-18);
}

TEST(CApiLaws, ViscosityStressAndStiffness) {
  const fiberfate_constant constants[] = {{"eta_0", 400}, {"tau", 2e4}, {"n", 0.3}};
  fiberfate_viscosity_law* law = nullptr;
  ASSERT_EQ(fiberfate_viscosity_create("cross", constants, 3, &law), FIBERFATE_OK) << fiberfate_error_text();
  const std::vector<double> rates = {0, 100};
  std::vector<double> viscosities(2), stress(6), effective(1);
  ASSERT_EQ(fiberfate_viscosity_evaluate(law, 2, rates.data(), nullptr, nullptr, viscosities.data()),
            FIBERFATE_OK);
  EXPECT_EQ(viscosities[1], (Cross{400, 2e4, 0.3}({100, 0, 0})));
  fiberfate_viscosity_destroy(law);

  ASSERT_EQ(
      fiberfate_fiber_stress("ore", 3, 1, state.data(), gradient.data(), &viscosities[1], stress.data()),
      FIBERFATE_OK);
  const Mat6 fourth = close(second(), closure_named("ore"));
  EXPECT_EQ(stress[5], anisotropic_stress(viscosities[1], 3, strain(), fourth)(0, 1));
  ASSERT_EQ(fiberfate_informed_viscosity("ore", 5, 1, state.data(), gradient.data(), &viscosities[1],
                                         effective.data()),
            FIBERFATE_OK);
  EXPECT_EQ(effective[0], informed_isotropic_viscosity(viscosities[1], 5, strain(), fourth));
  double particles = 0;
  ASSERT_EQ(fiberfate_particle_number(25, 0.2, &particles), FIBERFATE_OK);
  EXPECT_EQ(particles, particle_number(25, 0.2));

  const fiberfate_composite glass = {73e9, 0.22, 5e-6, 1.5e9, 0.4, 1e-4, 0.2};
  const std::vector<double> aspects = {10, 50}, shares = {1, 3};
  std::vector<double> stiffness(36), expansion(6);
  ASSERT_EQ(fiberfate_stiffness("mori_tanaka", "ore", &glass, 2, aspects.data(), shares.data(), 1,
                                state.data(), stiffness.data(), expansion.data()),
            FIBERFATE_OK)
      << fiberfate_error_text();
  const CompositeMaterial material = {{73e9, 0.22}, {1.5e9, 0.4}, 5e-6, 1e-4, 0.2};
  const std::vector<AspectRatioClass> classes = {{10, 1}, {50, 3}};
  const ThermoelasticProperties properties = orientation_average(
      length_average(material, classes, homogenisation_named("mori_tanaka")), fourth, second());
  for (std::size_t k = 0; k < 36; ++k)
    EXPECT_EQ(stiffness[k], properties.stiffness(static_cast<int>(k) / 6, static_cast<int>(k) % 6));
  EXPECT_EQ(expansion[0], thermal_expansion(properties)(0, 0));
}

TEST(CApiLaws, TheDistributionItself) {
  const fiberfate_constant constants[] = {{"C_I", 0.05}};
  fiberfate_distribution* distribution = nullptr;
  ASSERT_EQ(fiberfate_distribution_create("folgar_tucker", constants, 1, 40, &distribution), FIBERFATE_OK)
      << fiberfate_error_text();
  const std::size_t size = fiberfate_distribution_size(distribution);
  EXPECT_EQ(size, 41U * 42U / 2U);
  const std::vector<double> shear = {0, 1, 0, 0, 0, 0, 0, 0, 0},
                            isotropic = {1.0 / 3, 1.0 / 3, 1.0 / 3, 0, 0, 0};
  std::vector<double> psi(size), steady(size), moment(6), fourth(36), density(1);
  ASSERT_EQ(fiberfate_distribution_start(distribution, isotropic.data(), psi.data()), FIBERFATE_OK);
  ASSERT_EQ(fiberfate_distribution_advance(distribution, shear.data(), 2, 1e-8, psi.data()), FIBERFATE_OK)
      << fiberfate_error_text();
  ASSERT_EQ(fiberfate_distribution_steady(distribution, shear.data(), steady.data()), FIBERFATE_OK);
  ASSERT_EQ(fiberfate_distribution_moments(distribution, steady.data(), moment.data(), fourth.data()),
            FIBERFATE_OK);
  EXPECT_NEAR(moment[0] + moment[1] + moment[2], 1, 1e-12);
  EXPECT_NEAR(fourth[0] + fourth[1] + fourth[2], moment[0], 1e-10);
  const std::vector<double> along = {2, 0, 0};
  ASSERT_EQ(fiberfate_distribution_density(distribution, steady.data(), 1, along.data(), density.data()),
            FIBERFATE_OK);
  EXPECT_GT(density[0], 1 / (4 * 3.14159));
  fiberfate_distribution_destroy(distribution);
}

TEST(CApiLaws, ThreadsAreSetAndTold) {
  const int before = fiberfate_threads();
  EXPECT_EQ(fiberfate_set_threads(2), FIBERFATE_OK);
  EXPECT_EQ(fiberfate_threads(), 2);
  EXPECT_EQ(fiberfate_set_threads(0), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(fiberfate_set_threads(1 << 30), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(fiberfate_threads(), 2);
  use_threads(before);
}

}  // namespace
}  // namespace fiberfate
