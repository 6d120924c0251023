// Holds a case of the study cluster: fibers packed with a wanted orientation and relaxed.
#pragma once

#include <cstdint>

#include "app/case_checker.hpp"
#include "app/key_table.hpp"
#include "app/studies/relaxation.hpp"
#include "app/studies/sample_case.hpp"
#include "app/study.hpp"

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
