// Lists a chosen law and its parameters for a report.
#pragma once

#include <string>
#include <vector>

#include "keys/law_choice.hpp"
#include "results/report_document.hpp"

namespace fiberfate {

/// Lists the chosen law and its parameters; nothing where no law is chosen.
[[nodiscard]] std::vector<Fact> law_facts(const LawMenu& menu, const std::string& label,
                                          const LawChoice& choice);

}  // namespace fiberfate
