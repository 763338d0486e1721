#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/error.h"
#include "model/gcode/control/control_rules.h"
#include "model/gcode/text/expression.h"
#include "model/gcode/text/plain_line.h"

namespace limitgauge::model::gcode {

/// A letter and its number. `text` is the word as it stands in the program, `column` counts from 1.
struct Word {
  char letter = 0;  ///< upper case, `@` or `^`
  double value = 0;
  std::uint32_t column = 0;
  std::string_view text;

  /// By variables or an expression.
  bool is_calculated() const { return text.find_first_of("#[") != std::string_view::npos; }
  /// Written out without a decimal point; 0 is the same with and without.
  bool lacks_point() const {
    return value != 0 && !is_calculated() && text.find('.') == std::string_view::npos;
  }
};

/// Steps of the least input increment (IS-B: 0.001 mm, 0.0001 inch, 0.001 degrees) in a unit of a
/// word of that letter; 0: it is no length and no angle.
double steps_in_unit(char letter, bool in_inches);

/// A comment as it stands in the program, with its parentheses, or from its semicolon to the last
/// character of its line that is no blank.
struct Comment {
  std::uint32_t column = 0;
  std::string_view text;
};

/// `#5 = ...` or `#<name> = ...`; takes effect after its line has been read whole.
struct Setting {
  ParameterName parameter;
  std::optional<double> value;  ///< nothing: the parameter becomes vacant
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

/// Macro B: what a line says about which line comes next.
enum class MacroKeyword : std::uint8_t { go_to, begin_while, begin_do, end };

/// `IF [...] GOTO 10` with its condition fulfilled, `GOTO 10`, `WHILE [...] DO 1`, `DO 1`, `END 1`.
struct MacroWord {
  MacroKeyword keyword = MacroKeyword::go_to;
  std::uint32_t column = 0;
  int number = 0;     ///< of a block, or of a loop
  bool holds = true;  ///< the condition of WHILE
};

/// One line of a program.
struct Block {
  std::uint32_t line = 0;
  /// The line of the main program that stands for it: its own there, else that of the call.
  std::uint32_t main_line = 0;
  bool block_delete = false;  ///< the line begins with `/`
  std::vector<Word> words;
  std::vector<Comment> comments;
  std::vector<Setting> settings;
  std::optional<OWord> o_word;  ///< then there are no words and settings
  std::optional<MacroWord> macro;
  std::string_view dollar;             ///< a line for the control itself, from its `$` on
  std::vector<std::string> notes;      ///< what was taken for granted in reading the line
  std::vector<std::string> set_aside;  ///< statements that move nothing

  void clear() {
    block_delete = false;
    words.clear();
    comments.clear();
    settings.clear();
    o_word.reset();
    macro.reset();
    dollar = {};
    notes.clear();
    set_aside.clear();
  }
};

/// Whether G20 stands in the block, or G21; neither.
std::optional<bool> inches_stated(const Block& block);

/// Cuts RS274/NGC text into blocks of words, with the values of expressions and parameters as they
/// are when the line is read. Blanks may stand anywhere, inside numbers too; letters may be lower
/// case. Line numbers are checked for form and dropped. A first line `%` makes the next `%` end the
/// program, and then one is required unless the reader stops before.
class Lexer {
 public:
  /// `text` must outlive the lexer and its blocks, `parameters` the lexer.
  Lexer(std::string_view text, std::string name, const Parameters& parameters,
        const ControlRules& rules = rules_of(Control::linuxcnc));
  Lexer(const Lexer&) = delete;
  Lexer& operator=(const Lexer&) = delete;

  /// Reads the next line into `block`; false at the end of the program. Settings of parameters are
  /// the caller's to carry out. The values of an O line are not calculated.
  bool next(Block& block);
  /// Reads the line that next() would read where it is a plain one, and leaves it to be read.
  bool see_plain(PlainLine& line);
  /// Goes over the line that see_plain() has read.
  void pass_plain() { next_ = behind_plain_; }
  /// Goes over lines to the next that begins with an O word, behind `/` and a line number at most;
  /// false at the end of the text or program. The lines between are not read and need not be right;
  /// an O without a label or keyword is one of them, and so is a calculated O word, a call.
  bool skip_to_o_word(Block& block);
  /// The values behind the keyword of the O line that was read last; errors for anything else
  /// there, save comments.
  std::vector<double> arguments(const Block& block);

  /// Before the line that next() will read. Texts that were added have places and lines behind
  /// those of the texts before them.
  struct Bookmark {
    std::size_t at = 0;
    std::uint32_t line = 1;
  };
  Bookmark bookmark() const { return next_; }
  /// Before the line that next() or skip_to_o_word() read last.
  Bookmark line_bookmark() const { return {line_at_, line_}; }
  void go_to(Bookmark bookmark) { next_ = bookmark; }
  /// Another file's text, which go_to() leads into; its beginning. Its end is the end of the
  /// program to next().
  Bookmark add(std::string name, std::string text);
  /// The text that `bookmark` stands in, counted from 0: that of the constructor.
  std::size_t text_index(Bookmark bookmark) const;
  Bookmark beginning_of(std::size_t index) const {
    return {texts_[index].begin, texts_[index].first_line};
  }

  /// A line that begins with N and its number; `number` is nothing where an O word begins the line,
  /// or macro B's DO and END where `loops` asks for them.
  struct Mark {
    std::optional<int> number;
    std::optional<MacroWord> loop;  ///< begin_do or end; conditions are not calculated
    bool begins_program = false;
    std::uint32_t column = 0;
  };
  /// Goes over lines to the next that begins with N, with an O word, or that has DO or END; false
  /// at the end of the text or program. Lines need not be right.
  bool skip_to_mark(Mark& mark);

  const ControlRules& rules() const { return rules_; }
  /// The machine has rotary axes, whose letters these are: their words and the codes that say what
  /// places mean while they are turned are carried out.
  void set_rotary(std::uint32_t letters) { rotary_ = letters; }
  std::uint32_t rotary() const { return rotary_; }

  SourcePlace place(std::uint32_t line, std::uint32_t column) const;
  [[noreturn]] void fail_at(std::uint32_t line, std::uint32_t column, const std::string& wrong,
                            const std::string& expected) const;

  /// Such a program ends with '%', M2 or M30, or is an error.
  bool begins_with_percent() const { return texts_.front().opening_percent.has_value(); }
  /// A '%' that ends the program was reached.
  bool ended_by_percent() const { return ended_by_percent_; }

 private:
  /// LinuxCNC's lines have 254 at most. A line may be carried out many times, and each must be
  /// quick.
  static constexpr std::size_t kMostLineBytes = 10'000;

  /// One file.
  struct Text {
    std::string name;
    std::string_view text;
    std::unique_ptr<const std::string> own;
    std::size_t begin = 0;                            ///< Bookmark::at of its first byte
    std::uint32_t first_line = 1;                     ///< Bookmark::line of its first line
    std::optional<std::size_t> opening_percent = {};  ///< where its line begins, in `text`
  };

  enum class Percent : std::uint8_t { none, opening, closing };

  bool take_line();
  const Text& text_at(std::size_t at) const;
  void read_dollar(Block& block);
  void set_rest_aside(Block& block);
  bool read_macro(Block& block);
  void read_condition(Block& block);
  void read_loop(Block& block, std::size_t begin, bool holds);
  void read_go_to(Block& block, std::size_t begin);
  std::string letters_ahead() const;
  void skip_letters(std::size_t letters);
  void read_siemens_items(Block& block);
  void read_siemens_item(Block& block);
  void read_siemens_setting(Block& block, std::size_t begin);
  double read_siemens_value(Block& block);
  void read_siemens_statement(Block& block, std::size_t begin, std::size_t end,
                              const std::string& name);
  void check_behind_semicolon(std::size_t begin) const;
  void check_known_word(std::size_t begin) const;
  [[noreturn]] void fail_at_stray(std::size_t at) const;
  [[noreturn]] void fail_at_letter_o(std::size_t at) const;
  bool begins_o_word() const;
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
  std::optional<double> read_general_value(std::size_t word_begin, const Block& block);
  void skip_comment();
  void skip_blanks();
  bool at_end() const { return cursor_.at >= cursor_.line.size(); }
  char here() const { return cursor_.line[cursor_.at]; }
  static std::uint32_t column_of(std::size_t at) { return static_cast<std::uint32_t>(at + 1); }
  [[noreturn]] void fail(std::size_t at, const std::string& wrong,
                         const std::string& expected) const;

  std::vector<Text> texts_;
  const ControlRules& rules_;
  std::uint32_t rotary_ = 0;
  const Parameters& parameters_;
  Fail fail_;
  Cursor cursor_;            // the line that is read
  std::uint32_t line_ = 1;   // its number
  std::size_t line_at_ = 0;  // where it begins
  std::size_t in_text_ = 0;  // of texts_, the one that it stands in
  bool ended_by_percent_ = false;
  Bookmark next_, behind_plain_;
};

}  // namespace limitgauge::model::gcode
