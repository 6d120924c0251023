// What the command line says about one run; what the case says is in the case.
#pragma once

#include <string>
#include <vector>

#include "app/progress.hpp"
#include "keys/case_file.hpp"
#include "results/run_types.hpp"
#include "studies/session.hpp"

namespace fiberfate {

struct RunOptions {
  std::string case_file;  ///< of `run`; empty when resuming
  std::string out;        ///< result folder; empty: named after the case file
  SessionOptions session;
  CaseChanges changes;
  std::vector<std::string> sweep = {};  ///< "key=value,value"; empty: one run
  ProgressKind progress = ProgressKind::automatic;
  Existing existing = Existing::refuse;
};

}  // namespace fiberfate
