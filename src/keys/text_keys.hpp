// Adds keys that hold texts: a name, a list of names, rows of texts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "keys/key_table.hpp"

namespace fiberfate {

using Texts = std::vector<std::string>;

/// Adds a key that holds one of several names. An empty name is "not given".
void describe_name(KeyTable& table, const std::string& key, std::string& member, NamedTexts choices,
                   KeyNotes notes);
/// The closures of A4 with their meanings, for such a key.
[[nodiscard]] NamedTexts closure_names();

/// Adds a key that holds one text; `kind` says for explanations what it is ("name", "column"). An empty text
/// is "not given".
void describe_text(KeyTable& table, const std::string& key, std::string& member, const std::string& kind,
                   KeyNotes notes);

/// Adds a key that holds a list of texts.
void describe_texts(KeyTable& table, const std::string& key, Texts& member, KeyNotes notes);

/// Adds a key that holds rows of at least three texts; entries of `path_column` that end in .csv are paths
/// and kept absolute (none: -1).
void describe_text_rows(KeyTable& table, const std::string& key, std::vector<Texts>& member, int path_column,
                        KeyNotes notes);

}  // namespace fiberfate
