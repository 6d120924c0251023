// Words of a text that know where they stand.
#pragma once

#include <string>
#include <string_view>

namespace fiberfate {

/// Hands out the words of a text, which blanks and line ends part. The text must outlive the reader.
class WordReader {
 public:
  /// `path` names the text in messages.
  WordReader(std::string_view text, std::string path);

  [[nodiscard]] bool at_end() const { return begin_ == text_.size(); }
  /// Gives the next word in small letters; nothing at the end.
  [[nodiscard]] const std::string& peek() const { return word_; }
  /// Goes on to the next word.
  void next();
  /// Goes on to the first word after the line of the word that was taken last.
  void skip_line();
  /// Takes a finite number; raises InputError where the word is none.
  double number();
  /// Raises InputError with the place of the word.
  [[noreturn]] void refuse(const std::string& complaint, const std::string& remedy) const;

 private:
  void find_word(std::size_t from);
  std::string_view text_;
  std::string path_;
  std::string word_;
  std::size_t begin_ = 0, end_ = 0;  ///< of the word
  std::size_t last_end_ = 0;         ///< of the word that was taken last
  std::size_t line_begin_ = 0;
  int line_ = 1;
};

}  // namespace fiberfate
