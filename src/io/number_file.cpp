// Reads plain text files of numbers in rows.
#include "io/number_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include "base/error.hpp"

namespace fiberfate {
namespace {

std::vector<std::string> split(const std::string& line) {
  constexpr const char* separators = " \t\r,;";
  const std::string text = line.substr(0, line.find('#'));
  std::vector<std::string> words;
  for (std::size_t begin = text.find_first_not_of(separators); begin != std::string::npos;) {
    const std::size_t end = text.find_first_of(separators, begin);
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return words;
}

std::optional<double> number_of(const std::string& word) {
  double number = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = status == std::errc() && end == word.data() + word.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string row_of(std::size_t columns) {
  return columns == 1 ? "one number" : fmt::format("a row of {} numbers", columns);
}

/// Tells what is wrong with a row.
std::string fault_of(const std::vector<std::string>& words, std::size_t columns) {
  const auto odd = std::find_if_not(words.begin(), words.end(),
                                    [](const std::string& word) { return number_of(word).has_value(); });
  if (words.size() == columns && odd != words.end()) return fmt::format("'{}' is not a finite number", *odd);
  return fmt::format("not {}", row_of(columns));
}

}  // namespace

std::vector<std::vector<double>> read_number_file(const std::string& path, std::size_t columns) {
  if (std::filesystem::is_directory(path))
    throw InputError({{path, 0, 0, "", "", "is a folder, not a file", "give the file in it"}});
  std::ifstream file(path);
  if (!file)
    throw InputError(
        {{path, 0, 0, "", "", fmt::format("cannot be read ({})", std::strerror(errno)), "check the path"}});
  std::vector<std::vector<double>> rows;
  std::vector<InputProblem> problems;
  int line_number = 0;
  bool heading_allowed = true;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    const std::vector<std::string> words = split(line);
    if (words.empty()) continue;
    const bool heading = heading_allowed && !number_of(words.front());
    heading_allowed = false;
    if (heading) continue;
    std::vector<double> row;
    for (const std::string& word : words)
      if (const auto number = number_of(word)) row.push_back(*number);
    if (row.size() == columns && words.size() == columns)
      rows.push_back(std::move(row));
    else
      problems.push_back({path, line_number, 0, "", "", fault_of(words, columns),
                          "separate numbers by spaces or commas, with a decimal point"});
  }
  if (rows.empty() && problems.empty())
    problems.push_back(
        {path, 0, 0, "", "", "holds no numbers", fmt::format("give {} a line", row_of(columns))});
  if (!problems.empty()) throw InputError(std::move(problems));
  return rows;
}

}  // namespace fiberfate
