// Flow's part for macro B: GOTO, loops, G65 and calls of numbered blocks.
#include <algorithm>
#include <array>

#include "model/gcode/flow/flow.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr double kLargestMacro = 99'999'999;
constexpr double kLargestBlock = 99'999'999;
constexpr double kMostMacroRuns = 1e9;
constexpr int kArgumentSets = 10;  ///< of I, J and K

std::string block_name(int number) {
  return "N" + std::to_string(number);
}

/// The variable that an argument of G65 is handed over in (B-63684EN, 16.8.1, argument
/// specification I); 0: no argument.
int variable_of(char letter) {
  constexpr std::array kVariables = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                     0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  const bool is_letter = letter >= 'A' && letter <= 'Z';
  return is_letter ? kVariables[static_cast<std::size_t>(letter - 'A')] : 0;
}

}  // namespace

void Flow::carry_out_macro(const Block& block) {
  const MacroWord& word = *block.macro;
  switch (word.keyword) {
    case MacroKeyword::go_to:
      return jump(block, word.column, word.number, lexer_.line_bookmark());
    case MacroKeyword::begin_while:
    case MacroKeyword::begin_do:
      return begin_loop(block);
    case MacroKeyword::end:
      return end_loop(block);
  }
}

/// To block N`number` of the program that `from` stands in; out of loops that it does not lie in.
void Flow::jump(const Block& block, std::uint32_t column, int number, Lexer::Bookmark from) {
  const NumberedBlock& target = numbered_block(block, column, number, from);
  while (!frames_.empty() && frames_.back().loop != 0) {
    const Frame& frame = frames_.back();
    const bool inside = target.before.at > frame.begin.at && target.before.at <= frame.back.at;
    if (inside) break;
    frames_.pop_back();
  }
  if (!jump_) {
    jump_ = Frame{};
    jump_->begin = {target.before.at, target.before.line};
    jump_->column = target.column;
  }
  lexer_.go_to(target.before);
}

const NumberedBlock& Flow::numbered_block(const Block& block, std::uint32_t column, int number,
                                          Lexer::Bookmark from) {
  const NumberedBlock* const found = marks_.block(number, from);
  if (found == nullptr)
    lexer_.fail_at(block.line, column, "no block " + block_name(number) + " in this program",
                   "the number of a block");
  if (found->second_line != 0)
    lexer_.fail_at(block.line, column,
                   "two blocks " + block_name(number) + ", in lines " +
                       std::to_string(lexer_.place(found->before.line, 1).line) + " and " +
                       std::to_string(lexer_.place(found->second_line, 1).line),
                   "one of that number");
  return *found;
}

/// Each turn comes here again.
void Flow::begin_loop(const Block& block) {
  const MacroWord& word = *block.macro;
  const Lexer::Bookmark here = lexer_.line_bookmark();
  const LoopEnd* const end = marks_.end_of_loop(here);
  if (end == nullptr)
    lexer_.fail_at(block.line, word.column,
                   "DO " + std::to_string(word.number) + " without its END",
                   "END " + std::to_string(word.number));
  const bool again = !frames_.empty() && frames_.back().loop == word.number &&
                     frames_.back().begin.line == here.line;
  if (!word.holds) {
    if (again) frames_.pop_back();
    return lexer_.go_to(end->behind);
  }
  if (again) return;
  for (auto frame = frames_.rbegin(); frame != frames_.rend() && frame->loop != 0; ++frame) {
    if (frame->loop == word.number)
      lexer_.fail_at(block.line, word.column,
                     "DO " + std::to_string(word.number) + " within a loop of that number",
                     "1, 2 and 3 for loops within each other");
  }
  Frame frame;
  frame.loop = word.number;
  frame.begin = here;
  frame.back = end->before;
  push(block, word.column, frame);
}

void Flow::end_loop(const Block& block) {
  const MacroWord& word = *block.macro;
  if (frames_.empty() || frames_.back().loop != word.number)
    lexer_.fail_at(block.line, word.column,
                   "END " + std::to_string(word.number) + " of a loop that is not open",
                   "DO " + std::to_string(word.number) + " before it");
  lexer_.go_to(frames_.back().begin);
}

/// G65 P: the other words are arguments.
void Flow::call_macro(Block& block) {
  const Word *p = nullptr, *l = nullptr;
  Parameters::MacroArguments arguments;
  int sets = 0;
  char last = 0;
  for (std::size_t i = 1; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    const Word** const place = word.letter == 'P' ? &p : word.letter == 'L' ? &l : nullptr;
    if (place != nullptr) {
      if (*place != nullptr) fail_at(block, word, "twice in a block with G65", "once");
      *place = &word;
      continue;
    }
    int variable = variable_of(word.letter);
    if (variable == 0) fail_at(block, word, "is no argument of G65", "other letters");
    // Argument specification II: I, J and K may come ten times.
    const bool in_set = word.letter >= 'I' && word.letter <= 'K';
    if (in_set && (sets == 0 || word.letter <= last)) ++sets;
    if (in_set) last = word.letter;
    if (sets > kArgumentSets) fail_at(block, word, "of an eleventh I, J, K", "ten at most");
    if (in_set) variable += 3 * (sets - 1);
    arguments[static_cast<std::size_t>(variable)] = word.value;
  }
  if (p == nullptr)
    lexer_.fail_at(block.line, block.words.front().column, "G65 without the number of a program",
                   "P");
  double runs = l == nullptr ? 1 : whole(block, *l, kMostMacroRuns);
  const double number = whole(block, *p, kLargestMacro);
  Frame frame = call_frame();
  frame.subroutine = &program_numbered(block, *p, number);
  if (runs == 0) return;
  frame.left = runs;
  frame.arguments = arguments;
  push_call(block, block.words.front().column, frame);
  parameters_.enter_macro(arguments);
  if (doubts_arguments_) note_doubtful_arguments(block);
  lexer_.go_to(frame.subroutine->body);
}

/// What Fanuc and Haas take in the least increment of the word's own (B-63684EN, 16.8.1; Haas,
/// "Integer argument passing") unless they are set otherwise.
void Flow::note_doubtful_arguments(Block& block) {
  constexpr std::string_view kInIncrements = "ABCIJKQRUVWXYZ";
  const auto doubtful = std::find_if(block.words.begin(), block.words.end(), [&](const Word& word) {
    return kInIncrements.find(word.letter) != std::string_view::npos && word.lacks_point();
  });
  if (doubtful == block.words.end()) return;
  doubts_arguments_ = false;
  block.notes.push_back(
      in_quotes(doubtful->text) +
      " and other arguments of G65 without a decimal point are taken to be whole numbers; a "
      "control that is set otherwise counts its increments, thousandths or less");
}

/// M97 P: the blocks from number P on, to M99.
void Flow::call_local(const Block& block) {
  const Word *p = nullptr, *l = nullptr;
  take_call_words(block, p, l);
  const int number = static_cast<int>(whole(block, *p, kLargestBlock));
  const NumberedBlock& target = numbered_block(block, p->column, number, lexer_.line_bookmark());
  FlowSubroutine& local = locals_[target.before.line];
  local.label = block_name(number);
  local.is_program = local.is_local = true;
  local.line = target.before.line;
  local.column = target.column;
  local.open = local.body = target.before;
  Frame frame = call_frame();
  frame.subroutine = &local;
  frame.left = l == nullptr ? 1 : whole(block, *l, kMostMacroRuns);
  if (frame.left == 0) return;
  push_call(block, block.words.front().column, frame);
  parameters_.enter();
  lexer_.go_to(local.body);
}

/// The words from M97, M98, M99 or G65 on are a block of their own, behind what stands before them.
bool Flow::split_call(Block& block) {
  const auto calls = [](const Word& word) {
    return (word.letter == 'M' && word.value >= 97 && word.value <= 99) ||
           (word.letter == 'G' && word.value == 65);
  };
  const auto call = std::find_if(block.words.begin(), block.words.end(), calls);
  if (call == block.words.end()) return false;
  std::vector<Word> own(call, call + 1), others(block.words.begin(), call);
  for (auto word = call + 1; word != block.words.end(); ++word) {
    const bool belongs = call->letter == 'G' || word->letter == 'P' || word->letter == 'L';
    (belongs ? own : others).push_back(*word);
  }
  if (others.empty()) return false;
  Block& rest = pending_.emplace(block);
  rest.words = std::move(own);
  rest.settings.clear();
  rest.comments.clear();
  rest.notes.clear();
  rest.block_delete = false;
  block.words = std::move(others);
  return true;
}

void Flow::fail_at(const Block& block, const Word& word, const std::string& wrong,
                   const std::string& expected) const {
  lexer_.fail_at(block.line, word.column, in_quotes(word.text) + " " + wrong, expected);
}

}  // namespace limitgauge::model::gcode
