// Splits the text files of the published program into words that know their line.
#include "io/legacy_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

std::string lowered(std::string_view word) {
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool is_blank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == ',';
}

void append_words(std::string_view line, int number, std::vector<LegacyWord>& words) {
  line = line.substr(0, line.find('!'));
  while (!line.empty()) {
    const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
    const auto end = std::find_if(begin, line.end(), is_blank);
    if (begin != end) words.push_back({std::string(begin, end), number});
    line.remove_prefix(end - line.begin());
  }
}

}  // namespace

InputProblem legacy_problem(const std::string& path, int line, std::string complaint, std::string remedy) {
  return {path, line, 0, "", "", std::move(complaint), std::move(remedy)};
}

std::string read_legacy_file(const std::string& path) {
  try {
    return read_file(path);
  } catch (const StorageError& error) {
    throw InputError(error.what(), "give the folder or file of the published program's input");
  }
}

bool read_fortran_number(std::string_view word, double& number) {
  std::string text = lowered(word);
  std::replace(text.begin(), text.end(), 'd', 'e');
  const char* begin = text.c_str() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.c_str() + text.size();
  const auto [rest, status] = std::from_chars(begin, end, number);
  return status == std::errc() && rest == end && std::isfinite(number);
}

bool read_fortran_truth(std::string_view word, bool& truth) {
  const std::string text = lowered(word);
  truth = text == "t" || text == ".t." || text == ".true." || text == "true";
  return truth || text == "f" || text == ".f." || text == ".false." || text == "false";
}

LegacyNumbers::LegacyNumbers(const std::string& path) : path_(path) {
  const std::string text = read_legacy_file(path);
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    append_words(line, ++last_line_, words_);
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  }
}

const LegacyWord& LegacyNumbers::next(const std::string& meaning) {
  if (place_ == words_.size())
    throw InputError({legacy_problem(path_, last_line_, "the file ends where " + meaning + " should stand",
                                     "the file is truncated: copy it again")});
  return words_[place_++];
}

double LegacyNumbers::number(const std::string& meaning) {
  const LegacyWord& word = next(meaning);
  double number = 0;
  if (!read_fortran_number(word.text, number))
    throw InputError({legacy_problem(
        path_, word.line, fmt::format("'{}' is not a number; {} should stand here", word.text, meaning),
        "correct the line")});
  return number;
}

std::int64_t LegacyNumbers::count(const std::string& meaning) {
  const double value = number(meaning);
  if (value < 0 || value > 1e9 || value != std::floor(value))
    throw InputError({legacy_problem(
        path_, words_[place_ - 1].line,
        fmt::format("'{}' is not a count; {} should stand here", words_[place_ - 1].text, meaning),
        "correct the line")});
  return static_cast<std::int64_t>(value);
}

bool LegacyNumbers::truth(const std::string& meaning) {
  const LegacyWord& word = next(meaning);
  bool truth = false;
  double number = 0;
  if (read_fortran_truth(word.text, truth)) return truth;
  if (read_fortran_number(word.text, number)) return number != 0;
  throw InputError({legacy_problem(
      path_, word.line, fmt::format("'{}' is neither T nor F; {} should stand here", word.text, meaning),
      "correct the line")});
}

void LegacyNumbers::expect_end() const {
  if (place_ == words_.size()) return;
  throw InputError({legacy_problem(
      path_, words_[place_].line,
      fmt::format("'{}' stands after the last row that the file announces", words_[place_].text),
      "correct the count in its first line, or remove the rest")});
}

}  // namespace fiberfate
