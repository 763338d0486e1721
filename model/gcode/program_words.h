#pragma once

#include <ostream>
#include <string_view>

#include "model/gcode/program.h"
#include "model/text/text_blocks.h"

namespace limitgauge::model {

/// Throws std::invalid_argument for points and feed rates beyond what the dialect takes, feed moves
/// without a feed rate and options out of range.
void require_writable(const Toolpath& path, const WriterOptions& options);

/// The text of a program that is written: words with blanks between them, N words where they are
/// asked for.
class ProgramWords {
 public:
  ProgramWords(std::ostream& out, bool line_numbers) : text_(out), line_numbers_(line_numbers) {}

  void word(char letter, std::string_view number) {
    begin_word();
    text_.append({&letter, 1});
    text_.append(number);
  }
  void words(std::string_view words) {
    begin_word();
    text_.append(words);
  }
  /// An F word, with the decimals that the dialect has for it.
  void feed(float feed_mm_min, const DialectRules& rule);
  void end_line() { text_.end_line(); }
  /// A line of words alone.
  void line(std::string_view words) {
    begin_word();
    text_.line(words);
  }
  std::uint32_t line_number() const { return text_.line_number(); }

  /// What stands above the motions: the program's name and number, its modes, the tool and the
  /// spindle.
  void write_head(const WriterOptions& options);
  /// The end of the program. Throws ResourceError where the stream takes no more.
  void write_end(const DialectRules& rule);

 private:
  void begin_word();
  /// A comment, `%` or a program's number.
  void plain_line(std::string_view line) { text_.line(line); }
  void write_spindle(const WriterOptions& options);

  TextBlocks text_;
  bool line_numbers_;
  int number_ = 0;
};

}  // namespace limitgauge::model
