// Puts the facts about a key into words.
#include "keys/key_facts.hpp"

#include <fmt/format.h>

namespace fiberfate {

KeyFacts key_facts(const Key& key) {
  const KeyNotes& notes = key.notes;
  KeyFacts facts;
  facts.kind = key.kind;
  if (notes.unit != "1" || !notes.friendly.empty()) {
    facts.unit = notes.unit == "1" ? std::string("a pure number") : notes.unit;
    if (!notes.friendly.empty()) facts.unit += fmt::format(", usually {}", notes.friendly);
  }
  facts.standard = key.write(NumberStyle::friendly);
  if (facts.standard.empty()) facts.standard = notes.need == Need::required ? "none: required" : "none";
  const std::string range = describe_range(notes.range, {notes.unit, notes.friendly});
  if (range != "any number") facts.range = range;
  if (!notes.example.empty()) facts.example = fmt::format("{} = {}", key.leaf(), notes.example);
  facts.source = notes.source;
  return facts;
}

}  // namespace fiberfate
