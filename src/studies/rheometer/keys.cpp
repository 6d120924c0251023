// The keys of the study rheometer.
#include "studies/rheometer/case.hpp"

namespace fiberfate {
namespace {

constexpr double longest_duration = 1e6;  // s

KeyGroup<RheometerSweep> sweep_keys() {
  using Sweep = RheometerSweep;
  return {
      "sweep",
      "What differs between the points; all combinations of the lists are run, and one list at least is "
      "given.",
      {
          texts_key("flows", &Sweep::flows, "Types of flow, in place of flow.type.",
                    optional("[\"shear\", \"planar\", \"uniaxial\"]")),
          key("volume_fractions", &Sweep::volume_fractions, {"1", "%"}, {0, 0.907, Range::Ends::open_low},
              "Volume fractions, in place of fibers.volume_fraction.", optional("[\"2 %\", \"5 %\"]")),
          key("lengths", &Sweep::lengths, {"m", "mm"}, Range::positive(1),
              "Lengths of the fibers, in place of fibers.length.", optional("[\"0.5 mm\", \"1 mm\"]")),
          key("rates", &Sweep::rates, {"1/s"}, Range::between(-1e7, 1e7), "Rates, in place of flow.rate.",
              usual("[\"1 1/s\", \"10 1/s\", \"100 1/s\"]")),
          key("replicas", &Sweep::replicas, {}, Range::between(1, 1000),
              "Packings of each point, made with the seeds run.seed, run.seed + 1, …; points with the same "
              "fibers and type of flow start from the same packings."),
          key("strain", &Sweep::strain, {}, Range::positive(1e6),
              "Strain, rate times time, after which each point ends, in place of run.duration, so that "
              "slow flows come as far as fast ones.",
              usual("20")),
      }};
}

KeyGroup<OutputChoices> output_keys() {
  using Output = OutputChoices;
  return {
      "output",
      "What is averaged, and how often runs are saved. Means and errors are those of the rows that a cell "
      "would write.",
      joined<Output>({rows_of_base<Output, SeriesChoices>(series_rows()), checkpoint_rows(), stress_rows()})};
}

}  // namespace

void describe_rheometer(KeyTable& table, RheometerCase& values) {
  ShearCellCase& cell = values.cell;
  const KeyGroup<RunChoices> run = {
      "run",
      "How long, with which random numbers, on how many threads.",
      {duration_key(longest_duration, "Simulated time of each point, unless sweep.strain is given.",
                    optional("\"2 s\"")),
       seed_key(), threads_key()}};
  const KeyGroup<FlowChoices> flow = {
      "flow", flow_text,
      joined<FlowChoices>({{flow_type_row()}, constant_flow_rows(optional("\"16.65 1/s\""))})};
  describe(table, run, cell.run);
  describe(table, sweep_keys(), values.sweep);
  describe_sample(table, cell.sample);
  describe(table, flow, cell.flow);
  describe_dynamics(table, cell.dynamics);
  describe(table, output_keys(), cell.output);
}

}  // namespace fiberfate
