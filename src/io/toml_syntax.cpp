// Finds out from the TOML library's message what the user most likely meant.
#include "io/toml_syntax.hpp"

#include <fmt/format.h>

#include <array>
#include <regex>
#include <sstream>

namespace fiberfate {
namespace {

struct Place {
  int line = 0;
  int column = 0;
};

/// Reads the places that the message points at: lines " 12 | text" each followed by "    |   ^--- remark".
std::vector<Place> cited_places(const std::string& message) {
  static const std::regex numbered(R"(^\s*(\d+) \| ?.*$)");
  std::vector<Place> places;
  std::istringstream text(message);
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_match(line, match, numbered)) {
      places.push_back({std::stoi(match[1]), 0});
    } else if (!places.empty() && places.back().column == 0) {
      const auto bar = line.find("| ");
      const auto mark = line.find_first_of("^~", bar);
      if (bar != std::string::npos && mark != std::string::npos)
        places.back().column = static_cast<int>(mark - bar) - 1;
    }
  }
  return places;
}

/// Explains a duplicate, which the library reports with both of its places.
void explain_duplicate(InputProblem& problem, const std::string& message, const std::vector<Place>& places) {
  static const std::regex name(R"re(\("([^"]*)"\))re");
  std::smatch match;
  const std::string key = std::regex_search(message, match, name) ? match[1].str() : "a key";
  const bool table = message.find(": table (") != std::string::npos;
  problem.complaint = fmt::format("{} is given twice, first in line {}", table ? '[' + key + ']' : key,
                                  places.empty() ? 0 : places.front().line);
  problem.remedy = table ? "put all its keys under one heading" : "keep one of the two";
}

/// Explains a key that lacks its value; tells whether it was one.
bool explain_missing_value(InputProblem& problem, const std::string& line) {
  static const std::regex bare(R"(^\s*([A-Za-z0-9_.\-]+)\s*=\s*(#.*)?$)");
  std::smatch match;
  if (!std::regex_match(line, match, bare)) return false;
  problem.key = match[1];
  problem.complaint = "has no value";
  problem.remedy = "write one behind '=', or put # before the line";
  return true;
}

/// Explains a value that lacks its quotes, the commonest slip; tells whether it was one.
bool explain_missing_quotes(InputProblem& problem, const std::string& line) {
  static const std::regex unquoted(
      R"(^\s*([A-Za-z0-9_.\-]+)\s*=\s*([^"'\[\]{}#=]*[^"'\[\]{}#=\s])\s*(#.*)?$)");
  static const std::regex incomplete(R"(^[+\-]?(\.\d+|\d+\.)$)");
  static const std::regex decimal_comma(R"(^[+\-]?\d+,\d+(\s.*)?$)");
  std::smatch match;
  if (!std::regex_match(line, match, unquoted) || std::regex_match(match[2].str(), incomplete)) return false;
  const std::string key = match[1], value = match[2];
  problem.column = static_cast<int>(match.position(2)) + 1;
  problem.key = key;
  problem.value = value;
  if (std::regex_match(value, decimal_comma)) {
    std::string number = value;
    number.replace(number.find(','), 1, ".");
    const bool bare = number.find(' ') == std::string::npos;
    problem.complaint = "a number has a decimal comma";
    problem.remedy =
        bare ? fmt::format("write {} = {}", key, number) : fmt::format("write {} = \"{}\"", key, number);
  } else {
    problem.complaint = "the value is not in quotes";
    problem.remedy = fmt::format("write {} = \"{}\"", key, value);
  }
  return true;
}

struct Advice {
  const char* fragment;  ///< of the library's message
  const char* complaint;
  const char* remedy;
};

constexpr std::array advices = {
    Advice{"utf8", "the file holds bytes that are not UTF-8", "save it as UTF-8 text"},
    Advice{"parse_basic_string", "a text does not end, or holds an unknown escape",
           "close it with \" in the same line, and write \\\\ for a backslash"},
    Advice{"parse_literal_string", "a text does not end", "close it with ' in the same line"},
    Advice{"parse_ml_", "a text of many lines does not end", "close it with three quotes"},
    Advice{"parse_array", "a list does not end, or lacks a comma",
           "separate its values by commas and close it with ]"},
    Advice{"parse_inline_table", "a table in braces does not end, or lacks a comma",
           "separate its keys by commas and close it with } in the same line"},
    Advice{"missing key-value separator", "a line has no '='", "write key = value"},
    Advice{"empty key", "a key is missing before '='", "write key = value"},
    Advice{"parse_key", "this is not a key or a [table]",
           "use letters, digits, _ and -, and close a table with ]"},
    Advice{"bad float", "a number is incomplete", "write digits on both sides of the point, 0.5 or 5.0"},
    Advice{"expected newline", "something follows the value", "put one key = value in a line"},
};

void explain_by_fragment(InputProblem& problem, const std::string& message) {
  for (const Advice& advice : advices) {
    if (message.find(advice.fragment) == std::string::npos) continue;
    problem.complaint = advice.complaint;
    problem.remedy = advice.remedy;
    return;
  }
  problem.complaint = "this is not TOML";
  problem.remedy = "write key = value under [table] headings, values with units in quotes";
}

}  // namespace

InputProblem syntax_problem(const std::string& library_message, const std::string& file,
                            const std::vector<std::string>& lines) {
  const std::vector<Place> places = cited_places(library_message);
  InputProblem problem;
  problem.file = file;
  if (!places.empty()) {
    problem.line = places.back().line;
    problem.column = places.back().column;
  }
  if (library_message.find("already exists") != std::string::npos) {
    explain_duplicate(problem, library_message, places);
    return problem;
  }
  // A list or text that does not end is noticed at the end of the file; where it begins helps more.
  const bool open_ended = library_message.find("parse_array") != std::string::npos;
  if (open_ended && !places.empty()) {
    problem.line = places.front().line;
    problem.column = places.front().column;
  }
  const auto index = static_cast<std::size_t>(problem.line) - 1;
  if (problem.line > 0 && index < lines.size() && !open_ended &&
      (explain_missing_value(problem, lines[index]) || explain_missing_quotes(problem, lines[index])))
    return problem;
  explain_by_fragment(problem, library_message);
  return problem;
}

}  // namespace fiberfate
