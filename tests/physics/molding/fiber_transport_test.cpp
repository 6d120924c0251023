// Compares the transport of lengths and orientations through steady channels with the point laws.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"
#include "physics/record.hpp"
#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

constexpr double rate = 1e-6, eta = 200;

FillingParams channel_params(const Rectangle& r) {
  FillingParams params =
      isothermal(rate, viscosity("newtonian", {eta}), film_gate({0, 0, 0}, {0, r.width, 0}));
  params.fibers.class_lengths = {0.015, 0.008};
  return params;
}

std::shared_ptr<const AttritionLaw> law(double xi) {
  const double values[] = {0.5, xi, 2e9, 19e-6};
  return make_attrition_law("unbreakable_length", values);
}

/// In a steady channel a layer of velocity v = (3/2)(Q/WH)(1 - zeta²) (mean over the layer) carries
///   L(x) = L_inf + (L_0 - L_inf) exp(-k_f x/v),
/// rate = 6 (Q/WH²) zeta, k_f = xi rate, L_inf = lambda d_f sqrt(sigma_u/(eta rate)).
TEST(LengthTransport, SteadyChannelKeepsTheExactProfile) {
  Rectangle r;
  r.across = 2;
  FillingParams params = channel_params(r);
  for (const double xi : {0.002, 0.02}) params.fibers.length_sets.push_back({"xi", law(xi)});
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();  // what is near the gate has then been steady for long
  const auto heights = filling.layers().shear_heights();
  const auto bounds = filling.layers().bounds();
  double squares = 0;
  int count = 0;
  for (std::size_t set = 0; set < 2; ++set)
    for (const double x : {0.01, 0.02, 0.03, 0.04})
      // Layers near the wall came from the front; those in which nothing of that is left are steady.
      for (std::size_t k = 0; k < filling.layers().count() / 2; ++k) {
        const double a = bounds[k], b = bounds[k + 1];
        const double mean = rate / (r.width * r.thickness);
        const double v = 1.5 * mean * (1 - (a * a + a * b + b * b) / 3);
        const double shear = 6 * mean / r.thickness * heights[k];
        const double limit = 0.5 * 19e-6 * std::sqrt(2e9 / (eta * shear));
        const double decay = std::exp(-(set == 0 ? 0.002 : 0.02) * shear * x / v);
        const std::size_t node = filling.mesh().nearest_node({x, 0.005, 0});
        for (std::size_t c = 0; c < 2; ++c) {
          const double start = params.fibers.class_lengths[c];
          const double wanted = start > limit ? limit + (start - limit) * decay : start;
          squares += std::pow(filling.lengths(set, node, k)[c] / wanted - 1, 2);
          ++count;
        }
      }
  record("rms relative error of the lengths in a steady channel", 0, std::sqrt(squares / count), 0.005);
}

/// Sets and classes do not disturb each other: one of many is the same as one alone.
TEST(LengthTransport, ManySetsAreAsOne) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams many = channel_params(r), one = channel_params(r);
  for (const double xi : {0.001, 0.003, 0.01, 0.03}) many.fibers.length_sets.push_back({"xi", law(xi)});
  one.fibers.length_sets = {{"xi", law(0.01)}};
  one.fibers.class_lengths = {0.008};
  Filling first{ShellMesh(rectangle(r)), many}, second{ShellMesh(rectangle(r)), one};
  first.run_to_end();
  second.run_to_end();
  for (std::size_t node = 0; node < first.mesh().node_count(); node += 7)
    for (std::size_t k = 0; k < first.layers().count(); ++k)
      EXPECT_EQ(first.lengths(2, node, k)[1], second.lengths(0, node, k)[0]);
}

/// Lengths that are followed again through the steps that were kept are those of a filling with these laws.
TEST(LengthTransport, FollowedAgainIsAsFilledAnew) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = channel_params(r);
  params.fibers.class_numbers = {1, 2};
  params.fibers.length_sets = {{"xi", law(0.001)}};
  Filling kept{ShellMesh(rectangle(r)), params};
  kept.keep_steps();
  kept.run_to_end();
  const double phelps[] = {0.01, 3, 0.25, 73e9, 19e-6, 0};
  for (const auto& other :
       {law(0.02), std::shared_ptr<const AttritionLaw>(make_attrition_law("phelps", phelps))}) {
    params.fibers.length_sets = {{"other", other}};
    Filling anew{ShellMesh(rectangle(r)), params};
    anew.run_to_end();
    kept.follow_lengths_again({{"other", other}});
    EXPECT_EQ(kept.state().lengths, anew.state().lengths);
  }
  Filling begun{ShellMesh(rectangle(r)), params};
  begun.advance();
  begun.keep_steps();
  begun.advance();
  EXPECT_THROW(begun.follow_lengths_again({{"xi", law(0.001)}}), InputError);
}

/// Phelps' law moves numbers of fibers; their length sum n L is a passive tracer.
TEST(LengthTransport, PhelpsKeepsTheFiberLength) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = channel_params(r);
  params.fibers.class_numbers = {1, 2};
  params.fibers.phelps_bins = 30;
  const double values[] = {0.01, 3, 0.25, 73e9, 19e-6, 0};
  params.fibers.length_sets = {{"phelps", make_attrition_law("phelps", values)}};
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  const auto bins = filling.bin_lengths(0);
  double shortest = 1;
  for (std::size_t node = 0; node < filling.mesh().node_count(); ++node)
    for (std::size_t k = 0; k < filling.layers().count(); ++k) {
      const auto numbers = filling.lengths(0, node, k);
      double total = 0, count = 0;
      for (std::size_t b = 0; b < bins.size(); ++b) {
        EXPECT_GE(numbers[b], 0);
        total += numbers[b] * bins[b];
        count += numbers[b];
      }
      EXPECT_NEAR(total, 0.015 + 2 * 0.008, 1e-9);
      shortest = std::min(shortest, total / count);
    }
  EXPECT_LT(shortest, 0.8 * 0.031 / 3);
}

/// Two gates bring in different distributions of the same fiber length: amounts of classes and bins ride on
/// the melt, nothing is lost, and their sum is everywhere what comes in.
TEST(LengthTransport, GatesBringInDistributionsOfTheirOwn) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = channel_params(r);
  params.gates.push_back(film_gate({0.06, 0, 0}, {0.06, r.width, 0}));
  params.gates[1].intervals[0].opens = {TriggerKind::filled_fraction, 0.3};
  params.fibers.class_numbers = {1, 2};
  params.fibers.gate_inlets = {std::nullopt, InletFibers{}};
  params.fibers.gate_inlets[1]->numbers = {3, 1};
  const double still[] = {0, 1}, phelps[] = {0.01, 3, 0.25, 73e9, 19e-6, 0};
  params.fibers.length_sets = {{"still", make_attrition_law("constant", still)},
                               {"phelps", make_attrition_law("phelps", phelps)}};
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  const double first[] = {0.015, 2 * 0.008}, whole = first[0] + first[1];
  const double scale = whole / (3 * 0.015 + 0.008), second[] = {scale * 3 * 0.015, scale * 0.008};
  double held[2] = {0, 0}, mixed = 0;
  for (std::size_t node = 0; node < filling.mesh().node_count(); ++node)
    for (std::size_t k = 0; k < filling.layers().count(); ++k) {
      const auto amounts = filling.amounts(node, k), lengths = filling.lengths(0, node, k);
      const auto bins = filling.lengths(1, node, k);
      double total = 0;
      for (std::size_t b = 0; b < bins.size(); ++b) total += bins[b] * filling.bin_lengths(1)[b];
      EXPECT_NEAR(total, whole, 1e-9);
      EXPECT_NEAR(amounts[0] + amounts[1], whole, 1e-12);
      EXPECT_NEAR(lengths[0], 0.015, 1e-14);
      EXPECT_NEAR(lengths[1], 0.008, 1e-14);
      const double volume = filling.mesh().volume(node) * filling.layers().widths()[k];
      for (std::size_t c = 0; c < 2; ++c) held[c] += volume * amounts[c];
      if (amounts[0] > 1.01 * first[0] && amounts[0] < 0.99 * second[0]) mixed += volume;
    }
  EXPECT_GT(mixed, 0);
  for (std::size_t c = 0; c < 2; ++c) {
    const double brought =
        first[c] * filling.state().gates[0].volume + second[c] * filling.state().gates[1].volume;
    EXPECT_NEAR(held[c], brought, 1e-10 * brought);
  }
}

OrientationModel model() {
  OrientationModel m = orientation_model_named("folgar_tucker", "ibof");
  m.constants.c_i = 0.02;
  return m;
}

/// Near the wall melt creeps and shears for long: its orientation is where the point law ends in simple
/// shear, v_1 = rate x_3.
TEST(OrientationTransport, WallHasTheSteadyStateOfThePointLaw) {
  Rectangle r;
  r.across = 2;
  FillingParams params = channel_params(r);
  params.fibers.orientation = model();
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  Flow across_the_gap;
  across_the_gap.gradient(0, 2) = 1;
  OrientationIntegrator point(OrientationLaw(model()), FlowHistory::constant(across_the_gap), {});
  point.advance_to(300);
  const std::size_t node = filling.mesh().nearest_node({0.04, 0.005, 0}), wall = filling.layers().count() - 2;
  Mat3 wanted = point.state().second, found = filling.orientation(node, wall);
  // In the upper half of the gap the velocity falls with height: the gradient points down.
  wanted(0, 2) = wanted(2, 0) = -wanted(0, 2);
  EXPECT_LT((found - wanted).norm(), 1e-6);
}

/// Turned parts and bent parts show the same orientation in the frame of the surface.
TEST(OrientationTransport, FrameOfThePartDoesNotMatter) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = channel_params(r);
  params.fibers.orientation = model();
  params.fibers.inlet = {Vec3(0.6, 0.3, 0.1).asDiagonal(), InletAxes::flow, {}, {}};
  Filling flat{ShellMesh(rectangle(r)), params};
  flat.run_to_end();
  const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3(2, -1, 1).normalized()).toRotationMatrix();
  const auto turned = [&](const Vec3& x) { return Vec3(turn * x); };
  const auto folded = [&](const Vec3& x) {
    return x[0] < 0.041 ? Vec3(x[0], x[1], 0) : Vec3(0.04, x[1], x[0] - 0.04);
  };
  params.gates = {film_gate(turned({0, 0, 0}), turned({0, r.width, 0}))};
  Filling second{ShellMesh(rectangle(r, turned)), params};
  second.run_to_end();
  params.gates = {film_gate({0, 0, 0}, {0, r.width, 0})};
  Filling third{ShellMesh(rectangle(r, folded)), params};
  third.run_to_end();
  const Mat3 fold = Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitY()).toRotationMatrix();
  for (const double x : {0.02, 0.06})
    for (std::size_t k = 0; k < flat.layers().count(); ++k) {
      const std::size_t node = flat.mesh().nearest_node({x, 0.005, 0});
      const Mat3 a = flat.orientation(node, k);
      // Round-off decides which of equal nodes fills last, and a step differs by that.
      EXPECT_LT((second.orientation(node, k) - turn * a * turn.transpose()).norm(), 1e-4);
      const Mat3 there = x < 0.04 ? a : Mat3(fold * a * fold.transpose());
      EXPECT_LT((third.orientation(node, k) - there).norm(), 1e-3);
    }
}

}  // namespace
}  // namespace fiberfate
