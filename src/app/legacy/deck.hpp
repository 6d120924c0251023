// Translates the input decks of the published program into a case of the study shear_cell.
#pragma once

#include <string>
#include <vector>

#include "results/legacy_positions.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {

/// What became of one legacy key.
struct LegacyNote {
  std::string key;
  std::string value;    ///< as written; empty when it is not given
  std::string outcome;  ///< "contact.friction = 0.2", or "not used: …"
};

/// A translated deck.
struct LegacyDeck {
  ShearCellCase values;
  std::vector<LegacyFiber> fibers;
  std::vector<LegacyNote> notes;  ///< one a legacy key, in the order of docs/formats/legacy.md
};

/// Reads Fibers.in, Initial_Positions.txt and, for flow case 1848, DynamicParameters.in of a folder. Raises
/// InputError with all that is wrong with the keys.
[[nodiscard]] LegacyDeck read_legacy_deck(const std::string& folder);

/// Lists the keys of Fibers.in that are known.
[[nodiscard]] std::vector<std::string> legacy_keys();

}  // namespace fiberfate
