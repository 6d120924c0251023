// Holds a case of the study cluster: fibers packed with a wanted orientation and relaxed.
#pragma once

#include <cstdint>

#include "keys/case_checker.hpp"
#include "keys/key_table.hpp"
#include "studies/sample/case.hpp"
#include "studies/sample/relaxation.hpp"
#include "studies/study.hpp"

namespace fiberfate {

struct ClusterCase {
  SampleCase sample;
  Boundary boundary_y = Boundary::periodic;
  ContactParameters contact;  ///< under which the packing comes to rest, and relaxes
  RelaxationChoices relaxation;
  std::uint64_t seed = 1;  ///< run.seed
  int threads = 0;         ///< run.threads; 0: all that the machine has
};

void describe_cluster(KeyTable& table, ClusterCase& values);
void validate_cluster(const ClusterCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_cluster(const ClusterCase& values);

}  // namespace fiberfate
