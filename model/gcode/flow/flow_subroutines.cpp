#include "model/gcode/flow/flow_subroutines.h"

namespace limitgauge::model::gcode {

FlowSubroutine* FlowSubroutines::find(Labels& labels, const std::string& label) {
  if (!is_complete_) look_through();
  const auto found = labels.find(label);
  return found == labels.end() ? nullptr : &found->second;
}

void FlowSubroutines::look_through() {
  const Lexer::Bookmark here = lexer_.bookmark();
  lexer_.go_to(start_);
  for (Block block; lexer_.skip_to_o_word(block);) {
    const auto keyword = flow_keyword(block.o_word->keyword);
    if (keyword == FlowKeyword::sub) add(subs_, block, false);
    if (keyword == FlowKeyword::program) add(programs_, block, true);
  }
  is_complete_ = true;
  lexer_.go_to(here);
}

void FlowSubroutines::add(Labels& labels, const Block& block, bool is_program) {
  FlowSubroutine& entry = labels[block.o_word->label];
  if (entry.line != 0) {
    if (entry.second_line == 0) entry.second_line = block.line;
    return;
  }
  entry.label = block.o_word->label;
  entry.is_program = is_program;
  entry.line = block.line;
  entry.column = block.o_word->column;
  entry.open = lexer_.line_bookmark();
  entry.body = lexer_.bookmark();
}

}  // namespace limitgauge::model::gcode
