// Describes, checks and estimates a case of the study cluster.
#include "studies/cluster/case.hpp"

#include <utility>

#include "fibers/contact_laws/contact_registry.hpp"
#include "keys/law_keys.hpp"
#include "results/memory_recorder.hpp"
#include "studies/pace.hpp"
#include "studies/sample/crowd.hpp"
#include "studies/sample/estimate.hpp"
#include "studies/sample/start.hpp"

namespace fiberfate {
void describe_cluster(KeyTable& table, ClusterCase& values) {
  const Choices<Boundary> ends = {{Boundary::periodic, "periodic", "the cell repeats"},
                                  {Boundary::walls, "walls", "solid walls at y = 0 and at the far side"}};
  const KeyGroup<RunChoices> run = {
      "run", "With which random numbers, on how many threads.", {seed_key(), threads_key()}};
  const KeyGroup<BoundaryChoices> boundary = {
      "boundary",
      "What bounds the cell.",
      {key("y", &BoundaryChoices::y, ends, "How the cell ends along y; in x and z it is periodic.")}};
  const KeyGroup<ContactParameters> contact = {
      "contact", "The contact law under which the packing comes to rest: the one that will be run.",
      contact_law_rows()};
  describe(table, run, values.run);
  describe_sample(table, values.sample);
  describe(table, boundary, values.boundary);
  describe(table, contact, values.contact);
  describe_relaxation(table, values.relaxation);
}

void validate_cluster(const ClusterCase& values, CaseChecker& checker) {
  validate_sample(values.sample, checker);
  warn_of_unread_constants("contact.law", contact_laws(), values.contact.law, checker);
  validate_relaxation(values.relaxation, checker);
  if (!checker.is_sound("cluster.source")) return;
  const ClusterSource source = values.sample.cluster.source;
  if (source == ClusterSource::fiber)
    checker.error("cluster.source", "a single fiber is no cluster", "use study = \"shear_cell\"");
  if (source == ClusterSource::file && !values.relaxation.duration)
    checker.error("cluster.source", "nothing would be done to the fibers that are read",
                  "add duration under [relaxation], or let the cluster be generated");
}

namespace {

/// Relaxation makes steps of about this length, s; measured on the case 09.
constexpr double relaxation_step = 1e-4;

double expected_seconds(const ClusterCase& values, const std::optional<SamplePlan>& plan) {
  MemoryRecorder recorder;
  Session session(recorder);
  session.use_threads(values.run.threads);
  const double relaxation_steps = values.relaxation.duration.value_or(0) / relaxation_step;
  if (plan) {
    const double rod_step = seconds_a_rod_step(values.sample, values.contact, values.run.seed);
    return packing_seconds(values.sample, {values.contact, values.boundary.y, values.run.seed}, *plan,
                           rod_step) +
           relaxation_steps * static_cast<double>(plan->rods) * rod_step;
  }
  FiberState fibers =
      make_fibers(values.sample, {values.contact, values.boundary.y, values.run.seed}, session).state;
  const auto rods = static_cast<double>(fibers.rod_count());
  return relaxation_steps * rods * seconds_a_rod_step(std::move(fibers), values.contact);
}

}  // namespace

CaseEstimate estimate_cluster(const ClusterCase& values) {
  const auto plan = plan_sample(values.sample, values.run.seed);
  CaseEstimate estimate = estimate_sample(values.sample, plan);
  foretell(
      estimate, [&] { return expected_seconds(values, plan); }, "from a trial on this machine");
  return estimate;
}

}  // namespace fiberfate
