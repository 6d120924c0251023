// Describes, checks and estimates a case of the study cluster.
#include "studies/cluster/case.hpp"

#include "fibers/contact_laws/contact_registry.hpp"
#include "keys/law_keys.hpp"
#include "studies/sample/estimate.hpp"

namespace fiberfate {
namespace {

// Measured on the packings of 620 to 1000 fibers of 25 rods that docs/theory/packing.md lists.
constexpr double packing_seconds_a_rod = 1e-3;

}  // namespace

void describe_cluster(KeyTable& table, ClusterCase& values) {
  const Choices<Boundary> ends = {{Boundary::periodic, "periodic", "the cell repeats"},
                                  {Boundary::walls, "walls", "solid walls at y = 0 and at the far side"}};
  const KeyGroup<RunChoices> run = {
      "run", "With which random numbers, on how many threads.", {seed_key(), threads_key()}};
  const KeyGroup<BoundaryChoices> boundary = {
      "boundary",
      "How the cell ends.",
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

CaseEstimate estimate_cluster(const ClusterCase& values) {
  const auto plan = plan_sample(values.sample, values.run.seed);
  CaseEstimate estimate = estimate_sample(values.sample, plan);
  if (plan) estimate.wall_seconds = packing_seconds_a_rod * static_cast<double>(plan->rods);
  estimate.assumption = "1 ms a rod, one thread";
  return estimate;
}

}  // namespace fiberfate
