// Reads tables of numbers that other programs write.
#include "io/delimited_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "base/trimmed.hpp"
#include "base/units.hpp"
#include "io/decimal_column.hpp"
#include "io/input_file.hpp"
#include "io/text_faults.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t most_listed = 20;  // faults of one column that are told
constexpr const char* comma_remedy =
    "write decimal points, or separate the columns by semicolons, where decimal commas are understood";

/// Writes Latin-1, in which older spreadsheets save, as UTF-8.
std::string utf8_of_latin1(std::string_view text) {
  std::string utf8;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x80) {
      utf8 += letter;
    } else {
      utf8 += static_cast<char>(0xC0 | (code >> 6));
      utf8 += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return utf8;
}

/// Gives the text with one kind of line end and in one encoding.
std::string as_plain_text(std::string bytes, const std::string& path) {
  std::string text(without_byte_order_mark(bytes));
  for (std::size_t i = text.find('\r'); i != std::string::npos; i = text.find('\r', i + 1))
    text[i] = text.compare(i, 2, "\r\n") == 0 ? ' ' : '\n';  // bytes stay where they are
  auto fault = text_fault(text, path);
  if (fault && fault->complaint.find("UTF-8") != std::string::npos) {
    text = utf8_of_latin1(text);
    fault = text_fault(text, path);
  }
  if (fault) throw InputError({*fault});
  return text;
}

/// Takes the quotes off a cell.
std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || !cell.starts_with('"') || !cell.ends_with('"')) return cell;
  return trimmed(cell.substr(1, cell.size() - 2));
}

bool is_whole_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char letter) { return letter >= '0' && letter <= '9'; });
}

/// Whether a heading is a unit of length and nothing else: "mm" in "Length, mm".
bool is_length_unit(std::string heading) {
  if (const std::string inside = unit_in_heading(heading); !inside.empty()) heading = inside;
  static constexpr std::array units = {"nm", "um", "µm", "μm", "mm", "cm", "m", "inch"};
  return std::find(units.begin(), units.end(), heading) != units.end();
}

}  // namespace

std::string unit_in_heading(const std::string& heading) {
  const auto open = heading.find_last_of("[(");
  if (open == std::string::npos || heading.size() < open + 3) return "";
  const char close = heading[open] == '[' ? ']' : ')';
  if (heading.back() != close) return "";
  return std::string(trimmed(std::string_view(heading).substr(open + 1, heading.size() - open - 2)));
}

std::string heading_without_unit(const std::string& heading) {
  const std::string unit = unit_in_heading(heading);
  return unit.empty() ? heading : std::string(trimmed(heading.substr(0, heading.find_last_of("[("))));
}

std::optional<double> factor_of_unit(const std::string& unit, const std::string& si_unit) {
  if (unit.empty()) return std::nullopt;
  try {
    return unit_factor(unit, si_unit);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

DelimitedTable::DelimitedTable(const std::string& path)
    : path_(path), text_(std::make_unique<const std::string>(as_plain_text(read_input_file(path), path))) {
  split_lines();
  if (headings_.empty())
    throw InputError({{path_, 0, 0, "", "", "holds no rows", "give rows of numbers under a line of names"}});
  refuse_split_decimals();
}

void DelimitedTable::split_lines() {
  std::size_t waiting = 0;  // empty lines, which count where a row follows
  for (Line line{0, 1}; line.begin < text_->size(); ++line.number) {
    const std::size_t end = std::min(text_->find('\n', line.begin), text_->size());
    const std::string_view content = std::string_view(*text_).substr(line.begin, end - line.begin);
    const bool chooses = headings_.empty() && content.starts_with("sep=") && content.size() > 4;
    if (chooses) {
      separator_ = content[4];
    } else if (trimmed(content).empty()) {
      waiting += headings_.empty() ? 0 : 1;
    } else if (!content.starts_with('#')) {
      if (headings_.empty() && separator_ == '\0') choose_separator(content);
      const std::vector<std::string_view> cells = cells_of(content, line.number);
      const bool empty = std::all_of(cells.begin(), cells.end(), [](auto cell) { return cell.empty(); });
      if (headings_.empty()) {
        take_headings(cells, line);
      } else if (empty) {
        ++waiting;
      } else {
        take_row(cells, line);
        empty_lines_ += std::exchange(waiting, 0);
      }
    }
    line.begin = end + 1;
  }
}

void DelimitedTable::choose_separator(std::string_view line) {
  for (const char separator : {';', '\t', ','}) {
    if (line.find(separator) == std::string_view::npos) continue;
    separator_ = separator;
    return;
  }
  separator_ = ' ';
  for (const std::string_view word : cells_of(line, 0))
    if (!plain_number(word)) separator_ = '\0';
}

std::vector<std::string_view> DelimitedTable::cells_of(std::string_view line, int number) const {
  std::vector<std::string_view> cells;
  if (separator_ == '\0') return {unquoted(line)};
  const bool blanks = separator_ == ' ';
  std::string_view rest = blanks ? trimmed(line) : line;
  while (true) {
    const std::size_t first = std::min(rest.find_first_not_of(" \t"), rest.size());
    const bool quoted = rest.substr(first).starts_with('"');
    const std::size_t closed = quoted ? rest.find('"', first + 1) : 0;
    if (closed == std::string_view::npos)
      throw InputError({{path_, number, static_cast<int>(rest.data() + first - line.data()) + 1, "", "",
                         "a quote does not end in its line", "close it, or remove it"}});
    const std::size_t end = blanks ? rest.find_first_of(" \t", closed) : rest.find(separator_, closed);
    cells.push_back(unquoted(rest.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    rest.remove_prefix(end + 1);
    if (blanks) rest = trimmed(rest);
  }
}

int DelimitedTable::column_of(std::string_view cell, const Line& line) const {
  return static_cast<int>(cell.data() - text_->data() - static_cast<std::ptrdiff_t>(line.begin)) + 1;
}

void DelimitedTable::take_headings(const std::vector<std::string_view>& cells, const Line& line) {
  const bool numbers = std::all_of(cells.begin(), cells.end(), [this](std::string_view cell) {
    DecimalColumn column(separator_);
    std::string fault;
    return column.read(cell, fault).has_value() || fault.find("decimal comma") != std::string::npos;
  });
  for (std::size_t i = 0; i < cells.size(); ++i)
    headings_.push_back(numbers ? std::to_string(i + 1) : std::string(cells[i]));
  if (numbers) take_row(cells, line);
}

void DelimitedTable::take_row(const std::vector<std::string_view>& cells, const Line& line) {
  std::size_t count = cells.size();
  while (count > columns() && cells[count - 1].empty()) --count;  // instruments end lines with a separator
  if (count != columns()) {
    const bool comma = separator_ == ',' && count == 2 * columns();
    throw InputError({{path_, line.number, column_of(cells[std::min(count, columns()) - 1], line), "", "",
                       fmt::format("{} values for {} columns{}", count, columns(),
                                   comma ? "; are they decimal commas?" : ""),
                       comma ? comma_remedy : "give one value a column"}});
  }
  cells_.insert(cells_.end(), cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(count));
  lines_.push_back(line);
}

/// Whether a column and the next hold the two parts of numbers that commas have split: whole numbers,
/// and digits under the name of a unit or with zeros in front.
bool DelimitedTable::looks_split(std::size_t column) const {
  bool zeros = false;
  for (std::size_t row = 0; row < rows(); ++row) {
    const std::string_view whole = cell(row, column), part = cell(row, column + 1);
    if (!is_whole_number(whole) || !is_whole_number(part) || part.starts_with('-')) return false;
    zeros |= part.size() > 1 && part.starts_with('0');
  }
  return rows() > 0 && (zeros || is_length_unit(headings_[column + 1]));
}

void DelimitedTable::refuse_split_decimals() const {
  if (separator_ != ',') return;
  for (std::size_t i = 0; i + 1 < columns(); ++i)
    if (looks_split(i))
      throw InputError({{path_, lines_[0].number, column_of(cell(0, i), lines_[0]), "", "",
                         fmt::format("'{},{}' looks like a number with a decimal comma in a table of commas",
                                     cell(0, i), cell(0, i + 1)),
                         comma_remedy}});
}

std::string DelimitedTable::listed_headings() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns(); ++i)
    names.push_back(headings_[i].empty() ? fmt::format("column {} without a name", i + 1)
                                         : fmt::format("'{}'", headings_[i]));
  return fmt::format("{}", fmt::join(names, ", "));
}

bool DelimitedTable::has_column(const std::string& name) const {
  return std::find(headings_.begin(), headings_.end(), name) != headings_.end();
}

std::size_t DelimitedTable::column_named(const std::string& name) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < columns(); ++i)
    if (headings_[i] == name) found.push_back(i);
  for (std::size_t i = 0; i < columns() && found.empty(); ++i)
    if (heading_without_unit(headings_[i]) == name) found.push_back(i);
  if (found.size() == 1) return found.front();
  const std::string near = nearest_word(name, headings_);
  throw InputError(
      {{path_, 1, 1, "", "",
        fmt::format("there {} '{}'", found.empty() ? "is no column" : "are several columns", name),
        fmt::format("{}its columns are {}",
                    near.empty() || !found.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                    listed_headings())}});
}

std::vector<double> DelimitedTable::numbers(std::size_t column) const {
  std::vector<double> values;
  std::vector<InputProblem> problems;
  DecimalColumn reader(separator_);
  for (std::size_t row = 0; row < rows() && problems.size() < most_listed; ++row) {
    std::string fault;
    const std::string_view text = cell(row, column);
    if (const std::optional<double> number = reader.read(text, fault)) {
      values.push_back(*number);
      continue;
    }
    const bool comma = fault.find("decimal comma") != std::string::npos;
    problems.push_back({path_, lines_[row].number, column_of(text, lines_[row]), "", "", fault,
                        comma ? comma_remedy : "give a number with a decimal point"});
  }
  if (problems.empty() && reader.is_ambiguous())
    problems.push_back({path_, lines_[0].number, column_of(cell(0, column), lines_[0]), "", "",
                        fmt::format("'{}' may have a decimal comma or be in thousands", cell(0, column)),
                        "write decimal points"});
  if (!problems.empty()) throw InputError(std::move(problems));
  return values;
}

}  // namespace fiberfate
