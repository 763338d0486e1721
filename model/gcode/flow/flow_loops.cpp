#include <cmath>

#include "model/gcode/flow/flow.h"

namespace limitgauge::model::gcode {
namespace {

std::string line_text(std::uint32_t line) {
  return "line " + std::to_string(line);
}

}  // namespace

void Flow::begin_if(const Block& block) {
  const bool holds = value(block, FlowKeyword::if_) != 0;
  Frame frame;
  frame.span = &opened(block, FlowKeyword::if_);
  frame.taken = holds;
  push(block, block.o_word->column, frame);
  if (!holds) go_to_branch(frames_.back());
}

void Flow::go_to_branch(const Frame& frame) {
  const FlowSpan& span = *frame.span;
  lexer_.go_to(frame.branch < span.branches.size() ? span.branches[frame.branch] : span.last);
}

void Flow::branch(const Block& block, FlowKeyword keyword) {
  Frame& frame = innermost(block, keyword, FlowKeyword::if_);
  ++frame.branch;
  if (frame.taken) return lexer_.go_to(frame.span->last);
  if (keyword == FlowKeyword::else_) {
    no_values(block, keyword);
    frame.taken = true;
  } else {
    frame.taken = value(block, keyword) != 0;
  }
  if (!frame.taken) go_to_branch(frame);
}

void Flow::end_if(const Block& block) {
  innermost(block, FlowKeyword::endif, FlowKeyword::if_);
  no_values(block, FlowKeyword::endif);
  frames_.pop_back();
}

/// Each turn comes here again.
void Flow::begin_while(const Block& block) {
  const bool holds = value(block, FlowKeyword::while_) != 0;
  if (frames_.empty() || frames_.back().span == nullptr ||
      frames_.back().begin.line != block.line) {
    Frame frame;
    frame.span = &opened(block, FlowKeyword::while_);
    push(block, block.o_word->column, frame);
  }
  if (holds) return;
  const FlowSpan& span = *frames_.back().span;
  // On its way to the end of the body LinuxCNC carries out the breaks of this loop.
  if (span.last_break != 0) break_line_ = span.last_break;
  continue_line_.reset();
  lexer_.go_to(span.behind);
  frames_.pop_back();
}

void Flow::end_while(const Block& block) {
  const Frame& frame = innermost(block, FlowKeyword::endwhile, FlowKeyword::while_);
  no_values(block, FlowKeyword::endwhile);
  lexer_.go_to(frame.span->open);
}

void Flow::begin_do(const Block& block) {
  no_values(block, FlowKeyword::do_);
  Frame frame;
  frame.span = &opened(block, FlowKeyword::do_);
  push(block, block.o_word->column, frame);
}

bool Flow::ends_do(const Block& block) const {
  if (frames_.empty()) return false;
  const FlowSpan* const span = frames_.back().span;
  return span != nullptr && span->kind == FlowKeyword::do_ &&
         span->o_word.label == block.o_word->label;
}

void Flow::end_do(const Block& block) {
  const bool holds = value(block, FlowKeyword::while_) != 0;
  if (holds && break_line_)
    fail(block,
         "LinuxCNC would leave this do loop after one turn, because of the break in " +
             line_text(*break_line_),
         "do loops only, or while loops only");
  break_line_.reset();
  if (holds) return lexer_.go_to(frames_.back().span->body);
  frames_.pop_back();
}

void Flow::begin_repeat(const Block& block) {
  Frame frame;
  // Halves go to the even neighbour, as LinuxCNC's do.
  frame.left = std::nearbyint(value(block, FlowKeyword::repeat));
  frame.span = &opened(block, FlowKeyword::repeat);
  if (!frame.span->count) frame.span->count = frame.left;
  if (repeats(block, frame)) return push(block, block.o_word->column, frame);
  continue_line_.reset();
  lexer_.go_to(frame.span->behind);
}

/// Counts a turn; false where none is left.
bool Flow::repeats(const Block& block, Frame& frame) {
  std::optional<double>& count = frame.span->count;
  const bool goes_on = frame.left > 0;
  // No count: the same repeat has come to its end in a call.
  if (!count || goes_on != (*count > 0))
    fail(block,
         "'" + o_text(frame.span->o_word, FlowKeyword::repeat) +
             "' was not carried out to its end before: LinuxCNC would go on with its old count",
         "a while loop");
  if (!goes_on) {
    count.reset();
    return false;
  }
  --frame.left;
  --*count;
  return true;
}

void Flow::end_repeat(const Block& block) {
  Frame& frame = innermost(block, FlowKeyword::endrepeat, FlowKeyword::repeat);
  no_values(block, FlowKeyword::endrepeat);
  if (repeats(block, frame)) return lexer_.go_to(frame.span->body);
  if (continue_line_)
    fail(block,
         "LinuxCNC would carry out this repeat twice, because of the continue in " +
             line_text(*continue_line_),
         "a while loop for one of the two");
  lexer_.go_to(frame.span->behind);
  frames_.pop_back();
}

void Flow::break_loop(const Block& block) {
  no_values(block, FlowKeyword::break_);
  const std::size_t at = loop_of(block, FlowKeyword::break_);
  const FlowSpan& span = *frames_[at].span;
  const bool is_while = span.kind == FlowKeyword::while_;
  if (is_while && continue_line_)
    fail(block,
         "LinuxCNC would not leave this loop, because of the continue in " +
             line_text(*continue_line_),
         "a while loop there, or a do loop here");
  break_line_ = is_while ? std::optional(block.line) : std::nullopt;
  frames_.resize(at);
  lexer_.go_to(span.behind);
}

void Flow::continue_loop(const Block& block) {
  no_values(block, FlowKeyword::continue_);
  const std::size_t at = loop_of(block, FlowKeyword::continue_);
  const FlowSpan& span = *frames_[at].span;
  const bool is_while = span.kind == FlowKeyword::while_;
  if (span.last_break > block.line) break_line_ = span.last_break;
  continue_line_ = is_while ? std::nullopt : std::optional(block.line);
  frames_.resize(at + 1);
  lexer_.go_to(is_while ? span.open : span.last);
}

/// The frame of the loop that a break or continue names.
std::size_t Flow::loop_of(const Block& block, FlowKeyword keyword) const {
  for (std::size_t at = frames_.size(); at > 0 && frames_[at - 1].span != nullptr; --at) {
    const FlowSpan& span = *frames_[at - 1].span;
    if (span.o_word.label != block.o_word->label) continue;
    if (span.kind == FlowKeyword::while_ || span.kind == FlowKeyword::do_) return at - 1;
    fail(block,
         "'" + o_text(*block.o_word, keyword) + "' of '" + o_text(span.o_word, span.kind) + "'",
         "the number of a while or do loop");
  }
  fail(block, "'" + o_text(*block.o_word, keyword) + "' outside a loop of that number",
       "the number of a while or do loop that is open here");
}

/// The span that the line opens; a label opens one span only in the main program, in a subroutine
/// and in a program.
FlowSpan& Flow::opened(const Block& block, FlowKeyword keyword) {
  FlowSpan& span = spans_.opened_by(block, keyword);
  if (span.label_is_known) return span;
  span.label_is_known = true;
  const Frame* const call = innermost_call();
  const std::string scope = call == nullptr ? std::string() : call->subroutine->label;
  const auto [known, is_new] =
      lines_of_labels_.try_emplace(scope + '#' + block.o_word->label, block.line);
  if (!is_new)
    fail(block,
         label_text(*block.o_word) + " was used in " + line_text(known->second) +
             " for something else",
         "a label of its own");
  return span;
}

Flow::Frame& Flow::innermost(const Block& block, FlowKeyword keyword, FlowKeyword kind) {
  if (!frames_.empty() && frames_.back().span != nullptr) {
    const FlowSpan& span = *frames_.back().span;
    if (span.kind == kind && span.o_word.label == block.o_word->label) return frames_.back();
  }
  fail(block,
       "'" + o_text(*block.o_word, keyword) + "' without '" + o_text(*block.o_word, kind) + "'",
       "'" + o_text(*block.o_word, kind) + "' before it");
}

double Flow::value(const Block& block, FlowKeyword keyword) {
  const std::vector<double> values = lexer_.arguments(block);
  if (values.size() != 1)
    fail(block,
         "'" + o_text(*block.o_word, keyword) + "' with " +
             (values.empty() ? "no value" : "more than one value"),
         "one value in brackets");
  return values.front();
}

void Flow::no_values(const Block& block, FlowKeyword keyword) {
  if (!lexer_.arguments(block).empty())
    fail(block, "a value behind '" + o_text(*block.o_word, keyword) + "'", "no value");
}

}  // namespace limitgauge::model::gcode
