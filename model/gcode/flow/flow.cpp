#include "model/gcode/flow/flow.h"

#include <algorithm>

namespace limitgauge::model::gcode {
namespace {

bool may_move(const Block& block) {
  return std::any_of(block.words.begin(), block.words.end(), [](const Word& word) {
    return (word.letter >= 'X' && word.letter <= 'Z') || (word.letter >= 'I' && word.letter <= 'K');
  });
}

}  // namespace

Flow::Flow(Lexer& lexer, Parameters& parameters, FlowLimits limits)
    : lexer_(lexer),
      parameters_(parameters),
      limits_(limits),
      spans_(lexer, limits.most_depth),
      subroutines_(lexer) {
  set_returned(std::nullopt);
}

bool Flow::next(Block& block) {
  while (lexer_.next(block)) {
    if (!frames_.empty()) count(block);
    if (!block.settings.empty()) set(block.settings);
    if (block.o_word) {
      carry_out(block);
    } else if (block.words.empty() || block.words.front().letter != 'M' || !carry_out_code(block)) {
      return true;
    }
    if (block.block_delete) {
      block.words.clear();
      return true;
    }
  }
  check_end();
  return false;
}

void Flow::count(const Block& block) {
  const Lexer::Bookmark before = frames_.front().begin;
  const std::size_t times = limits_.most_times_before;
  ++blocks_;
  bytes_ += lexer_.bookmark().at - lexer_.line_bookmark().at;
  idle_blocks_ = may_move(block) ? 0 : idle_blocks_ + 1;
  if (idle_blocks_ > limits_.most_idle_blocks)
    fail_without_end(std::to_string(limits_.most_idle_blocks) + " blocks without a motion");
  if (blocks_ > limits_.most_blocks + times * before.line)
    fail_without_end(std::to_string(blocks_ - 1) + " blocks in loops and subroutines");
  if (bytes_ > limits_.most_bytes + times * before.at)
    fail_without_end(std::to_string(limits_.most_bytes / 1'000'000) +
                     " MB of blocks in loops and subroutines");
}

/// At the outermost loop or call: which of its blocks is the one too many says nothing.
void Flow::fail_without_end(const std::string& amount) const {
  const Frame& outermost = frames_.front();
  lexer_.fail_at(outermost.begin.line, outermost.column, "a loop without end: more than " + amount,
                 "a loop that ends");
}

void Flow::set(const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) {
    if (setting.parameter.name.empty()) {
      parameters_.set(setting.parameter.number, setting.value);
    } else {
      parameters_.set(setting.parameter.name, setting.value);
    }
  }
}

/// Spans end where they begin; only a program may lack its end.
void Flow::check_end() const {
  const Frame* const call = innermost_call();
  if (call == nullptr) return;
  lexer_.fail_at(call->subroutine->line, call->subroutine->column,
                 "program O" + call->subroutine->label + " has no end",
                 "M99 behind its last block");
}

void Flow::carry_out(const Block& block) {
  const FlowKeyword keyword = keyword_of(block, lexer_);
  switch (keyword) {
    case FlowKeyword::program:
      return begin_program(block);
    case FlowKeyword::sub:
      return define(block);
    case FlowKeyword::endsub:
    case FlowKeyword::return_:
      return return_from_sub(block, keyword);
    case FlowKeyword::call:
      return call(block);
    case FlowKeyword::do_:
      return begin_do(block);
    case FlowKeyword::while_:
      return ends_do(block) ? end_do(block) : begin_while(block);
    case FlowKeyword::endwhile:
      return end_while(block);
    case FlowKeyword::break_:
      return break_loop(block);
    case FlowKeyword::continue_:
      return continue_loop(block);
    case FlowKeyword::if_:
      return begin_if(block);
    case FlowKeyword::elseif:
    case FlowKeyword::else_:
      return branch(block, keyword);
    case FlowKeyword::endif:
      return end_if(block);
    case FlowKeyword::repeat:
      return begin_repeat(block);
    case FlowKeyword::endrepeat:
      return end_repeat(block);
  }
}

void Flow::push(const Block& block, std::uint32_t column, const Frame& frame) {
  if (frames_.size() >= limits_.most_depth)
    lexer_.fail_at(block.line, column,
                   "more than " + std::to_string(limits_.most_depth) +
                       " loops, conditions and calls within each other",
                   "fewer");
  if (frames_.empty()) idle_blocks_ = 0;
  frames_.push_back(frame);
  if (frame.span != nullptr) frames_.back().begin = frame.span->open;
  frames_.back().column = column;
}

void Flow::fail(const Block& block, const std::string& wrong, const std::string& expected) const {
  lexer_.fail_at(block.line, block.o_word->column, wrong, expected);
}

}  // namespace limitgauge::model::gcode
