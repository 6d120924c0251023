// Throws some 4500 seeded random calls at the C interface: every one returns a status, failures say why,
// nothing crashes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "continuum/fiberfate.h"

namespace {

constexpr std::size_t points = 9;  // more than one group of eight
constexpr std::size_t bins = 12;
constexpr int degree = 4;

/// Draws arguments: mostly sound ones, so that calls get beyond their first check, and now and then nonsense.
class Arguments {
 public:
  explicit Arguments(unsigned seed) : random_(seed) {}

  bool chance(double share) { return std::uniform_real_distribution<>(0, 1)(random_) < share; }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  double number(double sound) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::array<double, 12> nonsense = {std::nan(""), infinity, -infinity, -1, 0,      1e300,
                                             -1e300,       1e-300,   4,         2,  -sound, 1e10 * sound};
    return chance(0.03) ? nonsense[below(nonsense.size())] : sound;
  }
  std::vector<double> numbers(std::size_t count, double sound) {
    std::vector<double> all(count);
    for (double& one : all)
      one = chance(0.1) ? number(sound) : sound * std::uniform_real_distribution<>(0.5, 1)(random_);
    return all;
  }
  std::vector<double> orientations() {
    std::vector<double> all;
    for (std::size_t i = 0; i < points; ++i)
      for (const double component : {0.5, 0.3, 0.2, 0.02, 0.01, 0.05})
        all.push_back(chance(0.01) ? number(component) : component);
    return all;
  }
  const char* word(std::initializer_list<const char*> sound) {
    if (chance(0.03)) return nullptr;
    if (chance(0.05)) return words_[below(words_.size())];
    return *(sound.begin() + below(sound.size()));
  }
  std::vector<fiberfate_constant> constants(std::initializer_list<fiberfate_constant> sound) {
    std::vector<fiberfate_constant> all(sound);
    for (fiberfate_constant& one : all) {
      one.value = number(one.value);
      if (chance(0.02)) one.name = words_[below(words_.size())];
      if (chance(0.01)) one.name = nullptr;
    }
    if (!all.empty() && chance(0.05)) all.pop_back();
    return all;
  }
  double* or_null(std::vector<double>& array) { return chance(0.03) ? nullptr : array.data(); }

 private:
  std::mt19937 random_;
  std::array<const char*, 6> words_ = {"",         "ibof",     "phelps",
                                       "iard+rsc", "\xff\xfe", "a name that no law has, and long"};
};

class Fuzz : public ::testing::Test {
 protected:
  void expect_status(fiberfate_status status) {
    ASSERT_TRUE(status == FIBERFATE_OK || status == FIBERFATE_BAD_INPUT || status == FIBERFATE_FAILED);
    if (status != FIBERFATE_OK) {
      ASSERT_GT(std::strlen(fiberfate_error_text()), 5U);
      ++refused;
    } else {
      ++done;
    }
  }
  void expect_finite(fiberfate_status status, const std::vector<double>& results) {
    expect_status(status);
    if (status != FIBERFATE_OK) return;
    for (const double one : results) ASSERT_TRUE(std::isfinite(one));
  }

  void orientation();
  void length();
  void breakage();
  void melt();
  void distribution();

  Arguments draw{20261130};
  int done = 0, refused = 0;
};

void Fuzz::orientation() {
  const char* model = draw.word({"folgar_tucker", "rsc", "iard_rpr", "mrd+rsc", "pard"});
  const char* closure = draw.word({"ibof", "ore", "hybrid", "linear"});
  auto constants = draw.constants({{"C_I", 0.02}});
  fiberfate_orientation_law* law = nullptr;
  expect_status(fiberfate_orientation_create(model, closure, constants.data(), constants.size(), &law));
  std::vector<double> states = draw.orientations(), gradients = draw.numbers(9 * points, 2.0),
                      rates(6 * points), fourth(36 * points), steady(6);
  expect_finite(
      fiberfate_orientation_rates(law, points, draw.or_null(states), draw.or_null(gradients), rates.data()),
      rates);
  std::size_t put_back = 0;
  expect_status(fiberfate_orientation_advance_counted(law, points, draw.or_null(states), gradients.data(),
                                                      draw.number(0.1), draw.number(1e-4), &put_back));
  expect_finite(fiberfate_close(closure, points, states.data(), draw.or_null(fourth)), fourth);
  if (draw.chance(0.2))
    expect_finite(fiberfate_orientation_steady(law, gradients.data(), steady.data(), nullptr), steady);
  fiberfate_orientation_destroy(law);
}

void Fuzz::length() {
  auto constants = draw.constants({{"lambda", 0.05}, {"xi", 0.004}, {"sigma_u", 2e9}, {"d_f", 19e-6}});
  fiberfate_length_law* law = nullptr;
  expect_status(
      fiberfate_length_create(draw.word({"unbreakable_length"}), constants.data(), constants.size(), &law));
  std::vector<double> rates = draw.numbers(points, 100), viscosities = draw.numbers(points, 200),
                      lengths = draw.numbers(points, 5e-3), results(points), more(points);
  expect_status(fiberfate_length_rates(law, points, draw.or_null(rates), viscosities.data(), lengths.data(),
                                       results.data()));
  expect_status(fiberfate_length_coefficients(law, points, rates.data(), viscosities.data(), results.data(),
                                              draw.or_null(more)));
  expect_finite(fiberfate_length_advance(law, points, rates.data(), draw.or_null(viscosities), draw.number(1),
                                         lengths.data()),
                lengths);
  double number_average = 0, weight_average = 0;
  expect_status(fiberfate_mean_lengths(points, lengths.data(), draw.or_null(results), &number_average,
                                       &weight_average));
  fiberfate_length_destroy(law);
}

void Fuzz::breakage() {
  auto constants = draw.constants({{"C_B", 0.02}, {"zeta", 3}, {"S", 0.25}});
  const std::array<std::size_t, 5> odd = {0, 1, std::size_t{1} << 32, ~std::size_t{0}, 1000000};
  const std::size_t count = draw.chance(0.1) ? odd[draw.below(odd.size())] : bins;
  fiberfate_breakage_law* law = nullptr;
  expect_status(fiberfate_breakage_create(draw.word({"phelps", "durin"}), constants.data(), constants.size(),
                                          count, draw.number(15e-3), &law));
  ASSERT_TRUE(law == nullptr || count == bins);
  std::vector<double> rates = draw.numbers(points, 100), viscosities = draw.numbers(points, 200),
                      numbers = draw.numbers(points * bins, 50), results(points * bins),
                      children(bins * bins), more(points);
  expect_finite(
      fiberfate_breakage_rates(law, points, rates.data(), draw.or_null(viscosities), nullptr, results.data()),
      results);
  expect_status(
      fiberfate_breakage_unbreakable_lengths(law, points, rates.data(), viscosities.data(), more.data()));
  expect_finite(fiberfate_breakage_children(law, draw.or_null(children)), children);
  expect_finite(fiberfate_breakage_advance(law, points, rates.data(), viscosities.data(), nullptr,
                                           draw.number(2), draw.or_null(numbers)),
                numbers);
  expect_status(fiberfate_breakage_means(law, points, numbers.data(), results.data(), draw.or_null(more)));
  fiberfate_breakage_destroy(law);
}

void Fuzz::melt() {
  auto constants = draw.constants({{"eta_0", 400}, {"tau", 2e4}, {"n", 0.3}});
  fiberfate_viscosity_law* law = nullptr;
  expect_status(fiberfate_viscosity_create(draw.word({"cross"}), constants.data(), constants.size(), &law));
  const char* closure = draw.word({"ibof", "ore", "orw"});
  std::vector<double> rates = draw.numbers(points, 100), gradients = draw.numbers(9 * points, 2),
                      states = draw.orientations(), viscosities(points), stresses(6 * points),
                      stiffness(36 * points), expansion(6 * points), aspects = draw.numbers(2, 30),
                      shares = draw.numbers(2, 1);
  expect_finite(
      fiberfate_viscosity_evaluate(law, points, draw.or_null(rates), nullptr, nullptr, viscosities.data()),
      viscosities);
  fiberfate_viscosity_destroy(law);
  viscosities = draw.numbers(points, 300);
  expect_status(fiberfate_fiber_stress(closure, draw.number(3), points, states.data(), gradients.data(),
                                       draw.or_null(viscosities), stresses.data()));
  expect_status(fiberfate_informed_viscosity(closure, draw.number(3), points, states.data(), gradients.data(),
                                             viscosities.data(), draw.or_null(stresses)));
  fiberfate_composite composite = {draw.number(73e9),  draw.number(0.22), draw.number(5e-6),
                                   draw.number(1.5e9), draw.number(0.4),  draw.number(1e-4),
                                   draw.number(0.2)};
  expect_status(fiberfate_stiffness(draw.word({"mori_tanaka", "lielens", "halpin_tsai"}), closure,
                                    draw.chance(0.03) ? nullptr : &composite, 2, aspects.data(),
                                    shares.data(), points, states.data(), draw.or_null(stiffness),
                                    draw.or_null(expansion)));
}

void Fuzz::distribution() {
  auto constants = draw.constants({{"C_I", 0.5}});
  fiberfate_distribution* equation = nullptr;
  const int chosen = draw.chance(0.1) ? -3 : degree;
  expect_status(fiberfate_distribution_create(draw.word({"folgar_tucker"}), constants.data(),
                                              constants.size(), chosen, &equation));
  std::vector<double> psi(15), state = {0.34, 0.33, 0.33, 0, 0, 0}, gradient = draw.numbers(9, 0.5),
                               second(6), density(3), directions = draw.numbers(9, 1);
  state[0] = draw.number(state[0]);
  ASSERT_TRUE(equation == nullptr || fiberfate_distribution_size(equation) == psi.size());
  expect_finite(fiberfate_distribution_start(equation, state.data(), psi.data()), psi);
  expect_finite(fiberfate_distribution_advance(equation, draw.or_null(gradient), draw.number(0.1),
                                               draw.number(1e-4), psi.data()),
                psi);
  expect_finite(fiberfate_distribution_moments(equation, psi.data(), second.data(), nullptr), second);
  expect_status(
      fiberfate_distribution_density(equation, psi.data(), 3, draw.or_null(directions), density.data()));
  fiberfate_distribution_destroy(equation);
}

TEST_F(Fuzz, EveryCallReturnsAStatusWithWords) {
  for (int round = 0; round < 200 && !HasFatalFailure(); ++round) {
    orientation();
    length();
    breakage();
    melt();
    distribution();
  }
  // Both ways are taken often, or the test shows nothing.
  EXPECT_GT(done, 1000);
  EXPECT_GT(refused, 1000);
  RecordProperty("done", done);
  RecordProperty("refused", refused);
}

}  // namespace
