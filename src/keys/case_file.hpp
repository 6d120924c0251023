// Reads case files: finds the study, reads every key, checks the whole, and writes cases back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "keys/case_kind.hpp"

namespace fiberfate {

/// What the command line changes about a case file, in the order in which it is applied.
struct CaseChanges {
  std::vector<std::string> variants;   ///< tables of the variants.toml beside the case file
  std::vector<std::string> overrides;  ///< "key=value"
};

/// A case that has been read and found valid.
struct LoadedCase {
  const CaseKind* kind = nullptr;
  CaseValues values;                  ///< the study's case struct
  std::string path;                   ///< of the file, as given
  std::vector<std::string> warnings;  ///< what is odd but admissible, formatted like errors
};

/// Reads a case file, with variants and assignments from the command line on top. A variant NAME is the
/// table [NAME] of the variants.toml beside the case: quoted keys with the values to take instead.
/// Raises InputError with all problems of the file at once.
[[nodiscard]] LoadedCase load_case(const std::string& path, const CaseKinds& kinds,
                                   const CaseChanges& changes = {});

/// Reads the case.resolved.toml of a result folder. Files that it names need not exist any more: what was in
/// them is in the checkpoint.
[[nodiscard]] LoadedCase load_resolved_case(const std::string& path, const CaseKinds& kinds);

/// Reads a case from a text that messages call `name`; its relative paths start at the working directory.
[[nodiscard]] LoadedCase parse_case(const std::string& text, const std::string& name, const CaseKinds& kinds,
                                    const std::vector<std::string>& overrides = {});

/// Writes every key of a case, defaults included, bare in SI, and the program's version: reading it back
/// gives the same bits (case.resolved.toml).
[[nodiscard]] std::string resolved_case(const CaseKind& kind, const CaseValues& values);

/// Writes an annotated case file in friendly units, with every key explained; keys at their default or not
/// given are commented out.
[[nodiscard]] std::string annotated_case(const CaseKind& kind, const CaseValues& values);

/// Writes the same of no case in particular: examples stand for the keys that a case must or usually does
/// give, so that the template can be run as it is wherever a study has such examples (`fiberfate new`).
[[nodiscard]] std::string case_template(const CaseKind& kind);

}  // namespace fiberfate
