// Splits the text files of the published program into words that know their line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {

/// One word of a legacy file.
struct LegacyWord {
  std::string text;
  int line = 0;
};

/// Makes the problem of a place in a legacy file.
[[nodiscard]] InputProblem legacy_problem(const std::string& path, int line, std::string complaint,
                                          std::string remedy);

/// Reads a file as InputError-raising text.
[[nodiscard]] std::string read_legacy_file(const std::string& path);

/// Understands Fortran's numbers, "1.5d-6" and "1.5D-6" too; tells whether the word is one.
[[nodiscard]] bool read_fortran_number(std::string_view word, double& number);

/// Understands Fortran's truth values: T, .true., .t., F, .false., .f., in any case.
[[nodiscard]] bool read_fortran_truth(std::string_view word, bool& truth);

/// Hands out the words of a file of blank-separated numbers in order.
class LegacyNumbers {
 public:
  /// Raises InputError when the file cannot be read.
  explicit LegacyNumbers(const std::string& path);
  /// Takes the next number; raises InputError with file and line when there is none or it is no number.
  /// `meaning` names it in the message.
  double number(const std::string& meaning);
  std::int64_t count(const std::string& meaning);
  bool truth(const std::string& meaning);
  /// Raises InputError when words are left.
  void expect_end() const;

 private:
  const LegacyWord& next(const std::string& meaning);
  std::string path_;
  std::vector<LegacyWord> words_;
  std::size_t place_ = 0;
  int last_line_ = 0;
};

}  // namespace fiberfate
