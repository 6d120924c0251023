// Finds materials and adds them to case files.
#include "keys/material_presets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"

namespace fiberfate {
namespace {

TomlDocument read_preset(const TomlEntry& entry, const std::string& wanted, const std::string& folder) {
  std::vector<std::string> names;
  for (const MaterialPreset& preset : material_presets()) {
    if (preset.name == wanted)
      return TomlDocument::parse(std::string(preset.text), fmt::format("material {}", wanted));
    names.emplace_back(preset.name);
  }
  const auto path = (std::filesystem::path(folder) / wanted).lexically_normal();
  if (std::filesystem::exists(path)) return TomlDocument::read(path.string());
  InputProblem problem = problem_at(entry);
  const std::string nearest = nearest_word(wanted, names);
  problem.complaint = "there is neither a material of this name nor such a file";
  problem.remedy = nearest.empty() ? fmt::format("the materials are {}", fmt::join(names, ", "))
                                   : fmt::format("did you mean \"{}\"?", nearest);
  throw InputError({problem});
}

/// Whether the document chooses another law than the preset in the table of a key.
bool chooses_otherwise(const TomlDocument& document, const TomlDocument& preset, const std::string& key) {
  const std::string choice = key.substr(0, key.rfind('.')) + ".name";
  const TomlEntry* own = document.find(choice);
  const TomlEntry* other = preset.find(choice);
  return own != nullptr && other != nullptr && own->value.data.index() == other->value.data.index() &&
         own->value.written != other->value.written;
}

}  // namespace

void add_preset(const KeyTable& table, TomlDocument& document) {
  for (const Key& key : table.keys()) {
    if (key.kind != "material") continue;
    const TomlEntry* entry = document.find(key.name);
    const auto* wanted = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value.data);
    if (wanted == nullptr || wanted->empty()) continue;
    const TomlDocument preset = read_preset(*entry, *wanted, table.folder());
    std::vector<TomlEntry> taken;
    for (const TomlEntry& one : preset.entries())
      if (document.find(one.key) == nullptr && !chooses_otherwise(document, preset, one.key))
        taken.push_back(one);
    document.add(std::move(taken));
    return;
  }
}

}  // namespace fiberfate
