// Reads and writes keys that hold rows of quantities.
#include "keys/rows_value.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "io/number_file.hpp"

namespace fiberfate {
namespace {

using Rows = std::vector<std::vector<double>>;

std::string how_to_write(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  for (const Column& column : columns) names.push_back(column.name);
  if (columns.size() == 1)
    return fmt::format("give a list [{}, ...], or the path of a file with one a line in SI units", names[0]);
  return fmt::format("give rows [[{}], ...], or the path of a file of such rows in SI units",
                     fmt::join(names, ", "));
}

std::vector<Complaint> read_row(const TomlValue& value, const std::vector<Column>& columns, Rows& rows) {
  const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
  const std::vector<TomlValue> single = {value};
  if (items == nullptr && columns.size() == 1) items = &single;
  if (items == nullptr || items->size() != columns.size())
    return {{fmt::format("not a row of {} quantities", columns.size()), how_to_write(columns), &value}};
  std::vector<Complaint> complaints;
  std::vector<double> row;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Reading<double> reading = read_quantity((*items)[i], columns[i].units, columns[i].range);
    if (const double* number = std::get_if<double>(&reading)) {
      row.push_back(*number);
    } else {
      Complaint complaint = std::get<Complaint>(reading);
      const TomlValue* at = items == &single ? &value : &(*items)[i];
      complaints.push_back({columns[i].name + ": " + complaint.what, complaint.remedy, at});
    }
  }
  rows.push_back(std::move(row));
  return complaints;
}

std::vector<Complaint> read_file(const std::string& path, const std::vector<Column>& columns, Rows& rows) {
  std::vector<Complaint> complaints;
  try {
    for (NumberRow& row : read_number_file(path, columns.size())) {
      for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].range.contains(row.numbers[i])) continue;
        complaints.push_back(
            {fmt::format("{}:{}: {} = {} is out of range", path, row.line, columns[i].name, row.numbers[i]),
             "give " + describe_range(columns[i].range, {columns[i].units.si, ""})});
      }
      rows.push_back(std::move(row.numbers));
    }
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems()) complaints.push_back({problem.message(), ""});
  }
  return complaints;
}

}  // namespace

std::vector<Complaint> read_rows(const TomlValue& value, const std::vector<Column>& columns,
                                 const std::string& folder, Rows& rows) {
  Rows read;
  std::vector<Complaint> complaints;
  if (const auto* path = std::get_if<std::string>(&value.data)) {
    const auto whole = (std::filesystem::path(folder) / *path).lexically_normal();
    complaints = read_file(whole.string(), columns, read);
  } else if (const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
             items != nullptr && !items->empty()) {
    for (const TomlValue& item : *items)
      for (Complaint& complaint : read_row(item, columns, read)) complaints.push_back(std::move(complaint));
  } else {
    complaints.push_back(
        {fmt::format("{} does not hold rows", items == nullptr ? value.kind() : "an empty list"),
         how_to_write(columns)});
  }
  if (complaints.empty()) rows = std::move(read);
  return complaints;
}

std::string write_rows(const Rows& rows, const std::vector<Column>& columns, NumberStyle style) {
  if (rows.empty()) return "";
  std::vector<std::string> lines;
  for (const std::vector<double>& row : rows) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < row.size(); ++i)
      items.push_back(write_quantity(row[i], columns[i].units, style));
    lines.push_back(items.size() == 1 ? items[0] : write_list(items));
  }
  return fmt::format("[{}]", fmt::join(lines, ", "));
}

}  // namespace fiberfate
