#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/error.h"

namespace limitgauge::model {

/// A word or a figure of a CL statement and where it stands; line and column count from 1.
struct ClWord {
  std::string text;  ///< upper case
  std::uint32_t line = 0, column = 0;
};

/// A statement: the word before its slash, and what follows, parted by commas.
struct ClStatement {
  ClWord major;
  std::vector<ClWord> figures;
  std::string text;  ///< of PARTNO, PPRINT and REMARK: the rest of the line
};

/// Cuts CL data into statements. Remarks (`$$` to the line's end), continuations (`$` at the line's
/// end), carriage returns and a byte order mark never reach the caller.
class ClLexer {
 public:
  /// `text` must outlive the lexer.
  ClLexer(std::string_view text, std::string name);

  /// Reads the next statement; false at the end of the text.
  bool next(ClStatement& statement);
  /// Of the place that is read next.
  std::uint32_t line() const { return line_; }
  [[noreturn]] void fail(const ClWord& word, const std::string& wrong,
                         const std::string& expected) const;

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\n'; }
  void skip_blanks();
  bool skip_lines();
  void end_line();
  ClWord read_word();
  void read_figures(ClStatement& statement);
  void read_text(ClStatement& statement);

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0, line_begin_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace limitgauge::model
