// Columns of numbers with decimal points or decimal commas.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fiberfate {

/// Reads a whole number text such as "-1.5e-3"; nothing where it is none or not finite.
[[nodiscard]] std::optional<double> plain_number(std::string_view text);

/// Reads the numbers of one column one after the other, and takes a comma for what it is there.
class DecimalColumn {
 public:
  /// `separator` parts the columns of the table: a comma parts numbers, or '\0' where there is one column
  /// only.
  explicit DecimalColumn(char separator) : separator_(separator) {}

  /// Reads a number, or tells in `fault` what is wrong with it.
  [[nodiscard]] std::optional<double> read(std::string_view text, std::string& fault);
  /// Whether all commas stand as thousands do, "1,204": nobody can know then what they mean.
  [[nodiscard]] bool is_ambiguous() const {
    return separator_ == '\t' && commas_ && !points_ && !sure_commas_;
  }

 private:
  char separator_;
  bool points_ = false, commas_ = false, sure_commas_ = false;
};

}  // namespace fiberfate
