#include "model/gcode/flow/flow_spans.h"

namespace limitgauge::model::gcode {
namespace {

std::string in_line(std::uint32_t line) {
  return " in line " + std::to_string(line);
}

std::string closing_text(const FlowSpan& span) {
  return "'" + o_text(span.o_word, end_of(span.kind)) + "'";
}

}  // namespace

FlowKeyword end_of(FlowKeyword kind) {
  switch (kind) {
    case FlowKeyword::sub:
      return FlowKeyword::endsub;
    case FlowKeyword::if_:
      return FlowKeyword::endif;
    case FlowKeyword::repeat:
      return FlowKeyword::endrepeat;
    case FlowKeyword::do_:
      return FlowKeyword::while_;
    default:
      return FlowKeyword::endwhile;
  }
}

FlowSpan& FlowSpans::opened_by(const Block& block, FlowKeyword kind) {
  if (const auto found = by_line_.find(block.line); found != by_line_.end()) return *found->second;
  const Lexer::Bookmark behind = lexer_.bookmark();
  open_.clear();
  open(block, kind);
  FlowSpan& span = *open_.front();
  look_through();
  lexer_.go_to(behind);
  return span;
}

void FlowSpans::look_through() {
  while (!open_.empty()) {
    if (!lexer_.skip_to_o_word(block_)) {
      const FlowSpan& span = *open_.back();
      lexer_.fail_at(span.line, span.o_word.column,
                     "'" + o_text(span.o_word, span.kind) + "' has no end in this program",
                     closing_text(span));
    }
    take(block_, keyword_of(block_, lexer_));
  }
}

void FlowSpans::take(const Block& block, FlowKeyword keyword) {
  const FlowSpan& top = *open_.back();
  switch (keyword) {
    case FlowKeyword::while_:
      if (top.kind == FlowKeyword::do_ && top.o_word.label == block.o_word->label)
        return close(block, keyword);
      return open(block, keyword);
    case FlowKeyword::sub:
    case FlowKeyword::do_:
    case FlowKeyword::if_:
    case FlowKeyword::repeat:
      return open(block, keyword);
    case FlowKeyword::elseif:
    case FlowKeyword::else_:
      return branch(block, keyword);
    case FlowKeyword::endsub:
    case FlowKeyword::endwhile:
    case FlowKeyword::endif:
    case FlowKeyword::endrepeat:
      return close(block, keyword);
    case FlowKeyword::program:
      fail(block,
           label_text(*block.o_word) + " begins a program inside '" + o_text(top.o_word, top.kind) +
               "'" + in_line(top.line),
           closing_text(top) + " before it");
    case FlowKeyword::break_:
      return note_break(block);
    default:
      return;  // calls and jumps open and end nothing
  }
}

void FlowSpans::note_break(const Block& block) {
  for (auto span = open_.rbegin(); span != open_.rend(); ++span) {
    if ((*span)->kind == FlowKeyword::sub) return;
    if ((*span)->o_word.label == block.o_word->label) (*span)->last_break = block.line;
  }
}

void FlowSpans::open(const Block& block, FlowKeyword kind) {
  if (!open_.empty()) check_opening(block, kind);
  FlowSpan& span = spans_.emplace_back();
  span.kind = kind;
  span.o_word = *block.o_word;
  span.line = block.line;
  span.open = lexer_.line_bookmark();
  span.body = lexer_.bookmark();
  by_line_[block.line] = &span;
  open_.push_back(&span);
}

void FlowSpans::check_opening(const Block& block, FlowKeyword kind) const {
  if (open_.size() >= most_depth_)
    fail(block, "more than " + std::to_string(most_depth_) + " O words within each other", "fewer");
  for (auto outer = open_.rbegin(); outer != open_.rend(); ++outer) {
    const FlowSpan& span = **outer;
    if (span.kind == FlowKeyword::sub) {
      if (kind != FlowKeyword::sub) return;  // labels of a subroutine are its own
      fail(block, "a subroutine inside subroutine " + label_text(span.o_word) + in_line(span.line),
           closing_text(span) + " before it");
    }
    if (kind != FlowKeyword::sub && span.o_word.label == block.o_word->label)
      fail(block,
           label_text(span.o_word) + " is open already, since line " + std::to_string(span.line),
           "a label of its own");
  }
}

FlowSpan& FlowSpans::innermost(const Block& block, FlowKeyword keyword) {
  FlowSpan& top = *open_.back();
  const bool branches = keyword == FlowKeyword::elseif || keyword == FlowKeyword::else_;
  const bool fits = branches ? top.kind == FlowKeyword::if_ : end_of(top.kind) == keyword;
  if (!fits || top.o_word.label != block.o_word->label)
    fail(block,
         "'" + o_text(*block.o_word, keyword) + "' inside '" + o_text(top.o_word, top.kind) + "'" +
             in_line(top.line),
         closing_text(top) + " first");
  return top;
}

void FlowSpans::branch(const Block& block, FlowKeyword keyword) {
  FlowSpan& span = innermost(block, keyword);
  if (span.has_else)
    fail(block, "'" + o_text(*block.o_word, keyword) + "' behind the else of the same if",
         closing_text(span));
  span.has_else = keyword == FlowKeyword::else_;
  span.branches.push_back(lexer_.line_bookmark());
}

void FlowSpans::close(const Block& block, FlowKeyword keyword) {
  FlowSpan& span = innermost(block, keyword);
  span.last = lexer_.line_bookmark();
  span.behind = lexer_.bookmark();
  open_.pop_back();
}

void FlowSpans::fail(const Block& block, const std::string& wrong,
                     const std::string& expected) const {
  lexer_.fail_at(block.line, block.o_word->column, wrong, expected);
}

}  // namespace limitgauge::model::gcode
