// The lexer's part for macro B (Fanuc B-63684EN, chapter 16; Haas 96-8210, "Macros").
#include "model/gcode/text/lexer.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::size_t kLongestKeyword = 5;
constexpr int kMostLoops = 3;
constexpr int kLargestBlockNumber = 99'999'999;

/// Letters of words that are lengths or angles.
constexpr std::string_view kLengthLetters = "XYZIJKRQ", kAngleLetters = "ABC";

}  // namespace

double steps_in_unit(char letter, bool in_inches) {
  constexpr double kSteps = 1000, kStepsInch = 10'000;
  if (kAngleLetters.find(letter) != std::string_view::npos) return kSteps;
  if (kLengthLetters.find(letter) == std::string_view::npos) return 0;
  return in_inches ? kStepsInch : kSteps;
}

std::optional<bool> inches_stated(const Block& block) {
  for (const Word& word : block.words)
    if (word.letter == 'G' && (word.value == 20 || word.value == 21)) return word.value == 20;
  return std::nullopt;
}

/// The next letters without blanks, in lower case; as many as a keyword has.
std::string Lexer::letters_ahead() const {
  std::string letters;
  for (std::size_t at = cursor_.at; at < cursor_.line.size() && letters.size() < kLongestKeyword;
       ++at) {
    if (is_blank(cursor_.line[at])) continue;
    if (!is_letter(cursor_.line[at])) break;
    letters += lower(cursor_.line[at]);
  }
  return letters;
}

void Lexer::skip_letters(std::size_t letters) {
  for (; letters > 0; ++cursor_.at) {
    if (!is_blank(here())) --letters;
  }
  skip_blanks();
}

/// False where the line is none of macro B's statements; it is then read as any other.
bool Lexer::read_macro(Block& block) {
  const std::size_t begin = cursor_.at;
  const std::string letters = letters_ahead();
  if (letters == "if") {
    read_condition(block);
  } else if (letters == "while") {
    skip_letters(5);
    const double condition = read_value(cursor_, parameters_, fail_, rules_);
    skip_blanks();
    read_loop(block, begin, condition != 0);
  } else if (letters == "do" || letters == "end") {
    read_loop(block, begin, true);
  } else if (letters.starts_with("goto")) {
    read_go_to(block, begin);
  } else {
    return false;
  }
  return true;
}

void Lexer::read_condition(Block& block) {
  const std::size_t begin = cursor_.at;
  skip_letters(2);
  if (at_end() || here() != '[') fail(begin, "IF without its condition", "IF [...]");
  const bool holds = read_value(cursor_, parameters_, fail_, rules_) != 0;
  skip_blanks();
  const std::string letters = letters_ahead();
  const bool jumps = letters.starts_with("goto"), sets = letters.starts_with("then");
  if (!jumps && !sets) fail(cursor_.at, "IF without GOTO or THEN", "GOTO and a block, or THEN");
  if (!holds) {
    cursor_.at = cursor_.line.size();
    return;
  }
  if (jumps) return read_go_to(block, cursor_.at);
  skip_letters(4);
  read_items(block);
}

void Lexer::read_go_to(Block& block, std::size_t begin) {
  skip_letters(4);
  const std::size_t at = cursor_.at;
  if (at_end()) fail(begin, "GOTO without the number of a block", "GOTO and a number");
  const int number = read_whole_value(cursor_, parameters_, fail_, rules_);
  if (number < 1 || number > kLargestBlockNumber)
    fail(at, "GOTO " + std::to_string(number), "the number of a block, from 1 on");
  block.macro = MacroWord{MacroKeyword::go_to, column_of(begin), number, true};
  skip_blanks();
  read_items(block);
  if (!block.words.empty() || !block.settings.empty())
    fail(begin, "GOTO beside other words", "GOTO alone, or behind IF");
}

/// `DO 1` and `END 1`; `begin` is where WHILE stands, or they do.
void Lexer::read_loop(Block& block, std::size_t begin, bool holds) {
  const bool is_while = begin != cursor_.at;
  const bool is_end = letters_ahead() == "end";
  if (is_end) {
    skip_letters(3);
  } else if (letters_ahead() == "do") {
    skip_letters(2);
  } else {
    fail(begin, "WHILE without DO", "WHILE [...] DO and 1, 2 or 3");
  }
  const std::size_t at = cursor_.at;
  if (at_end()) fail(begin, "a loop without its number", "1, 2 or 3");
  const int number = read_whole_value(cursor_, parameters_, fail_, rules_);
  if (number < 1 || number > kMostLoops)
    fail(at, "loop " + std::to_string(number), "DO and END with 1, 2 or 3");
  block.macro = MacroWord{is_end     ? MacroKeyword::end
                          : is_while ? MacroKeyword::begin_while
                                     : MacroKeyword::begin_do,
                          column_of(begin), number, holds};
  skip_blanks();
  read_items(block);
  if (!block.words.empty() || !block.settings.empty())
    fail(begin, "DO or END beside other words", "a block of its own");
}

namespace {

/// Digits at `at`, blanks among them; moves behind them.
std::optional<int> digits_at(std::string_view line, std::size_t& at) {
  std::optional<int> number;
  for (; at < line.size() && (is_digit(line[at]) || is_blank(line[at])); ++at) {
    if (!is_digit(line[at])) continue;
    if (number.value_or(0) > kLargestBlockNumber) return std::nullopt;
    number = number.value_or(0) * 10 + (line[at] - '0');
  }
  return number;
}

/// DO or END in a line that may hold anything before it; nothing where there is none.
std::optional<MacroWord> loop_in(std::string_view line) {
  std::string plain;
  for (const char c : line.substr(0, line.find('('))) {
    if (!is_blank(c)) plain += lower(c);
  }
  const std::size_t end = plain.starts_with("end") ? 0 : std::string::npos;
  const std::size_t begin = plain.starts_with("while[") ? plain.rfind("]do") + 1
                            : plain.starts_with("do")   ? 0
                                                        : std::string::npos;
  const bool ends = end == 0;
  if (!ends && (begin == std::string::npos || plain.compare(begin, 2, "do") != 0))
    return std::nullopt;
  const std::size_t digit = ends ? 3 : begin + 2;
  if (digit >= plain.size() || !is_digit(plain[digit])) return std::nullopt;
  return MacroWord{ends ? MacroKeyword::end : MacroKeyword::begin_do, 1, plain[digit] - '0', true};
}

}  // namespace

bool Lexer::skip_to_mark(Mark& mark) {
  mark = {};
  for (Bookmark before = next_; take_line(); before = next_) {
    if (percent() == Percent::closing) {
      next_ = before;
      return false;
    }
    if (cursor_.line.size() > kMostLineBytes) continue;
    if (!at_end() && here() == '/') ++cursor_.at;
    while (rules_.numbered_skips && !at_end() && is_digit(here())) ++cursor_.at;
    skip_blanks();
    mark.column = column_of(cursor_.at);
    if (!at_end() && upper(here()) == 'N') {
      std::size_t at = cursor_.at + 1;
      mark.number = digits_at(cursor_.line, at);
      cursor_.at = at;
    }
    mark.begins_program = begins_o_word();
    mark.loop = loop_in(cursor_.line.substr(std::min(cursor_.at, cursor_.line.size())));
    if (mark.number || mark.begins_program || mark.loop) return true;
  }
  return false;
}

}  // namespace limitgauge::model::gcode
