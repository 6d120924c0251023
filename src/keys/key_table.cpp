// Binds keys to members of a case struct: how each kind of value is read and written.
#include "keys/key_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "keys/orientation_value.hpp"
#include "keys/rows_value.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t most_repeated = 500;  ///< tables of one name: more are no case of anybody

using Complaints = std::vector<Complaint>;

Units units_of(const KeyNotes& notes) {
  return {notes.unit, notes.friendly};
}

/// Passes a reading on to `accept`, or collects its complaint.
template <class T, class Accept>
void take(const Reading<T>& reading, const TomlValue* item, Complaints& complaints, const Accept& accept) {
  if (const T* value = std::get_if<T>(&reading)) {
    accept(*value);
  } else {
    complaints.push_back(std::get<Complaint>(reading));
    complaints.back().at = item;
  }
}

/// Reads a list of quantities of one unit; the result is valid when there are no complaints.
std::vector<double> read_list(const std::vector<TomlValue>& items, const KeyNotes& notes,
                              Complaints& complaints) {
  std::vector<double> numbers;
  for (const TomlValue& item : items)
    take(read_quantity(item, units_of(notes), notes.range), &item, complaints,
         [&numbers](double number) { numbers.push_back(number); });
  return numbers;
}

std::string written_list(const double* begin, const double* end, const KeyNotes& notes, NumberStyle style) {
  std::vector<std::string> items;
  for (const double* number = begin; number != end; ++number)
    items.push_back(write_quantity(*number, units_of(notes), style));
  return write_list(items);
}

std::string names_of(const NamedTexts& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
    text += '"' + choices[i].name + '"';
  }
  return text;
}

Complaint wrong_choice(const TomlValue& value, const NamedTexts& choices) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr)
    return {fmt::format("{} is not one of the choices", value.kind()), "give " + names_of(choices)};
  std::vector<std::string> names;
  for (const NamedText& choice : choices) names.push_back(choice.name);
  const std::string nearest = nearest_word(*text, names);
  if (nearest.empty()) return {"not one of the choices", "give " + names_of(choices)};
  return {"not one of the choices",
          fmt::format("did you mean \"{}\"? The choices are {}", nearest, names_of(choices))};
}

Complaints read_vector(const TomlValue& value, std::optional<Vec3>& member, KeyTable::Cubic cubic,
                       const KeyNotes& notes) {
  Complaints complaints;
  const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
  if (items == nullptr && cubic == KeyTable::Cubic::allowed) {
    take(read_quantity(value, units_of(notes), notes.range), nullptr, complaints,
         [&member](double edge) { member = Vec3::Constant(edge); });
  } else if (items == nullptr || items->size() != 3) {
    complaints.push_back({items == nullptr ? fmt::format("{} is not a list of three", value.kind())
                                           : fmt::format("the list has {} values, not three", items->size()),
                          "give the x, y and z components, [x, y, z]"});
  } else {
    const std::vector<double> numbers = read_list(*items, notes, complaints);
    if (complaints.empty()) member = Vec3(numbers[0], numbers[1], numbers[2]);
  }
  return complaints;
}

}  // namespace

std::string without_numbers(const std::string& name) {
  std::string text;
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    if (part.find_first_not_of("0123456789") != std::string::npos) text += (text.empty() ? "" : ".") + part;
    begin = end + 1;
  }
  return text;
}

std::string table_heading(const std::string& section) {
  const std::string leaf = section.substr(section.rfind('.') + 1);
  const bool repeated = leaf.find_first_not_of("0123456789") == std::string::npos;
  const std::string heading = fmt::format("[{}]", without_numbers(section));
  return repeated ? fmt::format("[{}]", heading) : heading;
}

std::string Key::section() const {
  const auto dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string Key::leaf() const {
  const auto dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

const Key* KeyTable::find(const std::string& key) const {
  const auto found = places_.find(key);
  return found == places_.end() ? nullptr : &keys_[found->second];
}

bool KeyTable::is_repeated(const std::string& name) const {
  return std::find(repeated_.begin(), repeated_.end(), name) != repeated_.end();
}

std::vector<std::string> KeyTable::table_names() const {
  std::vector<std::string> names = repeated_;
  for (const Section& section : sections_)
    if (without_numbers(section.name) == section.name) names.push_back(section.name);
  return names;
}

std::size_t KeyTable::count_repeated(const std::string& name, std::size_t present) const {
  if (repeats_ == Repeats::one_to_show) return std::max<std::size_t>(1, present);
  if (document_ == nullptr) return present;
  std::size_t count = 0;
  while (document_->has_table(repeated_name(name, count))) ++count;
  if (count > most_repeated)
    throw InputError(fmt::format("[[{}]] stands {} times", name, count),
                     fmt::format("give it at most {} times", most_repeated));
  return count;
}

void KeyTable::section(std::string name, std::string text) {
  sections_.push_back({std::move(name), std::move(text)});
}

void KeyTable::add(Key key) {
  places_.emplace(key.name, keys_.size());
  keys_.push_back(std::move(key));
}

void KeyTable::quantity(const std::string& key, double& member, KeyNotes notes) {
  const auto read = [&member, notes](const TomlValue& value) {
    Complaints complaints;
    take(read_quantity(value, units_of(notes), notes.range), nullptr, complaints,
         [&member](double number) { member = number; });
    return complaints;
  };
  // One without a default has an example.
  const bool without_default = !notes.example.empty();
  const auto write = [&member, notes, without_default](NumberStyle style) {
    const bool unset = without_default && !notes.range.contains(member);
    return unset ? std::string() : write_quantity(member, units_of(notes), style);
  };
  add({key, notes, "quantity", {}, read, write});
}

void KeyTable::quantity(const std::string& key, std::optional<double>& member, KeyNotes notes) {
  const auto read = [&member, notes](const TomlValue& value) {
    Complaints complaints;
    take(read_quantity(value, units_of(notes), notes.range), nullptr, complaints,
         [&member](double number) { member = number; });
    return complaints;
  };
  const auto write = [&member, notes](NumberStyle style) {
    return member ? write_quantity(*member, units_of(notes), style) : std::string();
  };
  add({key, notes, "quantity", {}, read, write});
}

void KeyTable::quantities(const std::string& key, std::vector<double>& member, KeyNotes notes) {
  const auto read = [&member, notes](const TomlValue& value) {
    Complaints complaints;
    const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
    if (items == nullptr)
      return Complaints{
          {fmt::format("{} is not a list", value.kind()), "give the values in brackets, [a, b]"}};
    std::vector<double> numbers = read_list(*items, notes, complaints);
    if (complaints.empty()) member = std::move(numbers);
    return complaints;
  };
  const auto write = [&member, notes](NumberStyle style) {
    return member.empty() ? std::string()
                          : written_list(member.data(), member.data() + member.size(), notes, style);
  };
  add({key, notes, "list of quantities", {}, read, write});
}

void KeyTable::vector(const std::string& key, std::optional<Vec3>& member, Cubic cubic, KeyNotes notes) {
  const auto read = [&member, cubic, notes](const TomlValue& value) {
    return read_vector(value, member, cubic, notes);
  };
  const auto write = [&member, cubic, notes](NumberStyle style) {
    if (!member) return std::string();
    const bool equal = member->x() == member->y() && member->y() == member->z();
    if (cubic == Cubic::allowed && equal) return write_quantity(member->x(), units_of(notes), style);
    return written_list(member->data(), member->data() + 3, notes, style);
  };
  add({key, notes, cubic == Cubic::allowed ? "quantity or list of three" : "list of three", {}, read, write});
}

void KeyTable::rows(const std::string& key, std::vector<std::vector<double>>& member,
                    std::vector<Column> columns, KeyNotes notes) {
  const auto read = [&member, columns, folder = folder_](const TomlValue& value) {
    return read_rows(value, columns, folder, member);
  };
  const auto write = [&member, columns](NumberStyle style) { return write_rows(member, columns, style); };
  add({key, std::move(notes), "list of rows, or a file", {}, read, write});
}

void KeyTable::file(const std::string& key, std::string& member, KeyNotes notes) {
  const auto read = [&member, folder = folder_](const TomlValue& value) {
    const auto* path = std::get_if<std::string>(&value.data);
    if (path == nullptr || path->empty())
      return Complaints{{"not the path of a file", "give a path in quotes, relative to the case file"}};
    member = std::filesystem::absolute(std::filesystem::path(folder) / *path).lexically_normal().string();
    return Complaints{};
  };
  const auto write = [&member](NumberStyle) { return member.empty() ? std::string() : write_text(member); };
  add({key, std::move(notes), "file", {}, read, write});
}

void KeyTable::preset(const std::string& key, std::string& member, KeyNotes notes) {
  const auto read = [&member](const TomlValue& value) {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr || text->empty())
      return Complaints{
          {"not the name of a material", "give the name of a material or the path of its file"}};
    member = *text;
    return Complaints{};
  };
  const auto write = [&member](NumberStyle style) {
    return member.empty() || style == NumberStyle::si ? std::string() : write_text(member);
  };
  add({key, std::move(notes), "material", {}, read, write});
}

void KeyTable::orientation(const std::string& key, Mat3& member, KeyNotes notes) {
  const auto read = [&member](const TomlValue& value) {
    Complaints complaints;
    take(read_orientation(value), nullptr, complaints, [&member](const Mat3& tensor) { member = tensor; });
    return complaints;
  };
  const auto write = [&member](NumberStyle style) { return write_orientation(member, style); };
  add({key, std::move(notes), "orientation tensor", {}, read, write});
}

void KeyTable::add_count(const std::string& key, KeyNotes notes,
                         std::function<std::optional<std::int64_t>()> number,
                         std::function<void(std::int64_t)> set) {
  const auto read = [set = std::move(set), range = notes.range](const TomlValue& value) {
    const auto* whole = std::get_if<std::int64_t>(&value.data);
    const auto* real = std::get_if<double>(&value.data);
    const bool too_large = real != nullptr && std::isinf(*real);
    if (whole == nullptr && !too_large)
      return Complaints{{fmt::format("{} is not a whole number", value.kind()),
                         "give digits without quotes, point or unit"}};
    if (too_large || !range.contains(static_cast<double>(*whole)))
      return Complaints{{"out of range", "give " + describe_range(range, {})}};
    set(*whole);
    return Complaints{};
  };
  const auto write = [number = std::move(number)](NumberStyle) {
    const std::optional<std::int64_t> value = number();
    return value ? fmt::format("{}", *value) : std::string();
  };
  add({key, std::move(notes), "whole number", {}, read, write});
}

void KeyTable::add_choice(const std::string& key, KeyNotes notes, NamedTexts names,
                          std::function<std::size_t()> index, std::function<void(std::size_t)> set) {
  const auto read = [names, set = std::move(set)](const TomlValue& value) {
    const auto* text = std::get_if<std::string>(&value.data);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (text == nullptr || *text != names[i].name) continue;
      set(i);
      return Complaints{};
    }
    return Complaints{wrong_choice(value, names)};
  };
  const auto write = [names, index = std::move(index)](NumberStyle) {
    return write_text(names[index()].name);
  };
  add({key, std::move(notes), "choice", names, read, write});
}

}  // namespace fiberfate
