// The materials that come with the program: parts of case files that stand for the keys a case leaves
// out.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/toml_document.hpp"
#include "keys/key_table.hpp"

namespace fiberfate {

/// One file of materials/.
struct MaterialPreset {
  std::string_view name;  ///< "ppgf30"
  std::string_view text;
};

/// All materials of the program, by name.
[[nodiscard]] std::span<const MaterialPreset> material_presets();

/// Adds to a document the entries of the material that its preset key names, a name of the program's or a
/// path. What the document gives itself stays; where it chooses another law in a table ([melt] name, say),
/// none of that table's keys is taken. Raises InputError when there is no such material or file.
void add_preset(const KeyTable& table, TomlDocument& document);

}  // namespace fiberfate
