// Reads Fibers.in, a Fortran namelist.
#include "app/legacy/namelist.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>

#include "io/legacy_text.hpp"

namespace fiberfate {
namespace {

/// Blanks comments and commas out, so that places in the text keep their lines.
std::string without_comments(std::string text) {
  bool comment = false;
  for (char& letter : text) {
    if (letter == '\n') comment = false;
    if (letter == '!') comment = true;
    if (comment || letter == ',' || letter == '\r' || letter == '\t') letter = ' ';
  }
  return text;
}

int line_at(const std::string& text, std::size_t place) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// Splits values at blanks and unfolds repeats.
std::vector<std::string> values_in(const std::string& text) {
  static const std::regex word(R"((?:(\d+)\*)?(\S+))");
  std::vector<std::string> values;
  for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match) {
    const int repeats = (*match)[1].matched ? std::stoi((*match)[1].str().substr(0, 4)) : 1;
    values.insert(values.end(), repeats, (*match)[2].str());
  }
  return values;
}

}  // namespace

LegacyNamelist::LegacyNamelist(const std::string& path) : path_(path) {
  const std::string text = without_comments(read_legacy_file(path));
  const std::size_t begin = lowered(text).find("&input");
  if (begin == std::string::npos)
    throw InputError(
        {legacy_problem(path, 1, "there is no namelist &input", "begin it with a line '&input'")});
  const std::size_t body_begin = begin + std::string("&input").size();
  const std::size_t body_end = text.find('/', body_begin);
  if (body_end == std::string::npos)
    throw InputError({legacy_problem(path, line_at(text, text.size()), "the namelist &input has no end",
                                     "the file is truncated: copy it again, or end it with a line '/'")});
  const std::string body = text.substr(body_begin, body_end - body_begin);
  static const std::regex head(R"(([A-Za-z_]\w*)\s*(?:\(\s*(\d+)\s*(?::\s*\d+\s*)?\))?\s*=)");
  std::size_t values_begin = 0;
  for (std::sregex_iterator match(body.begin(), body.end(), head), end; match != end; ++match) {
    const std::size_t place = match->position();
    if (!entries_.empty())
      entries_.back().values = values_in(body.substr(values_begin, place - values_begin));
    values_begin = place + match->length();
    const int index = (*match)[2].matched ? std::stoi((*match)[2].str().substr(0, 4)) : 0;
    entries_.push_back(
        {lowered((*match)[1].str()), (*match)[1].str(), index, {}, line_at(text, body_begin + place)});
  }
  if (!entries_.empty()) entries_.back().values = values_in(body.substr(values_begin));
}

const NamelistEntry* LegacyNamelist::find(const std::string& key) const {
  const std::string name = lowered(key);
  const auto found = std::find_if(entries_.rbegin(), entries_.rend(),
                                  [&name](const NamelistEntry& entry) { return entry.key == name; });
  return found == entries_.rend() ? nullptr : &*found;
}

InputProblem LegacyNamelist::problem(const std::string& key, const std::string& complaint,
                                     const std::string& remedy) const {
  InputProblem problem = legacy_problem(path_, 0, complaint, remedy);
  problem.key = key;
  if (const NamelistEntry* entry = find(key)) {
    problem.line = entry->line;
    problem.key = entry->written;
    problem.value = fmt::format("{}", fmt::join(entry->values, " "));
  }
  return problem;
}

double LegacyNamelist::number_of(const NamelistEntry& entry, std::size_t place) const {
  double number = 0;
  if (place < entry.values.size() && read_fortran_number(entry.values[place], number)) return number;
  throw InputError({problem(entry.key, "a number should stand here", "write one, 1.5d-6 or 1.5e-6")});
}

std::optional<double> LegacyNamelist::number(const std::string& key) const {
  const NamelistEntry* entry = find(key);
  if (entry == nullptr) return std::nullopt;
  return number_of(*entry, 0);
}

std::optional<bool> LegacyNamelist::truth(const std::string& key) const {
  const NamelistEntry* entry = find(key);
  if (entry == nullptr) return std::nullopt;
  bool truth = false;
  if (!entry->values.empty() && read_fortran_truth(entry->values.front(), truth)) return truth;
  throw InputError({problem(key, "a truth value should stand here", "write .true. or .false.")});
}

std::optional<std::vector<double>> LegacyNamelist::numbers(const std::string& key, std::size_t count) const {
  const std::string name = lowered(key);
  std::vector<std::optional<double>> found(count);
  for (const NamelistEntry& entry : entries_) {
    if (entry.key != name) continue;
    const std::size_t first = std::max(entry.index, 1) - 1;
    if (first + entry.values.size() > count)
      throw InputError({problem(key, fmt::format("it has only {} components", count), "remove the others")});
    for (std::size_t i = 0; i < entry.values.size(); ++i) found[first + i] = number_of(entry, i);
  }
  const std::size_t given =
      std::count_if(found.begin(), found.end(), [](const auto& one) { return one.has_value(); });
  if (given == 0) return std::nullopt;
  if (given < count)
    throw InputError(
        {problem(key, fmt::format("only {} of {} components are given", given, count), "give all")});
  std::vector<double> numbers;
  for (const auto& one : found) numbers.push_back(*one);
  return numbers;
}

}  // namespace fiberfate
