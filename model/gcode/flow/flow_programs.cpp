#include <cmath>

#include "model/base/tolerance.h"
#include "model/gcode/flow/flow.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr double kLargestProgram = 99'999'999;  // eight digits, as Fanuc's newer controls
constexpr double kOldPrograms = 10'000;         // older ones have four, and the count before them
constexpr double kMostRuns = 1e9;

std::string number_text(double whole) {
  return std::to_string(static_cast<long long>(whole));
}

}  // namespace

/// False for M codes that have nothing to do with subprograms.
bool Flow::carry_out_code(const Block& block) {
  const double code = block.words.front().value;
  if (code == 98) call_program(block);
  if (code == 99) return_from_program(block);
  return code == 98 || code == 99;
}

void Flow::call_program(const Block& block) {
  const Word& m98 = block.words.front();
  const Word *p = nullptr, *l = nullptr;
  for (std::size_t i = 1; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    const Word*& place = word.letter == 'P' ? p : l;
    if ((word.letter != 'P' && word.letter != 'L') || place != nullptr)
      lexer_.fail_at(block.line, word.column, in_quotes(word.text) + " in a block with M98",
                     "M98, P and L only, once each");
    place = &word;
  }
  if (p == nullptr)
    lexer_.fail_at(block.line, m98.column, "M98 without the number of a program", "P");
  double runs = l == nullptr ? 1 : whole(block, *l, kMostRuns);
  Frame frame;
  frame.begin = lexer_.line_bookmark();
  frame.back = lexer_.bookmark();
  frame.subroutine = &called_program(block, *p, l, runs);
  if (runs == 0) return;
  frame.left = runs;
  push_call(block, m98.column, frame);
  parameters_.enter();
  lexer_.go_to(frame.subroutine->body);
}

/// P31000 is three times program 1000 on controls with program numbers of four digits.
FlowSubroutine& Flow::called_program(const Block& block, const Word& p, const Word* l,
                                     double& runs) {
  const double number = whole(block, p, kLargestProgram);
  const double old_number = std::fmod(number, kOldPrograms);
  const std::string label = number_text(number), old_label = number_text(old_number);
  FlowSubroutine* const program = subroutines_.program(label);
  FlowSubroutine* const old =
      l == nullptr && number >= kOldPrograms ? subroutines_.program(old_label) : nullptr;
  const double old_runs = (number - old_number) / kOldPrograms;
  if (program != nullptr && old != nullptr)
    lexer_.fail_at(block.line, p.column,
                   "M98 P" + label + " may be program " + label + ", or " + number_text(old_runs) +
                       " times program " + old_label,
                   "L behind it, or other numbers");
  if (program == nullptr && old == nullptr) {
    if (subroutines_.sub(label) != nullptr)
      lexer_.fail_at(block.line, p.column, "o" + label + " is a subroutine, which M98 cannot call",
                     "'o" + label + " call'");
    lexer_.fail_at(block.line, p.column, "program O" + label + " is not in this file",
                   "'O" + label + "' at the beginning of a line; other files are not read");
  }
  if (program == nullptr) runs = old_runs;
  FlowSubroutine& found = program != nullptr ? *program : *old;
  checked(block, p.column, found);
  return found;
}

void Flow::return_from_program(const Block& block) {
  const Word& m99 = block.words.front();
  if (block.words.size() > 1)
    lexer_.fail_at(block.line, block.words[1].column,
                   in_quotes(block.words[1].text) + " in a block with M99", "M99 only");
  const Frame* const call = innermost_call();
  if (call == nullptr)
    lexer_.fail_at(block.line, m99.column,
                   "M99 in the main program, which would start again without end", "M2 or M30");
  if (!call->subroutine->is_program)
    lexer_.fail_at(block.line, m99.column, "M99 in subroutine o" + call->subroutine->label,
                   "endsub or return");
  Frame frame = pop_call();
  set_returned(std::nullopt);
  if (--frame.left < 1) return lexer_.go_to(frame.back);
  lexer_.go_to(frame.subroutine->body);
  frames_.push_back(frame);
  ++calls_;
  parameters_.enter();
}

/// A program's number in passing: the main program's, as a rule.
void Flow::begin_program(const Block& block) {
  no_values(block, FlowKeyword::program);
  if (const Frame* outer = innermost_call())
    fail(block,
         "program O" + block.o_word->label + " begins before O" + outer->subroutine->label +
             " has ended",
         "M99 before it");
}

double Flow::whole(const Block& block, const Word& word, double most) const {
  const double nearest = std::round(word.value);
  if (std::abs(word.value - nearest) > kWholeCount || nearest < 0 || nearest > most)
    lexer_.fail_at(block.line, word.column, in_quotes(word.text) + " in a block with M98",
                   "an integer from 0 to " + number_text(most));
  return nearest;
}

}  // namespace limitgauge::model::gcode
