#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "model/gcode/text/lexer.h"

namespace limitgauge::model::gcode {

/// Where a block with a number begins.
struct NumberedBlock {
  Lexer::Bookmark before;
  std::uint32_t column = 0;
  std::uint32_t second_line = 0;  ///< where another block has its number; or 0
};

/// The END of a loop of macro B.
struct LoopEnd {
  Lexer::Bookmark before, behind;
};

/// Numbered blocks and loops of the programs of a file, for GOTO, M97, M99 P and WHILE. A file is
/// looked through once, when the first is asked for. Numbers belong to their program: from an O
/// word to the next.
class FlowMarks {
 public:
  explicit FlowMarks(Lexer& lexer) : lexer_(lexer) {}

  /// Block N`number` of the program that `place` stands in; null where there is none. The lexer
  /// stays where it is.
  const NumberedBlock* block(int number, Lexer::Bookmark place);
  /// The END of the loop that the line at `place` begins.
  const LoopEnd* end_of_loop(Lexer::Bookmark place);

 private:
  struct Text {
    std::vector<std::size_t> programs;                            ///< where each begins
    std::map<std::pair<std::size_t, int>, NumberedBlock> blocks;  ///< by program and number
    std::unordered_map<std::size_t, LoopEnd> loops;               ///< by the place of their line
  };
  struct OpenLoop {
    int number = 0;
    std::size_t at = 0;
  };
  const Text& text_of(Lexer::Bookmark place);
  void look_through(std::size_t index, Text& text);
  void take(const Lexer::Mark& mark, Text& text, std::vector<OpenLoop>& open);

  Lexer& lexer_;
  std::map<std::size_t, Text> texts_;
};

}  // namespace limitgauge::model::gcode
