// The lexer's part for lines that begin with an O word.
#include "engine/model/gcode/characters.h"
#include "engine/model/gcode/lexer.h"

namespace limitgauge::model::gcode {
namespace {

/// As LinuxCNC's int holds.
constexpr std::size_t kMostDigits = 9;

/// LinuxCNC takes 30; each more would be work without end for a file of one line.
constexpr std::size_t kMostArguments = 30;

}  // namespace

bool Lexer::skip_to_o_word(Block& block) {
  block.clear();
  for (Bookmark before = next_; take_line(); before = next_) {
    if (percent() == Percent::closing) {
      next_ = before;
      return false;
    }
    const bool block_delete = !at_end() && here() == '/';
    if (!skip_to_o()) continue;
    block.line = line_;
    block.block_delete = block_delete;
    read_o_word(block);
    return true;
  }
  return false;
}

/// To an O word behind `/` and a line number, unless its number is calculated: that is a call, and
/// its parameters may not be set yet.
bool Lexer::skip_to_o() {
  if (!at_end() && here() == '/') ++cursor_.at;
  skip_blanks();
  if (!at_end() && upper(here()) == 'N') {
    ++cursor_.at;
    while (!at_end() && (is_digit(here()) || here() == '.' || is_blank(here()))) ++cursor_.at;
  }
  if (at_end() || upper(here()) != 'O') return false;
  const std::size_t label = cursor_.line.find_first_not_of(" \t\r", cursor_.at + 1);
  return label == std::string_view::npos ||
         (cursor_.line[label] != '#' && cursor_.line[label] != '[');
}

void Lexer::read_o_word(Block& block) {
  OWord& o_word = block.o_word.emplace();
  o_word.column = column_of(cursor_.at++);
  read_label(o_word);
  read_keyword(o_word);
  if (o_word.calculated && o_word.keyword != "call")
    fail(o_word.column - 1, "an O word with a calculated number that is no call",
         "digits or a name in '<' and '>'");
}

void Lexer::read_label(OWord& o_word) {
  skip_blanks();
  const std::size_t begin = cursor_.at;
  o_word.named = !at_end() && here() == '<';
  o_word.calculated = !at_end() && (here() == '[' || here() == '#');
  if (o_word.named) {
    o_word.label = read_name(cursor_, fail_);
  } else if (o_word.calculated) {
    const int number = read_whole_value(cursor_, parameters_, fail_);
    if (number < 0) fail(begin, "a negative O word", "0 or more");
    o_word.label = std::to_string(number);
  } else {
    for (; !at_end() && (is_digit(here()) || is_blank(here())); ++cursor_.at) {
      if (o_word.label == "0") o_word.label.clear();
      if (is_digit(here())) o_word.label += here();
    }
    if (o_word.label.empty() || o_word.label.size() > kMostDigits)
      fail(begin, "an O word without its number or name", "O and up to 9 digits, or O<name>");
  }
}

void Lexer::read_keyword(OWord& o_word) {
  constexpr std::size_t kMostLetters = 20;
  skip_blanks();
  o_word.keyword_column = column_of(cursor_.at);
  for (; !at_end() && (is_letter(here()) || is_blank(here())); ++cursor_.at) {
    if (is_blank(here())) continue;
    if (o_word.keyword.size() == kMostLetters)
      fail(o_word.keyword_column - 1, "an O word with too long a keyword", "sub, call, while, ...");
    o_word.keyword += lower(here());
  }
  o_word.rest = cursor_.at;
  const bool alone = at_end() || here() == '(' || here() == ';';
  if (o_word.keyword.empty() && !alone)
    fail(cursor_.at, shown(here()) + " behind an O word", "a keyword, as sub, call or while");
}

std::vector<double> Lexer::arguments(const Block& block) {
  std::vector<double> values;
  cursor_.at = block.o_word->rest;
  for (skip_blanks(); !at_end(); skip_blanks()) {
    if (here() == '(' || here() == ';') {
      skip_comment();
      continue;
    }
    if (values.size() == kMostArguments)
      fail(cursor_.at, "more than 30 values behind an O word", "30 at most");
    if (!value_begins(cursor_))
      fail(cursor_.at, shown(here()) + " behind an O word", "values in brackets, or a comment");
    values.push_back(read_value(cursor_, parameters_, fail_));
  }
  return values;
}

}  // namespace limitgauge::model::gcode
