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
  const ControlRules& rules = lexer_.rules();
  if (!rules.subprograms) return false;
  if (code == 98) call_program(block);
  if (code == 99) return_from_program(block);
  const bool local = code == 97 && rules.local_subprograms;
  if (local) call_local(block);
  return code == 98 || code == 99 || local;
}

/// Of a call that is about to begin.
Flow::Frame Flow::call_frame() const {
  Frame frame;
  frame.begin = lexer_.line_bookmark();
  frame.back = lexer_.bookmark();
  return frame;
}

void Flow::take_call_words(const Block& block, const Word*& p, const Word*& l) const {
  const Word& code = block.words.front();
  const std::string name = "M" + number_text(code.value);
  for (std::size_t i = 1; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    const bool repeats = word.letter == 'L' || (word.letter == 'Q' && lexer_.rules().repeats_by_q);
    const Word*& place = word.letter == 'P' ? p : l;
    if ((word.letter != 'P' && !repeats) || place != nullptr)
      lexer_.fail_at(block.line, word.column, in_quotes(word.text) + " in a block with " + name,
                     name + ", P and L only, once each");
    place = &word;
  }
  if (p == nullptr)
    lexer_.fail_at(block.line, code.column, name + " without the number of a program", "P");
}

void Flow::call_program(const Block& block) {
  const Word& m98 = block.words.front();
  const Word *p = nullptr, *l = nullptr;
  take_call_words(block, p, l);
  double runs = l == nullptr ? 1 : whole(block, *l, kMostRuns);
  Frame frame = call_frame();
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
  FlowSubroutine* program = subroutines_.program(label);
  FlowSubroutine* const old =
      l == nullptr && number >= kOldPrograms ? subroutines_.program(old_label) : nullptr;
  const double old_runs = (number - old_number) / kOldPrograms;
  if (program != nullptr && old != nullptr)
    lexer_.fail_at(block.line, p.column,
                   "M98 P" + label + " may be program " + label + ", or " + number_text(old_runs) +
                       " times program " + old_label,
                   "L behind it, or other numbers");
  if (program == nullptr && old == nullptr) program = find_program(label);
  if (program == nullptr && old == nullptr) fail_missing(block, p, label);
  if (program == nullptr) runs = old_runs;
  FlowSubroutine& found = program != nullptr ? *program : *old;
  checked(block, p.column, found);
  return found;
}

/// In the file, or in one of its own.
FlowSubroutine* Flow::find_program(const std::string& label) {
  if (FlowSubroutine* const here = subroutines_.program(label)) return here;
  if (!find_subprogram_) return nullptr;
  std::optional<SubprogramFile> file = find_subprogram_(label);
  if (!file) return nullptr;
  subroutines_.add_file(lexer_.add(std::move(file->name), std::move(file->text)), label);
  return subroutines_.program(label);
}

FlowSubroutine& Flow::program_numbered(const Block& block, const Word& p, double number) {
  const std::string label = number_text(number);
  FlowSubroutine* const found = find_program(label);
  if (found == nullptr) fail_missing(block, p, label);
  checked(block, p.column, *found);
  return *found;
}

void Flow::fail_missing(const Block& block, const Word& p, const std::string& label) {
  if (subroutines_.sub(label) != nullptr)
    lexer_.fail_at(block.line, p.column, "o" + label + " is a subroutine, which M98 cannot call",
                   "'o" + label + " call'");
  if (find_subprogram_)
    lexer_.fail_at(
        block.line, p.column,
        "program O" + label + " is neither in this file nor in the folder of subprograms",
        "'O" + label + "' at the beginning of a line, or a file O" + label);
  lexer_.fail_at(block.line, p.column, "program O" + label + " is not in this file",
                 "'O" + label + "' at the beginning of a line; other files are not read");
}

void Flow::return_from_program(const Block& block) {
  const Word& m99 = block.words.front();
  const Word* p = nullptr;
  for (std::size_t i = 1; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    if (word.letter != 'P' || p != nullptr || !lexer_.rules().macro_b)
      lexer_.fail_at(block.line, word.column, in_quotes(word.text) + " in a block with M99",
                     "M99 only");
    p = &word;
  }
  const Frame* const call = innermost_call();
  const int block_number = p == nullptr ? 0 : static_cast<int>(whole(block, *p, kLargestProgram));
  if (call == nullptr && p != nullptr)
    return jump(block, p->column, block_number, lexer_.line_bookmark());
  if (call == nullptr)
    lexer_.fail_at(block.line, m99.column,
                   "M99 in the main program, which would start again without end", "M2 or M30");
  if (!call->subroutine->is_program)
    lexer_.fail_at(block.line, m99.column, "M99 in subroutine o" + call->subroutine->label,
                   "endsub or return");
  const Parameters::MacroArguments variables = parameters_.locals();
  Frame frame = pop_call();
  set_returned(std::nullopt);
  --frame.left;
  if (p != nullptr) return jump(block, p->column, block_number, frame.begin);
  if (frame.left < 1) return lexer_.go_to(frame.back);
  lexer_.go_to(frame.subroutine->body);
  frames_.push_back(frame);
  ++calls_;
  const bool once = lexer_.rules().arguments_once;
  if (frame.arguments) return parameters_.enter_macro(once ? variables : *frame.arguments);
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
