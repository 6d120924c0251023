// Parts texts into words.
#include "io/word_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t longest_word = 60;  // in messages

}  // namespace

WordReader::WordReader(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {
  find_word(text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
}

void WordReader::find_word(std::size_t from) {
  begin_ = std::min(text_.find_first_not_of(blanks, from), text_.size());
  end_ = std::min(text_.find_first_of(blanks, begin_), text_.size());
  for (; from < begin_; ++from) {
    if (text_[from] != '\n') continue;
    ++line_;
    line_begin_ = from + 1;
  }
  word_ = text_.substr(begin_, end_ - begin_);
  std::transform(word_.begin(), word_.end(), word_.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
}

void WordReader::next() {
  last_end_ = end_;
  find_word(end_);
}

void WordReader::skip_line() {
  // What stands in the line of the word that was taken last, which may be nothing.
  const std::size_t line_end = std::min(text_.find('\n', last_end_), text_.size());
  if (begin_ < line_end) find_word(line_end);
}

double WordReader::number() {
  double value = 0;
  const char* first = word_.data() + (word_.starts_with('+') ? 1 : 0);
  const char* last = word_.data() + word_.size();
  const auto [rest, status] = std::from_chars(first, last, value);
  if (status != std::errc() || rest != last || !std::isfinite(value))
    refuse(word_.find(',') != std::string::npos ? "a decimal comma" : "not a finite number",
           "write numbers with a decimal point");
  next();
  return value;
}

void WordReader::refuse(const std::string& complaint, const std::string& remedy) const {
  const int column = static_cast<int>(begin_ - line_begin_) + 1;
  const std::string cited = at_end() ? "the file ends" : fmt::format("'{}'", word_.substr(0, longest_word));
  throw InputError({{path_, line_, column, "", "", fmt::format("{}: {}", cited, complaint), remedy}});
}

}  // namespace fiberfate
