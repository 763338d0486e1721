#include "model/gcode/flow/flow.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::size_t kMostArguments = 30;

std::string second_text(const FlowSubroutine& found) {
  return "there are two of that number, in lines " + std::to_string(found.line) + " and " +
         std::to_string(found.second_line);
}

}  // namespace

/// A definition is gone over; LinuxCNC takes it where nothing has been called.
void Flow::define(const Block& block) {
  no_values(block, FlowKeyword::sub);
  if (const Frame* outer = innermost_call())
    fail(block, "a subroutine inside program O" + outer->subroutine->label,
         "subroutines before the main program");
  if (const FlowSubroutine* sub = subroutines_.sub(block.o_word->label))
    checked(block, block.o_word->column, *sub);
  lexer_.go_to(spans_.opened_by(block, FlowKeyword::sub).behind);
}

const FlowSubroutine& Flow::checked(const Block& block, std::uint32_t column,
                                    const FlowSubroutine& found) const {
  if (found.second_line != 0)
    lexer_.fail_at(
        block.line, column,
        (found.is_program ? "program O" : "subroutine o") + found.label + ": " + second_text(found),
        "one only");
  return found;
}

void Flow::call(const Block& block) {
  Frame frame;
  frame.begin = lexer_.line_bookmark();
  frame.back = lexer_.bookmark();
  const std::vector<double> arguments = lexer_.arguments(block);
  if (arguments.size() > kMostArguments)
    fail(block, "a call with " + std::to_string(arguments.size()) + " values", "30 at most");
  const std::string& label = block.o_word->label;
  FlowSubroutine* const sub = subroutines_.sub(label);
  if (sub == nullptr && subroutines_.program(label) != nullptr)
    fail(block, "O" + label + " begins a program, which is not called like a subroutine",
         "M98 P" + label);
  if (sub == nullptr)
    fail(block, "subroutine " + label_text(*block.o_word) + " is not in this file",
         "'" + o_text(*block.o_word, FlowKeyword::sub) + "'; other files are not read");
  checked(block, block.o_word->column, *sub);
  find_span(*sub);
  frame.subroutine = sub;
  push_call(block, block.o_word->column, frame);
  parameters_.enter(arguments);
  lexer_.go_to(sub->body);
}

/// Looks through a subroutine that is called for the first time.
void Flow::find_span(FlowSubroutine& sub) {
  if (sub.span != nullptr) return;
  const Lexer::Bookmark here = lexer_.bookmark();
  lexer_.go_to(sub.open);
  Block head;
  lexer_.skip_to_o_word(head);
  sub.span = &spans_.opened_by(head, FlowKeyword::sub);
  lexer_.go_to(here);
}

void Flow::return_from_sub(const Block& block, FlowKeyword keyword) {
  const std::vector<double> values = lexer_.arguments(block);
  const std::string text = "'" + o_text(*block.o_word, keyword) + "'";
  if (values.size() > 1) fail(block, text + " with more than one value", "one value or none");
  const Frame* const call = innermost_call();
  if (call == nullptr) fail(block, text + " outside a subroutine", "a subroutine around it");
  const FlowSubroutine& sub = *call->subroutine;
  if (sub.is_program) fail(block, text + " in program O" + sub.label, "M99");
  // LinuxCNC returns from the subroutine that runs, whatever the label; only its end must have one.
  if (keyword == FlowKeyword::endsub && sub.label != block.o_word->label)
    fail(block, text + " in the subroutine of line " + std::to_string(sub.line),
         "'" + o_text(sub.span->o_word, keyword) + "'");
  lexer_.go_to(pop_call().back);
  set_returned(values.empty() ? std::nullopt : std::optional(values.front()));
}

void Flow::set_returned(std::optional<double> value) {
  parameters_.set("_value", value.value_or(0));
  parameters_.set("_value_returned", value ? 1 : 0);
}

const Flow::Frame* Flow::innermost_call() const {
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    if (frame->subroutine != nullptr) return &*frame;
  }
  return nullptr;
}

void Flow::push_call(const Block& block, std::uint32_t column, const Frame& frame) {
  if (calls_ >= limits_.most_calls)
    lexer_.fail_at(block.line, column,
                   "more than " + std::to_string(limits_.most_calls) +
                       " calls within each other, LinuxCNC's limit",
                   "fewer; a recursion that ends");
  push(block, column, frame);
  ++calls_;
}

/// Ends the innermost call with all that it has left open.
Flow::Frame Flow::pop_call() {
  while (frames_.back().subroutine == nullptr) frames_.pop_back();
  const Frame call = frames_.back();
  frames_.pop_back();
  --calls_;
  parameters_.leave();
  return call;
}

}  // namespace limitgauge::model::gcode
