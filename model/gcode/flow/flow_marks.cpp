#include "model/gcode/flow/flow_marks.h"

#include <algorithm>

namespace limitgauge::model::gcode {
namespace {

std::size_t program_at(const std::vector<std::size_t>& programs, std::size_t at) {
  const auto behind = std::upper_bound(programs.begin(), programs.end(), at);
  return static_cast<std::size_t>(behind - programs.begin());
}

}  // namespace

const NumberedBlock* FlowMarks::block(int number, Lexer::Bookmark place) {
  const Text& text = text_of(place);
  const auto found = text.blocks.find({program_at(text.programs, place.at), number});
  return found == text.blocks.end() ? nullptr : &found->second;
}

const LoopEnd* FlowMarks::end_of_loop(Lexer::Bookmark place) {
  const Text& text = text_of(place);
  const auto found = text.loops.find(place.at);
  return found == text.loops.end() ? nullptr : &found->second;
}

const FlowMarks::Text& FlowMarks::text_of(Lexer::Bookmark place) {
  const std::size_t index = lexer_.text_index(place);
  const auto [text, is_new] = texts_.try_emplace(index);
  if (is_new) look_through(index, text->second);
  return text->second;
}

void FlowMarks::look_through(std::size_t index, Text& text) {
  const Lexer::Bookmark here = lexer_.bookmark();
  lexer_.go_to(lexer_.beginning_of(index));
  std::vector<OpenLoop> open;
  for (Lexer::Mark mark; lexer_.skip_to_mark(mark);) take(mark, text, open);
  lexer_.go_to(here);
}

void FlowMarks::take(const Lexer::Mark& mark, Text& text, std::vector<OpenLoop>& open) {
  const Lexer::Bookmark before = lexer_.line_bookmark();
  if (mark.begins_program) text.programs.push_back(before.at), open.clear();
  if (mark.number) {
    NumberedBlock& block = text.blocks[{program_at(text.programs, before.at), *mark.number}];
    if (block.column != 0) {
      block.second_line = block.second_line == 0 ? before.line : block.second_line;
    } else {
      block = {before, mark.column, 0};
    }
  }
  if (!mark.loop) return;
  if (mark.loop->keyword != MacroKeyword::end)
    return open.push_back({mark.loop->number, before.at});
  // Loops that lie in it and have no end stay without one.
  while (!open.empty() && open.back().number != mark.loop->number) open.pop_back();
  if (open.empty()) return;
  text.loops[open.back().at] = {before, lexer_.bookmark()};
  open.pop_back();
}

}  // namespace limitgauge::model::gcode
