#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include "model/gcode/flow/flow_spans.h"
#include "model/gcode/text/lexer.h"

namespace limitgauge::model::gcode {

/// Where a subroutine (`o100 sub`) or a Fanuc program (`O100`) begins.
struct FlowSubroutine {
  std::string label;
  bool is_program = false;
  bool is_local = false;  ///< a numbered block that M97 calls
  std::uint32_t line = 0, column = 0;
  std::uint32_t second_line = 0;   ///< where another one has its label; or 0
  Lexer::Bookmark open, body;      ///< before and behind its first line
  const FlowSpan* span = nullptr;  ///< of a subroutine that has been called
};

/// The subroutines and programs of a file by their labels. The file is looked through once, when
/// the first is asked for.
class FlowSubroutines {
 public:
  /// `lexer` stands at the beginning of its text.
  explicit FlowSubroutines(Lexer& lexer) : lexer_(lexer), start_(lexer.bookmark()) {}

  /// Null where there is none. The lexer stays where it is.
  FlowSubroutine* sub(const std::string& label) { return find(subs_, label); }
  FlowSubroutine* program(const std::string& label) { return find(programs_, label); }
  /// Adds the programs of a file whose text begins at `start`; one that no O number begins is
  /// `label`'s.
  void add_file(Lexer::Bookmark start, const std::string& label);

 private:
  using Labels = std::unordered_map<std::string, FlowSubroutine>;
  FlowSubroutine* find(Labels& labels, const std::string& label);
  void look_through();
  void look_through_from(Lexer::Bookmark start);
  void add(Labels& labels, const Block& block, bool is_program);

  Lexer& lexer_;
  Lexer::Bookmark start_;
  bool is_complete_ = false;
  Labels subs_, programs_;  // a main program and a subroutine may have one number
};

}  // namespace limitgauge::model::gcode
