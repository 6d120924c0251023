// Reads and writes keys that hold texts.
#include "keys/text_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

/// Reads a list of texts; numbers in it are kept as they are written.
std::optional<Texts> texts_of(const TomlValue& value) {
  const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
  if (items == nullptr) return std::nullopt;
  Texts texts;
  for (const TomlValue& item : *items) {
    if (std::holds_alternative<std::vector<TomlValue>>(item.data)) return std::nullopt;
    const auto* text = std::get_if<std::string>(&item.data);
    texts.push_back(text == nullptr ? item.written : *text);
  }
  return texts;
}

std::string written(const Texts& texts) {
  Texts items;
  for (const std::string& text : texts) items.push_back(write_text(text));
  return write_list(items);
}

}  // namespace

void describe_name(KeyTable& table, const std::string& key, std::string& member, NamedTexts choices,
                   KeyNotes notes) {
  const auto read = [&member, choices](const TomlValue& value) -> std::vector<Complaint> {
    const auto* text = std::get_if<std::string>(&value.data);
    std::vector<std::string> names;
    for (const NamedText& choice : choices) names.push_back(choice.name);
    if (text != nullptr && std::find(names.begin(), names.end(), *text) != names.end()) {
      member = *text;
      return {};
    }
    const std::string near = text == nullptr ? std::string() : nearest_word(*text, names);
    const std::string all = fmt::format("{}", fmt::join(names, ", "));
    return {{"not one of the choices",
             near.empty() ? "give one of " + all
                          : fmt::format("did you mean \"{}\"? The choices are {}", near, all)}};
  };
  const auto write = [&member](NumberStyle) { return member.empty() ? std::string() : write_text(member); };
  table.add({key, std::move(notes), "choice", std::move(choices), read, write});
}

NamedTexts closure_names() {
  NamedTexts names;
  for (const ClosureDescription& one : closures()) names.push_back({one.name, one.meaning, one.source});
  return names;
}

void describe_text(KeyTable& table, const std::string& key, std::string& member, const std::string& kind,
                   KeyNotes notes) {
  const auto read = [&member, kind](const TomlValue& value) -> std::vector<Complaint> {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr || text->empty())
      return {{fmt::format("not the name of a {}", kind), "give a name in quotes"}};
    member = *text;
    return {};
  };
  const auto write = [&member](NumberStyle) { return member.empty() ? std::string() : write_text(member); };
  table.add({key, std::move(notes), kind, {}, read, write});
}

void describe_texts(KeyTable& table, const std::string& key, Texts& member, KeyNotes notes) {
  const auto read = [&member](const TomlValue& value) -> std::vector<Complaint> {
    const std::optional<Texts> texts = texts_of(value);
    if (!texts) return {{"not a list of names", "give names in quotes, [\"a\", \"b\"]"}};
    member = *texts;
    return {};
  };
  const auto write = [&member](NumberStyle) { return member.empty() ? std::string() : written(member); };
  table.add({key, std::move(notes), "list of names", {}, read, write});
}

void describe_text_rows(KeyTable& table, const std::string& key, std::vector<Texts>& member, int path_column,
                        KeyNotes notes) {
  const auto read = [&member, path_column, folder = table.folder(),
                     example = notes.example](const TomlValue& value) -> std::vector<Complaint> {
    const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
    std::vector<Texts> rows;
    for (std::size_t i = 0; items != nullptr && i < items->size(); ++i) {
      std::optional<Texts> row = texts_of((*items)[i]);
      if (!row || row->size() < 3)
        return {{"not a row of at least three entries", "give rows as " + example, &(*items)[i]}};
      if (path_column >= 0 && (*row)[path_column].ends_with(".csv"))
        (*row)[path_column] = std::filesystem::absolute(std::filesystem::path(folder) / (*row)[path_column])
                                  .lexically_normal()
                                  .string();
      rows.push_back(*row);
    }
    if (items == nullptr)
      return {{fmt::format("{} does not hold rows", value.kind()), "give rows as " + example}};
    member = rows;
    return {};
  };
  const auto write = [&member](NumberStyle) {
    Texts rows;
    for (const Texts& row : member) rows.push_back(written(row));
    return rows.empty() ? std::string() : write_list(rows);
  };
  table.add({key, std::move(notes), "list of rows", {}, read, write});
}

}  // namespace fiberfate
