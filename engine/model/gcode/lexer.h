#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/error.h"
#include "engine/model/gcode/expression.h"

namespace limitgauge::model::gcode {

/// A letter and its number. `text` is the word as it stands in the program, `column` counts from 1.
struct Word {
  char letter = 0;  ///< upper case
  double value = 0;
  std::uint32_t column = 0;
  std::string_view text;
};

/// A comment as it stands in the program, with its parentheses.
struct Comment {
  std::uint32_t column = 0;
  std::string_view text;
};

/// `#5 = ...` or `#<name> = ...`; takes effect after its line has been read whole.
struct Setting {
  ParameterName parameter;
  double value = 0;
  std::uint32_t column = 0;
};

/// A line that begins with an O word: `o100 while [#1 LT 5]`, `o<bore> call [1] [2]`, or only the
/// number of a program. What stands behind the keyword is read by Lexer::arguments.
struct OWord {
  std::uint32_t column = 0;
  std::string label;  ///< the number's digits without leading zeros, or the name in lower case
  bool named = false;
  std::string keyword;  ///< lower case; empty: the number alone
  std::uint32_t keyword_column = 0;
  std::size_t rest = 0;  ///< byte of the line behind the keyword
};

/// One line of a program.
struct Block {
  std::uint32_t line = 0;
  bool block_delete = false;  ///< the line begins with `/`
  std::vector<Word> words;
  std::vector<Comment> comments;
  std::vector<Setting> settings;
  std::optional<OWord> o_word;  ///< then there are no words and settings

  void clear();
};

/// Cuts RS274/NGC text into blocks of words. Blanks may stand anywhere, inside numbers too; letters
/// may be lower case. Line numbers are checked for form and dropped. A first line `%` makes the
/// next `%` end the program, and then one is required unless the reader stops before; an O word
/// before all others is then the program's number, and dropped.
class Lexer {
 public:
  /// `text` must outlive the lexer and its blocks.
  Lexer(std::string_view text, std::string name);

  /// Reads the next line into `block`; false at the end of the program.
  bool next(Block& block);
  SourcePlace place(std::uint32_t line, std::uint32_t column) const;

 private:
  bool take_percent();
  void read_line(Block& block);
  void read_comment(Block& block);
  void read_word(Block& block);
  void read_program_number(const Block& block, std::size_t word_begin);
  double read_number(std::size_t word_begin);
  double read_spaced_number(std::size_t word_begin);
  void skip_blanks();
  void end_line();
  bool at_line_end() const { return at_ >= text_.size() || text_[at_] == '\n'; }
  std::uint32_t column_of(std::size_t at) const {
    return static_cast<std::uint32_t>(at - line_begin_ + 1);
  }
  [[noreturn]] void fail(std::size_t at, const std::string& wrong,
                         const std::string& expected) const;

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0, line_begin_ = 0;
  std::uint32_t line_ = 1;
  bool in_percents_ = false, started_ = false, words_read_ = false;
};

}  // namespace limitgauge::model::gcode
