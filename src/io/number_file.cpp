// Reads plain text files of numbers in rows.
#include "io/number_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "io/decimal_column.hpp"
#include "io/input_file.hpp"
#include "io/text_faults.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t most_told = 100;  // lines at fault

/// Splits a line into its words, which are views of it.
std::vector<std::string_view> split(std::string_view line) {
  const bool semicolons = line.find(';') != std::string_view::npos;
  const char* separators = semicolons ? " \t\r;" : " \t\r,";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

std::optional<double> number_of(std::string_view word, std::string_view line) {
  std::string fault;
  const bool semicolons = line.find(';') != std::string_view::npos;
  return DecimalColumn(semicolons ? ';' : ',').read(word, fault);
}

std::string row_of(std::size_t columns) {
  return columns == 1 ? "one number" : fmt::format("a row of {} numbers", columns);
}

/// What is wrong with a row, and at which of its bytes; nothing where nothing is.
struct RowFault {
  std::string complaint;
  std::size_t place = 0;
};

std::optional<RowFault> fault_of(std::string_view line, std::size_t columns) {
  const std::vector<std::string_view> words = split(line);
  const auto odd = std::find_if_not(words.begin(), words.end(), [line](std::string_view word) {
    return number_of(word, line).has_value();
  });
  const auto place_of = [line](std::string_view word) -> std::size_t { return word.data() - line.data(); };
  if (odd != words.end())
    return RowFault{fmt::format("'{}' is not a finite number", shortened(*odd)), place_of(*odd)};
  if (words.size() == columns) return std::nullopt;
  const bool commas = words.size() == 2 * columns && line.find(',') != std::string_view::npos;
  return RowFault{fmt::format("not {}{}", row_of(columns), commas ? "; are they decimal commas?" : ""),
                  place_of(words[std::min(words.size() - 1, columns)])};
}

}  // namespace

std::vector<NumberRow> read_number_file(const std::string& path, std::size_t columns) {
  const std::string text = read_input_file(path);
  if (const auto fault = text_fault(text, path)) throw InputError({*fault});
  std::vector<NumberRow> rows;
  std::vector<InputProblem> problems;
  int line_number = 0;
  bool heading_allowed = true;
  for (std::string_view rest = without_byte_order_mark(text); !rest.empty();) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    ++line_number;
    line = line.substr(0, line.find('#'));
    const std::vector<std::string_view> words = split(line);
    if (words.empty()) continue;
    const bool heading = heading_allowed && !number_of(words.front(), line);
    heading_allowed = false;
    if (heading) continue;
    if (const auto fault = fault_of(line, columns)) {
      problems.push_back({path, line_number, static_cast<int>(fault->place) + 1, "", "", fault->complaint,
                          "separate numbers by spaces or commas, with a decimal point"});
      if (problems.size() == most_told) break;
      continue;
    }
    rows.push_back({line_number, {}});
    for (const std::string_view word : words) rows.back().numbers.push_back(*number_of(word, line));
  }
  if (rows.empty() && problems.empty())
    problems.push_back(
        {path, 1, 1, "", "", "holds no numbers", fmt::format("give {} a line", row_of(columns))});
  if (!problems.empty()) throw InputError(std::move(problems));
  return rows;
}

}  // namespace fiberfate
