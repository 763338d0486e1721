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

Flow::Flow(Lexer& lexer, Parameters& parameters, FlowLimits limits, FindSubprogram find_subprogram)
    : lexer_(lexer),
      parameters_(parameters),
      limits_(limits),
      spans_(lexer, limits.most_depth),
      subroutines_(lexer),
      marks_(lexer),
      find_subprogram_(std::move(find_subprogram)) {
  set_returned(std::nullopt);
  if (lexer.rules().macro_b) parameters.use_macro_variables();
}

bool Flow::next(Block& block) {
  while (take(block)) {
    if (!frames_.empty() || jump_) count(block);
    if (!block.settings.empty()) set(block);
    if (lexer_.rules().call_beside_motion && split_call(block)) return true;
    if (!is_for_flow(block)) return true;
    if (block.block_delete || !block.notes.empty()) {
      block.words.clear();
      return true;
    }
  }
  check_end();
  return false;
}

/// The next block in the text, or the call that the block before ended with.
bool Flow::take(Block& block) {
  if (pending_) {
    block = std::move(*pending_);
    pending_.reset();
    return true;
  }
  if (!lexer_.next(block)) return false;
  name_main_line(block);
  return true;
}

/// Carries out what says which block comes next; false for all others.
bool Flow::is_for_flow(Block& block) {
  if (block.o_word) {
    carry_out(block);
  } else if (block.macro) {
    carry_out_macro(block);
  } else {
    const bool is_m = !block.words.empty() && block.words.front().letter == 'M';
    const bool is_macro = lexer_.rules().macro_b && !block.words.empty() &&
                          block.words.front().letter == 'G' && block.words.front().value == 65;
    if (is_macro) call_macro(block);
    return is_macro || (is_m && carry_out_code(block));
  }
  return true;
}

/// What a subprogram of another file does stands for the line of the main program that called it.
void Flow::name_main_line(Block& block) const {
  if (frames_.empty() || lexer_.text_index(lexer_.line_bookmark()) == 0) return;
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    if (lexer_.text_index(frame->begin) != 0) continue;
    block.main_line = frame->begin.line;
    return;
  }
}

void Flow::count(const Block& block) {
  const Lexer::Bookmark before = frames_.empty() ? jump_->begin : frames_.front().begin;
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
  const Frame& outermost = frames_.empty() ? *jump_ : frames_.front();
  lexer_.fail_at(outermost.begin.line, outermost.column, "a loop without end: more than " + amount,
                 "a loop that ends");
}

/// Macro B's #3000 is an alarm and #3006 a stop with a message.
void Flow::check_setting(const Block& block, const Setting& setting) const {
  if (setting.parameter.number == 3000)
    lexer_.fail_at(block.line, setting.column, "the program ends itself with an alarm (#3000)",
                   "values that it takes");
}

void Flow::set(Block& block) {
  for (const Setting& setting : block.settings) {
    if (lexer_.rules().macro_b) check_setting(block, setting);
    if (lexer_.rules().macro_b && setting.parameter.number == 3006)
      block.notes.push_back("the stop of #3006 is not acted on");
    const ParameterName& parameter = setting.parameter;
    if (!parameter.name.empty()) {
      parameters_.set(parameter.name, setting.value.value_or(0));
    } else if (setting.value) {
      parameters_.set(parameter.number, *setting.value);
    } else {
      parameters_.clear(parameter.number);
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
  const ControlRules& rules = lexer_.rules();
  if (!rules.subprograms)
    fail(block, std::string(rules.title) + " has no O words", "G and M codes");
  if (!rules.o_words && keyword != FlowKeyword::program)
    fail(block, "'" + o_text(*block.o_word, keyword) + "' is LinuxCNC's",
         rules.macro_b ? "IF, WHILE, G65 or M98" : "M98");
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
