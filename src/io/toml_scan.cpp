// Counts brackets, dots and lengths of TOML texts.
#include "io/toml_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fiberfate {
namespace {

constexpr std::size_t deepest = 64;
constexpr std::size_t longest_table = 1 << 15;  // bytes of a table in braces
constexpr std::size_t long_line = 512;          // bytes after which a list goes on in another line

/// Goes through a text and keeps count of what is open.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  TomlScan scan() {
    while (at_ < text_.size() && !found_.fault) {
      if (is_quote(text_[at_])) {
        skip_text();
      } else if (text_[at_] == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        count(text_[at_]);
        look();
        ++at_;
      }
    }
    return std::move(found_);
  }

 private:
  struct Bracket {
    char letter;
    std::size_t place;
  };

  static bool is_quote(char letter) { return letter == '"' || letter == '\''; }

  void count(char letter) {
    if (letter == '.') ++dots_;
    if (letter == '[' || letter == '{') open_.push_back({letter, at_});
    if ((letter == ']' || letter == '}') && !open_.empty()) open_.pop_back();
    if (letter == '\n') end_line();
    if (std::string_view("\n=,[]{}").find(letter) != std::string_view::npos) dots_ = 0;
    const bool in_list = !open_.empty() && open_.back().letter == '[';
    if (letter == ',' && in_list && at_ > broken_at_ + long_line) {
      broken_at_ = at_ + 1;
      found_.breaks.push_back(broken_at_);
    }
  }

  void end_line() {
    ++line_;
    line_begin_ = broken_at_ = at_ + 1;
    // A table in braces ends with its line; one that does not is for the library to find.
    while (!open_.empty() && open_.back().letter == '{') open_.pop_back();
  }

  void look() {
    if (open_.size() > deepest)
      refuse(fmt::format("lists or tables are nested more than {} deep", deepest),
             "this is no case file; a bracket may be missing");
    else if (dots_ >= deepest)
      refuse(fmt::format("a key has more than {} parts", deepest), "this is no key of a case");
    else if (!open_.empty() && open_.back().letter == '{' && at_ - open_.back().place > longest_table)
      refuse(fmt::format("a table in braces is longer than {} bytes", longest_table),
             "write it as a [table] with a line for each key");
  }

  void refuse(std::string complaint, std::string remedy) {
    found_.fault = {name_,
                    line_,
                    static_cast<int>(at_ - line_begin_) + 1,
                    "",
                    "",
                    std::move(complaint),
                    std::move(remedy)};
  }

  /// Goes behind a text in quotes; one that does not end is for the library to find.
  void skip_text() {
    const std::string quote(1, text_[at_]);
    const bool many_lines = text_.substr(at_).starts_with(quote + quote + quote);
    const std::string end = many_lines ? quote + quote + quote : quote;
    for (at_ += end.size(); at_ < text_.size(); ++at_) {
      if (text_.substr(at_).starts_with(end)) break;
      if (text_[at_] == '\n' && !many_lines) return;
      if (text_[at_] == '\n') {
        ++line_;
        line_begin_ = at_ + 1;
      }
      const bool escapes = text_[at_] == '\\' && quote == "\"";
      if (escapes && !text_.substr(at_ + 1).starts_with('\n')) ++at_;
    }
    at_ = std::min(at_ + end.size(), text_.size());
  }

  std::string_view text_;
  const std::string& name_;
  TomlScan found_;
  std::vector<Bracket> open_;
  std::size_t at_ = 0, line_begin_ = 0, broken_at_ = 0;
  std::size_t dots_ = 0;
  int line_ = 1;
};

}  // namespace

TomlScan scan_toml(std::string_view text, const std::string& name) {
  return Scanner(text, name).scan();
}

BrokenText::BrokenText(std::string_view text, std::vector<std::size_t> breaks) : breaks_(std::move(breaks)) {
  text_.reserve(text.size() + breaks_.size());
  std::size_t begin = 0;
  for (const std::size_t place : breaks_) {
    text_ += text.substr(begin, place - begin);
    text_ += '\n';
    begin = place;
  }
  text_ += text.substr(begin);
}

std::size_t BrokenText::original(std::size_t offset) const {
  // The k-th break, counted from 0, stands k bytes further on than in the given text.
  std::size_t before = 0, after = breaks_.size();
  while (before < after) {
    const std::size_t middle = (before + after) / 2;
    if (breaks_[middle] + middle < offset)
      before = middle + 1;
    else
      after = middle;
  }
  return offset - before;
}

}  // namespace fiberfate
