// Checks the grid of the rheometer, and what it measures against the study shear_cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "results/memory_recorder.hpp"
#include "studies/rheometer/run.hpp"
#include "studies/shear_cell/run.hpp"

namespace fiberfate {
namespace {

RheometerCase few_fibers() {
  RheometerCase values;
  ShearCellCase& cell = values.cell;
  cell.sample.fibers.count = 8;
  cell.sample.fibers.volume_fraction = 0.03;
  cell.sample.fibers.diameter = 19e-6;
  cell.sample.fibers.length = 0.3e-3;
  cell.sample.fibers.rod_length = 0.1e-3;
  cell.sample.fibers.youngs_modulus = 73e9;
  cell.flow.viscosity = 200;
  cell.flow.rate = 20;
  cell.run.duration = 0.1;
  cell.run.seed = 5;
  values.sweep.replicas = 1;
  return values;
}

Outcome compute(const RheometerCase& values) {
  MemoryRecorder recorder;
  Session session(recorder, {.threads = 1});
  Outcome outcome = compute_rheometer(values, session);
  recorder.hand_over(outcome);
  return outcome;
}

double number(const Outcome& outcome, const std::string& key) {
  for (const auto& [name, value] : outcome.summary.own)
    if (name == key) return std::get<double>(value);
  return std::nan("");
}

TEST(RheometerGrid, ChangesRatesFirst) {
  RheometerSweep sweep;
  sweep.flows = {"shear", "uniaxial"};
  sweep.lengths = {1e-3, 2e-3};
  sweep.rates = {1, 10, 100};
  const std::vector<RheometerPoint> all = points(sweep);
  ASSERT_EQ(all.size(), 12U);
  EXPECT_EQ(*all[1].rate, 1U);
  EXPECT_EQ(*all[1].length, 0U);
  EXPECT_EQ(*all[3].length, 1U);
  EXPECT_EQ(*all[3].flow, 0U);
  EXPECT_EQ(*all[6].flow, 1U);
  EXPECT_FALSE(all[6].volume_fraction.has_value());
  // Points with the same fibers are of one kind, whatever flows.
  EXPECT_EQ(all[0].fibers, all[6].fibers);
  EXPECT_NE(all[0].fibers, all[3].fibers);
  EXPECT_EQ(kinds_of_fibers(sweep), 2U);
}

TEST(RheometerGrid, MakesCellsOfItsLists) {
  RheometerCase values = few_fibers();
  values.cell.flow.rate.reset();
  values.sweep.flows = {"planar", "biaxial"};
  values.sweep.volume_fractions = {0.01, 0.02};
  values.sweep.rates = {1, -10};
  values.sweep.strain = 5;
  const ShearCellCase cell = cell_at(values, points(values.sweep).back(), 2);
  EXPECT_EQ(cell.flow.type, FlowType::biaxial);
  EXPECT_EQ(cell.sample.fibers.volume_fraction, 0.02);
  EXPECT_EQ(cell.sample.fibers.length, 0.3e-3);
  EXPECT_EQ(cell.flow.rate, -10);
  EXPECT_EQ(cell.run.seed, 7U);
  EXPECT_DOUBLE_EQ(cell.run.duration, 0.5);  // to a strain of 5 at 10 1/s
}

// A point is a sheared cell: its means and errors are those that shear_cell tells of the same case.
TEST(Rheometer, MeasuresWhatASheardCellDoes) {
  const RheometerCase values = few_fibers();
  const Outcome found = compute(values);
  MemoryRecorder recorder;
  Session session(recorder, {.threads = 1});
  const Outcome cell = compute_shear_cell(values.cell, session);
  const CsvTable& readings = found.table("rheometer");
  ASSERT_EQ(readings.rows(), 1U);
  EXPECT_EQ(readings.column("relative_viscosity").front(), number(cell, "relative_viscosity_mean"));
  EXPECT_EQ(readings.column("relative_viscosity_error").front(), number(cell, "relative_viscosity_error"));
  EXPECT_EQ(readings.column("N1_Pa").front(), number(cell, "N1_mean_Pa"));
  EXPECT_EQ(readings.column("L_N_m").front(), cell.summary.number_average.value());
}

// The rate's size hardly matters where fibers are stiff: a tenth of the rate gives a tenth of the stress.
TEST(Rheometer, AveragesReplicasAndFitsThem) {
  RheometerCase values = few_fibers();
  values.cell.flow.rate.reset();
  values.sweep.rates = {2, 20};
  values.sweep.strain = 2;
  values.sweep.replicas = 2;
  const Outcome found = compute(values);
  const CsvTable &readings = found.table("rheometer"), &curves = found.table("curves"),
                 &fits = found.table("fits");
  ASSERT_EQ(readings.rows(), 4U);
  ASSERT_EQ(curves.rows(), 2U);
  ASSERT_EQ(fits.rows(), 1U);
  const std::vector<double>& viscosity = readings.column("relative_viscosity");
  EXPECT_DOUBLE_EQ(curves.column("relative_viscosity")[0], (viscosity[0] + viscosity[1]) / 2);
  EXPECT_NEAR(curves.column("relative_viscosity_error")[0], std::abs(viscosity[0] - viscosity[1]) / 2, 1e-12);
  // Both rates start from the same packings: what is left of the difference is bending and the steps.
  EXPECT_NEAR(viscosity[0], viscosity[2], 0.02 * viscosity[0]);
  EXPECT_EQ(readings.column("seed"), (std::vector<double>{5, 6, 5, 6}));
  EXPECT_EQ(readings.column("strain")[0], 2);
  EXPECT_EQ(fits.column("readings").front(), 4);
  EXPECT_GT(fits.column("particle_number").front(), 0);
  EXPECT_GT(fits.column("stress_explained").front(), 0.5);
}

// Fibers that are still aligning make the melt more viscous all the time, and the run says so.
TEST(Rheometer, WarnsOfFlowsThatAreNotSteady) {
  RheometerCase values = few_fibers();
  values.cell.flow.type = FlowType::planar;
  values.sweep.strain = 1;
  MemoryRecorder recorder;
  Session session(recorder, {.threads = 1});
  const Outcome found = compute_rheometer(values, session);
  EXPECT_GT(found.table("curves").column("relative_viscosity_drift").front(), 0);
  const auto warns = [](const LogLine& line) {
    return line.level == LogLine::Level::warning &&
           line.text.starts_with("not steady yet: what fibers add to the viscosity rises");
  };
  EXPECT_TRUE(std::any_of(recorder.log().begin(), recorder.log().end(), warns));
}

// Drag of beads that do not shield each other pulls on a rod by 3 pi eta a length: N_p = r²/2 where fibers
// are straight and do not touch.
TEST(Rheometer, FindsTheParticleNumberOfRodsOfBeads) {
  RheometerCase values = few_fibers();
  values.cell.flow.type = FlowType::planar;
  values.cell.dynamics.contact.force_constant = 0;
  values.sweep.strain = 1;
  const Outcome found = compute(values);
  const double aspect_ratio = 0.3e-3 / 19e-6;
  // Rods of a finite thickness also resist spin; that is of the order of 1/r².
  EXPECT_NEAR(found.table("fits").column("particle_number").front(), aspect_ratio * aspect_ratio / 2,
              0.02 * aspect_ratio * aspect_ratio / 2);
  EXPECT_GT(found.table("fits").column("stress_explained").front(), 0.99);
}

}  // namespace
}  // namespace fiberfate
