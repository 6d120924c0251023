// Keeps rows of names and quantities.
#include "keys/text_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fiberfate {
namespace {

const Units place_units = {"m", "mm"};

std::optional<Complaint> append_place(const std::vector<TomlValue>& row, PlaceLines lines,
                                      std::vector<NamedPlace>& places) {
  const std::size_t numbers = row.size() - 1;
  const bool fits =
      numbers == 2 || numbers == 3 || (lines == PlaceLines::allowed && (numbers == 4 || numbers == 6));
  if (row.empty() || !fits || !std::holds_alternative<std::string>(row[0].data))
    return Complaint{"not a name with two or three coordinates",
                     "give x, y in the flat part or x, y, z in space; a line has two ends"};
  NamedPlace place;
  place.name = std::get<std::string>(row[0].data);
  if (std::any_of(places.begin(), places.end(),
                  [&](const NamedPlace& one) { return one.name == place.name; }))
    return Complaint{fmt::format("there are two places \"{}\"", place.name), "give each a name of its own"};
  for (std::size_t i = 1; i < row.size(); ++i) {
    const Reading<double> reading = read_quantity(row[i], place_units, Range::between(-1e3, 1e3));
    if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
    place.numbers.push_back(std::get<double>(reading));
  }
  places.push_back(std::move(place));
  return std::nullopt;
}

std::vector<std::string> write_places(const std::vector<NamedPlace>& places, NumberStyle style) {
  std::vector<std::string> rows;
  for (const NamedPlace& place : places) {
    std::vector<std::string> items = {write_text(place.name)};
    for (const double number : place.numbers) items.push_back(write_quantity(number, place_units, style));
    rows.push_back(write_list(items));
  }
  return rows;
}

}  // namespace

std::string RowTexts::text(std::size_t item) const {
  const auto* text = std::get_if<std::string>(&row_.at(item).data);
  return text == nullptr ? row_[item].written : *text;
}

void describe_text_rows(KeyTable& table, const std::string& key, KeyNotes notes, RowKeeper keeper) {
  const auto read = [keeper, example = notes.example](const TomlValue& value) -> std::vector<Complaint> {
    const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
    if (items == nullptr)
      return {{fmt::format("{} does not hold rows", value.kind()), "give rows as " + example}};
    keeper.clear();
    std::vector<Complaint> complaints;
    for (const TomlValue& item : *items) {
      const auto* row = std::get_if<std::vector<TomlValue>>(&item.data);
      std::optional<Complaint> complaint = Complaint{"not a row", ""};
      if (row != nullptr && !row->empty()) complaint = keeper.append(*row);
      if (!complaint) continue;
      if (complaint->remedy.empty()) complaint->remedy = "give rows as " + example;
      complaint->at = &item;
      complaints.push_back(*complaint);
    }
    return complaints;
  };
  const auto write = [keeper](NumberStyle style) {
    const std::vector<std::string> rows = keeper.write(style);
    return rows.empty() ? std::string() : write_list(rows);
  };
  table.add({key, std::move(notes), "list of rows", {}, read, write});
}

void describe_places(KeyTable& table, const std::string& key, std::vector<NamedPlace>& places,
                     PlaceLines lines, KeyNotes notes) {
  describe_text_rows(
      table, key, std::move(notes),
      {[&places, lines](const std::vector<TomlValue>& row) { return append_place(row, lines, places); },
       [&places] { places.clear(); }, [&places](NumberStyle style) { return write_places(places, style); }});
}

}  // namespace fiberfate
