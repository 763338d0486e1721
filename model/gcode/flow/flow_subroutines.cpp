#include "model/gcode/flow/flow_subroutines.h"

namespace limitgauge::model::gcode {

FlowSubroutine* FlowSubroutines::find(Labels& labels, const std::string& label) {
  if (!is_complete_) look_through();
  const auto found = labels.find(label);
  return found == labels.end() ? nullptr : &found->second;
}

void FlowSubroutines::look_through() {
  look_through_from(start_);
  is_complete_ = true;
}

void FlowSubroutines::add_file(Lexer::Bookmark start, const std::string& label) {
  const std::size_t before = programs_.size();
  look_through_from(start);
  if (programs_.size() != before) return;
  FlowSubroutine& entry = programs_[label];
  entry.label = label;
  entry.is_program = true;
  entry.line = start.line;
  entry.column = 1;
  entry.open = entry.body = start;
}

void FlowSubroutines::look_through_from(Lexer::Bookmark start) {
  const Lexer::Bookmark here = lexer_.bookmark();
  lexer_.go_to(start);
  for (Block block; lexer_.skip_to_o_word(block);) {
    const auto keyword = flow_keyword(block.o_word->keyword);
    if (keyword == FlowKeyword::sub) add(subs_, block, false);
    if (keyword == FlowKeyword::program) add(programs_, block, true);
  }
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
