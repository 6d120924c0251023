// Collects what is wrong between the keys of a case.
#include "keys/case_checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "io/input_file.hpp"

#include "keys/key_table.hpp"

namespace fiberfate {
namespace {

constexpr std::ptrdiff_t most_told = 100;  // faults of one key

/// Finds the list that a key holds; null when it is not given or holds something else.
const std::vector<TomlValue>* rows_of(const TomlDocument& document, const std::string& key) {
  const TomlEntry* entry = document.find(key);
  return entry == nullptr ? nullptr : std::get_if<std::vector<TomlValue>>(&entry->value.data);
}

bool begins_with(std::string_view name, const TomlValue& row) {
  const auto* items = std::get_if<std::vector<TomlValue>>(&row.data);
  if (items == nullptr || items->empty()) return false;
  const auto* first = std::get_if<std::string>(&items->front().data);
  return first != nullptr && *first == name;
}

}  // namespace

InputProblem problem_at_key(const TomlDocument& document, const std::string& key) {
  if (const TomlEntry* entry = document.find(key)) return problem_at(*entry);
  InputProblem problem;
  problem.file = document.name();
  problem.key = key;
  for (const TomlTable& table : document.tables()) {
    if (key != table.name + key.substr(std::min(key.size(), key.rfind('.')))) continue;
    problem.file = table.place.file;
    problem.line = table.place.line;
    problem.column = table.place.column;
  }
  return problem;
}

InputProblem CaseChecker::problem(const std::string& key, const std::string& complaint,
                                  const std::string& remedy) const {
  InputProblem problem = problem_at_key(document_, key);
  problem.complaint = complaint;
  problem.remedy = remedy;
  return problem;
}

void CaseChecker::add(InputProblem found) {
  const auto same_key = [&found](const InputProblem& one) { return one.key == found.key; };
  const auto same = [&found](const InputProblem& one) { return one.message() == found.message(); };
  if (std::any_of(errors_.begin(), errors_.begin() + static_cast<std::ptrdiff_t>(unread_), same_key) ||
      std::any_of(errors_.begin(), errors_.end(), same) ||
      std::count_if(errors_.begin(), errors_.end(), same_key) >= most_told)
    return;
  errors_.push_back(std::move(found));
}

void CaseChecker::report_inside(const std::string& key, const InputProblem& found) {
  if (!found.file.empty()) {
    InputProblem kept = found;
    if (kept.key.empty()) kept.key = key;
    return add(std::move(kept));
  }
  if (found.key.empty()) return error(key, found.complaint, found.remedy);
  const std::string inside = key + '.' + found.key;
  if (is_given(inside)) return error(inside, found.complaint, found.remedy);
  error(key, found.key + (found.value.empty() ? "" : " = " + found.value) + ": " + found.complaint,
        found.remedy);
}

void CaseChecker::error(const std::string& key, const std::string& complaint, const std::string& remedy) {
  add(problem(key, complaint, remedy));
}

void CaseChecker::error_in_row(const std::string& key, std::size_t row, const std::string& complaint,
                               const std::string& remedy) {
  InputProblem found = problem(key, complaint, remedy);
  const std::vector<TomlValue>* rows = rows_of(document_, key);
  if (rows != nullptr && row < rows->size()) {
    found.line = (*rows)[row].place.line;
    found.column = (*rows)[row].place.column;
    found.value = (*rows)[row].written;
  }
  add(std::move(found));
}

void CaseChecker::error_in_row(const std::string& key, std::string_view name, const std::string& complaint,
                               const std::string& remedy) {
  const std::vector<TomlValue>* rows = rows_of(document_, key);
  std::size_t row = 0;
  while (rows != nullptr && row < rows->size() && !begins_with(name, (*rows)[row])) ++row;
  error_in_row(key, row, complaint, remedy);
}

void CaseChecker::require(const std::string& key, const std::string& why, const std::string& example) {
  if (is_given(key)) return;
  const auto dot = key.rfind('.');
  error(key, "not given; " + why,
        fmt::format("add {} = {} under {}", key.substr(dot + 1), example, table_heading(key.substr(0, dot))));
}

void CaseChecker::warn(const std::string& key, const std::string& complaint, const std::string& remedy) {
  warnings_.push_back(problem(key, complaint, remedy));
}

void CaseChecker::warn_unused(const std::vector<std::string>& keys, const std::string& reader) {
  if (is_given("version")) return;
  for (const std::string& key : keys)
    if (is_given(key)) warn(key, "has no effect", "it is read by " + reader + " only");
}

void CaseChecker::check_with(const std::vector<TomlEntry>& entries,
                             const std::function<void(CaseChecker&)>& work) {
  TomlDocument changed = document_;
  for (const TomlEntry& entry : entries) changed.replace(entry);
  CaseChecker inside(changed, errors_, named_files_);
  inside.unread_ = unread_;
  work(inside);
  errors_ = inside.errors_;
  for (const InputProblem& found : inside.warnings_) {
    const auto same = [&found](const InputProblem& one) { return one.message() == found.message(); };
    if (std::none_of(warnings_.begin(), warnings_.end(), same)) warnings_.push_back(found);
  }
}

bool CaseChecker::is_sound(const std::string& key) const {
  return std::none_of(errors_.begin(), errors_.end(),
                      [&key](const InputProblem& one) { return one.key == key; });
}

std::string CaseChecker::cite(const std::string& key) const {
  const TomlEntry* entry = document_.find(key);
  if (entry == nullptr) return key;
  const InputPlace& place = entry->value.place;
  const std::string where = place.line > 0 ? fmt::format("line {}", place.line) : place.file;
  return fmt::format("{} = {} ({})", key, entry->value.written, where);
}

void CaseChecker::check_file(const std::string& key, const std::string& path) {
  if (named_files_ == NamedFiles::may_be_gone || path.empty()) return;
  const std::string fault = reading_fault(path);
  if (fault.empty()) return;
  std::error_code reason;
  const bool missing = !std::filesystem::exists(path, reason) && !reason;
  error(key, missing ? "there is no such file" : fault, fmt::format("check the path; it means '{}'", path));
}

}  // namespace fiberfate
