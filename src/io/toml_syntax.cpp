// Finds out from the TOML library's message what the user most likely meant.
#include "io/toml_syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>

#include "io/text_faults.hpp"
#include "io/text_places.hpp"

namespace fiberfate {
namespace {

using Place = TextPlace;

// Lines may be very long and are searched by hand: std::regex calls itself for every letter.

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes the letters of a set off the beginning of a text.
template <class Set>
std::string_view take_while(std::string_view& text, const Set& belongs) {
  const auto end = std::find_if_not(text.begin(), text.end(), belongs);
  const std::string_view taken = text.substr(0, end - text.begin());
  text.remove_prefix(taken.size());
  return taken;
}

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

bool is_key_letter(char letter) {
  return is_digit(letter) || (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         letter == '_' || letter == '-' || letter == '.';
}

/// Reads the number in front of a line " 12 | text" of the message; 0 where there is none.
int cited_line(std::string_view line) {
  line = line.substr(std::min(line.find_first_not_of(' '), line.size()));
  const std::string_view digits = take_while(line, is_digit);
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return line.starts_with(" |") ? number : 0;
}

/// Reads the places that the message points at: lines " 12 | text" each followed by "    |   ^--- remark".
std::vector<Place> cited_places(const std::string& message) {
  std::vector<Place> places;
  std::istringstream text(message);
  for (std::string line; std::getline(text, line);) {
    if (const int number = cited_line(line); number > 0) {
      places.push_back({number, 0});
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
  const auto begin = message.find("(\"");
  const auto end = message.find("\")", begin);
  const bool named = begin != std::string::npos && end != std::string::npos;
  const std::string key = named ? message.substr(begin + 2, end - begin - 2) : "a key";
  const bool table = message.find(": table (") != std::string::npos;
  problem.complaint = fmt::format("{} is given twice, first in line {}", table ? '[' + key + ']' : key,
                                  places.empty() ? 0 : places.front().line);
  problem.remedy = table ? "put all its keys under one heading" : "keep one of the two";
}

/// A line "key = value # remark" without its remark.
struct Assignment {
  std::string key;
  std::string value;
  int column = 0;  ///< of the value
};

std::optional<Assignment> assignment_in(const std::string& line) {
  std::string_view rest = std::string_view(line).substr(0, line.find('#'));
  const auto is_blank = [](char letter) { return letter == ' ' || letter == '\t'; };
  take_while(rest, is_blank);
  const std::string_view key = take_while(rest, is_key_letter);
  take_while(rest, is_blank);
  if (key.empty() || !rest.starts_with('=')) return std::nullopt;
  rest.remove_prefix(1);
  take_while(rest, is_blank);
  return Assignment{std::string(key), std::string(trimmed(rest)),
                    static_cast<int>(rest.data() - line.data()) + 1};
}

/// Whether a number lacks the digits on one side of its point.
bool is_incomplete(std::string_view value) {
  if (value.starts_with('+') || value.starts_with('-')) value.remove_prefix(1);
  const auto point = value.find('.');
  const std::string_view before = value.substr(0, point);
  const std::string_view after = point == std::string_view::npos ? "" : value.substr(point + 1);
  return point != std::string_view::npos && before.empty() != after.empty() &&
         std::all_of(before.begin(), before.end(), is_digit) &&
         std::all_of(after.begin(), after.end(), is_digit);
}

/// Whether a value begins with a number such as 1,5.
bool has_decimal_comma(std::string_view value) {
  if (value.starts_with('+') || value.starts_with('-')) value.remove_prefix(1);
  const bool before = !take_while(value, is_digit).empty();
  if (!before || !value.starts_with(',')) return false;
  value.remove_prefix(1);
  const bool after = !take_while(value, is_digit).empty();
  return after && (value.empty() || value.front() == ' ' || value.front() == '\t');
}

/// Explains a key that lacks its value; tells whether it was one.
bool explain_missing_value(InputProblem& problem, const Assignment& line) {
  if (!line.value.empty()) return false;
  problem.key = line.key;
  problem.complaint = "has no value";
  problem.remedy = "write one behind '=', or put # before the line";
  return true;
}

/// Explains a value that lacks its quotes, the commonest slip; tells whether it was one.
bool explain_missing_quotes(InputProblem& problem, const Assignment& line) {
  const bool plain = line.value.find_first_of("\"'[]{}=") == std::string::npos;
  if (!plain || is_incomplete(line.value)) return false;
  problem.column = line.column;
  problem.key = line.key;
  problem.value = shortened(line.value);
  if (has_decimal_comma(line.value)) {
    std::string number = line.value;
    number.replace(number.find(','), 1, ".");
    const char* quote = number.find(' ') == std::string::npos ? "" : "\"";
    problem.complaint = "a number has a decimal comma";
    problem.remedy = fmt::format("write {} = {}{}{}", line.key, quote, shortened(number), quote);
  } else {
    problem.complaint = "the value is not in quotes";
    problem.remedy = fmt::format("write {} = \"{}\"", line.key, problem.value);
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

/// Finds places of the text that the library read in the one that the user wrote.
std::vector<Place> places_as_written(std::vector<Place> places, const TomlTexts& texts) {
  const TextPlaces read(texts.read.text()), written(texts.written);
  for (Place& place : places) place = written.at(texts.read.original(read.offset_of(place)));
  return places;
}

std::string line_of(const std::string& text, int line) {
  const std::size_t begin = TextPlaces(text).offset_of({line, 1});
  return text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
}

}  // namespace

InputProblem syntax_problem(const std::string& library_message, const std::string& file,
                            const TomlTexts& texts) {
  const std::vector<Place> places = places_as_written(cited_places(library_message), texts);
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
  if (problem.line > 0 && !open_ended) {
    const std::optional<Assignment> line = assignment_in(line_of(texts.written, problem.line));
    if (line && (explain_missing_value(problem, *line) || explain_missing_quotes(problem, *line)))
      return problem;
  }
  explain_by_fragment(problem, library_message);
  return problem;
}

}  // namespace fiberfate
