// A case of the study cluster: fibers packed with a wanted orientation and relaxed.
#pragma once

#include "keys/case_checker.hpp"
#include "studies/run_choices.hpp"
#include "studies/sample/case.hpp"
#include "studies/sample/relaxation.hpp"
#include "studies/study.hpp"

namespace fiberfate {

struct ClusterCase {
  SampleCase sample;
  BoundaryChoices boundary;
  ContactParameters contact;  ///< under which the packing comes to rest, and relaxes
  RelaxationChoices relaxation;
  RunChoices run;  ///< seed and threads
};

void describe_cluster(KeyTable& table, ClusterCase& values);
void validate_cluster(const ClusterCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_cluster(const ClusterCase& values);

}  // namespace fiberfate
