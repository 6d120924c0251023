// Keeps rows of names and quantities.
#include "keys/text_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fiberfate {
namespace {

const Column coordinates = {"coordinate", {"m", "mm"}, Range::between(-1e3, 1e3)};

/// Reads the numbers behind the name of a row.
Reading<NamedNumbers> read_numbers(const std::vector<TomlValue>& row, const Column& column) {
  NamedNumbers named = {RowTexts(row).text(0), {}};
  for (std::size_t i = 1; i < row.size(); ++i) {
    const Reading<double> reading = read_quantity(row[i], column.units, column.range);
    if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
    named.numbers.push_back(std::get<double>(reading));
  }
  return named;
}

std::vector<std::string> write_numbers(const NamedNumbers& named, const Column& column, NumberStyle style) {
  std::vector<std::string> items = {write_text(named.name)};
  for (const double number : named.numbers) items.push_back(write_quantity(number, column.units, style));
  return items;
}

bool is_among(const std::vector<NamedNumbers>& all, const std::string& name) {
  return std::ranges::any_of(all, [&name](const NamedNumbers& one) { return one.name == name; });
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

RowForm<NamedPlace> place_rows(PlaceLines lines) {
  const auto read = [lines](const std::vector<TomlValue>& row,
                            const std::vector<NamedPlace>& before) -> Reading<NamedPlace> {
    const std::size_t numbers = row.size() - 1;
    const bool fits =
        numbers == 2 || numbers == 3 || (lines == PlaceLines::allowed && (numbers == 4 || numbers == 6));
    if (!fits || !std::holds_alternative<std::string>(row[0].data))
      return Complaint{"not a name with two or three coordinates",
                       "give x, y in the flat part or x, y, z in space; a line has two ends"};
    const std::string name = RowTexts(row).text(0);
    if (is_among(before, name))
      return Complaint{fmt::format("there are two places \"{}\"", name), "give each a name of its own"};
    return read_numbers(row, coordinates);
  };
  return {read, [](const NamedPlace& place, NumberStyle style) {
            return write_numbers(place, coordinates, style);
          }};
}

RowForm<NamedNumbers> number_rows(const char* owner, const Column& column, NumberCount count) {
  const auto read = [=](const std::vector<TomlValue>& row,
                        const std::vector<NamedNumbers>& before) -> Reading<NamedNumbers> {
    const std::string name = RowTexts(row).text(0);
    if (name.empty() || row.size() <= count.least || row.size() - 1 > count.most)
      return Complaint{count.fault, ""};
    if (is_among(before, name))
      return Complaint{fmt::format("{} \"{}\" has two rows", owner, name), "leave one of them out"};
    return read_numbers(row, column);
  };
  return {read, [column](const NamedNumbers& named, NumberStyle style) {
            return write_numbers(named, column, style);
          }};
}

}  // namespace fiberfate
