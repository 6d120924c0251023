// Collects what is wrong between the keys of a case, each with the place where it was written.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "io/toml_document.hpp"

namespace fiberfate {

/// Whether files that a case names must exist: yes for a new run, no for one that is resumed.
enum class NamedFiles { must_exist, may_be_gone };

/// Starts a problem at a key; where the key is not given, at the heading of its table, or at the file.
[[nodiscard]] InputProblem problem_at_key(const TomlDocument& document, const std::string& key);

/// Serves a study's validate(): it reports problems by key and looks up places by itself.
class CaseChecker {
 public:
  /// Takes the document with the errors found so far in reading it.
  CaseChecker(const TomlDocument& document, std::vector<InputProblem> errors, NamedFiles named_files)
      : document_(document), errors_(std::move(errors)), unread_(errors_.size()), named_files_(named_files) {}

  /// Reports an error at a key; where the key is not given, at the file. Nothing is said of a key that could
  /// not be read: it stands at its default.
  void error(const std::string& key, const std::string& complaint, const std::string& remedy);
  /// Does the work, reports what it finds wrong (InputError) at a key, and tells whether that is nothing.
  /// Problems that name a parameter ("C_I") are reported at the key inside ("law.C_I") where the case gives
  /// it; those with a place in a file of their own keep it.
  template <class Work>
  bool report_at(const std::string& key, const Work& work) {
    try {
      work();
      return true;
    } catch (const InputError& thrown) {
      for (const InputProblem& found : thrown.problems()) report_inside(key, found);
      return false;
    }
  }
  /// Reports an error at one row (from 0) of a key that holds a list; at the key where it has no such row.
  void error_in_row(const std::string& key, std::size_t row, const std::string& complaint,
                    const std::string& remedy);
  /// Reports an error at the row that begins with a name; at the key where none does.
  void error_in_row(const std::string& key, std::string_view name, const std::string& complaint,
                    const std::string& remedy);
  /// Demands a key; says why, and shows an example of its value.
  void require(const std::string& key, const std::string& why, const std::string& example);
  /// Reports something odd that does not stop the run.
  void warn(const std::string& key, const std::string& complaint, const std::string& remedy);
  /// Warns of each of these keys that is given, although with the other choices nothing reads it; `reader`
  /// says what would. A resolved case, which gives every key, is let off.
  void warn_unused(const std::vector<std::string>& keys, const std::string& reader);
  /// Whether the case gives the key itself.
  [[nodiscard]] bool is_given(const std::string& key) const { return document_.find(key) != nullptr; }
  /// Whether nothing is wrong so far, so that all values may be relied on.
  [[nodiscard]] bool is_sound() const { return errors_.empty(); }
  /// Whether nothing is wrong with this key so far.
  [[nodiscard]] bool is_sound(const std::string& key) const;
  /// Cites a key with its place for use inside a message: `fibers.count = 100 (line 12)`.
  [[nodiscard]] std::string cite(const std::string& key) const;
  /// Whether files that the case names may be gone, as for a result that is resumed or reported.
  [[nodiscard]] bool files_may_be_gone() const { return named_files_ == NamedFiles::may_be_gone; }
  /// Reports an error unless the file exists and can be read.
  void check_file(const std::string& key, const std::string& path);

  /// Checks the same case with other entries in place of some of its own: gives the work a checker that knows
  /// them, and takes over what that one finds, each thing once.
  void check_with(const std::vector<TomlEntry>& entries, const std::function<void(CaseChecker&)>& work);
  /// Finds the entry of a key; null when it is not given.
  [[nodiscard]] const TomlEntry* find(const std::string& key) const { return document_.find(key); }

  [[nodiscard]] const std::vector<InputProblem>& errors() const { return errors_; }
  [[nodiscard]] const std::vector<InputProblem>& warnings() const { return warnings_; }

 private:
  void add(InputProblem found);
  void report_inside(const std::string& key, const InputProblem& found);
  [[nodiscard]] InputProblem problem(const std::string& key, const std::string& complaint,
                                     const std::string& remedy) const;
  const TomlDocument& document_;
  std::vector<InputProblem> errors_;
  std::size_t unread_;  ///< how many of the errors, from the first, are about what could not be read
  std::vector<InputProblem> warnings_;
  NamedFiles named_files_;
};

}  // namespace fiberfate
