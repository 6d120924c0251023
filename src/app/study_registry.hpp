// The studies that a case file can ask for; to add one is one line in study_registry.cpp.
#pragma once

#include <string>
#include <vector>

#include "keys/case_file.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Gives all studies.
[[nodiscard]] const std::vector<Study>& studies();
/// Finds a study by name; null when there is none.
[[nodiscard]] const Study* find_study(const std::string& name);
/// Lists the names of all studies.
[[nodiscard]] std::vector<std::string> study_names();
/// Lists the kinds of cases of all studies.
[[nodiscard]] CaseKinds case_kinds();
/// Gives the study of a case that was read with case_kinds().
[[nodiscard]] const Study& study_of(const LoadedCase& loaded);

}  // namespace fiberfate
