#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/error.h"
#include "model/gcode/text/expression.h"

namespace limitgauge::model::gcode {

/// A letter and its number. `text` is the word as it stands in the program, `column` counts from 1.
struct Word {
  char letter = 0;  ///< upper case
  double value = 0;
  std::uint32_t column = 0;
  std::string_view text;
};

/// A comment as it stands in the program, with its parentheses, or from its semicolon to the last
/// character of its line that is no blank.
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

/// A line that begins with an O word: `o100 while [#1 LT 5]`, `o<bore> call [1] [2]`, `o[#1+2]
/// call`, or only the number of a program. What stands behind the keyword is read by
/// Lexer::arguments.
struct OWord {
  std::uint32_t column = 0;
  std::string label;  ///< the number's digits without leading zeros, or the name in lower case
  bool named = false;
  bool calculated = false;  ///< the number is that of an expression; only calls may have one
  std::string keyword;      ///< lower case; empty: the number alone
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

  void clear() {
    block_delete = false;
    words.clear();
    comments.clear();
    settings.clear();
    o_word.reset();
  }
};

/// Cuts RS274/NGC text into blocks of words, with the values of expressions and parameters as they
/// are when the line is read. Blanks may stand anywhere, inside numbers too; letters may be lower
/// case. Line numbers are checked for form and dropped. A first line `%` makes the next `%` end the
/// program, and then one is required unless the reader stops before.
class Lexer {
 public:
  /// `text` must outlive the lexer and its blocks, `parameters` the lexer.
  Lexer(std::string_view text, std::string name, const Parameters& parameters);
  Lexer(const Lexer&) = delete;
  Lexer& operator=(const Lexer&) = delete;

  /// Reads the next line into `block`; false at the end of the program. Settings of parameters are
  /// the caller's to carry out. The values of an O line are not calculated.
  bool next(Block& block);
  /// Goes over lines to the next that begins with an O word, behind `/` and a line number at most;
  /// false at the end of the text or program. The lines between are not read and need not be right;
  /// an O without a label or keyword is one of them, and so is a calculated O word, a call.
  bool skip_to_o_word(Block& block);
  /// The values behind the keyword of the O line that was read last; errors for anything else
  /// there, save comments.
  std::vector<double> arguments(const Block& block);

  /// Before the line that next() will read.
  struct Bookmark {
    std::size_t at = 0;
    std::uint32_t line = 1;
  };
  Bookmark bookmark() const { return next_; }
  /// Before the line that next() or skip_to_o_word() read last.
  Bookmark line_bookmark() const {
    return {static_cast<std::size_t>(cursor_.line.data() - text_.data()), line_};
  }
  void go_to(Bookmark bookmark) { next_ = bookmark; }

  SourcePlace place(std::uint32_t line, std::uint32_t column) const;
  [[noreturn]] void fail_at(std::uint32_t line, std::uint32_t column, const std::string& wrong,
                            const std::string& expected) const;

  /// Such a program ends with '%', M2 or M30, or is an error.
  bool begins_with_percent() const { return opening_percent_.has_value(); }

 private:
  /// LinuxCNC's lines have 254 at most. A line may be carried out many times, and each must be
  /// quick.
  static constexpr std::size_t kMostLineBytes = 10'000;

  enum class Percent : std::uint8_t { none, opening, closing };

  bool take_line();
  Percent percent() const;
  void check_percent() const;
  void read_line(Block& block);
  void read_items(Block& block);
  void read_comment(Block& block);
  void read_word(Block& block);
  void read_setting(Block& block);
  void read_line_number(std::size_t word_begin);
  bool skip_to_o();
  void read_o_word(Block& block);
  void read_label(OWord& o_word);
  void read_keyword(OWord& o_word);
  bool read_plain_value(double& value);
  double read_general_value(std::size_t word_begin);
  void skip_comment();
  void skip_blanks();
  bool at_end() const { return cursor_.at >= cursor_.line.size(); }
  char here() const { return cursor_.line[cursor_.at]; }
  static std::uint32_t column_of(std::size_t at) { return static_cast<std::uint32_t>(at + 1); }
  [[noreturn]] void fail(std::size_t at, const std::string& wrong,
                         const std::string& expected) const;

  std::string_view text_;
  std::string name_;
  const Parameters& parameters_;
  Fail fail_;
  Cursor cursor_;           // the line that is read
  std::uint32_t line_ = 1;  // its number
  Bookmark next_;
  std::optional<std::size_t> opening_percent_;  // where its line begins
};

}  // namespace limitgauge::model::gcode
