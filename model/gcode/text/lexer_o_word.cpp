// The lexer's part for lines that begin with an O word.
#include "model/gcode/flow/flow_keyword.h"
#include "model/gcode/text/lexer.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

/// As LinuxCNC's int holds.
constexpr std::size_t kMostDigits = 9;

/// LinuxCNC takes 30 for a call.
constexpr std::size_t kMostArguments = 100;

constexpr std::size_t kNone = std::string_view::npos;
constexpr std::string_view kBlanks = " \t\r";

std::size_t end_of_name(std::string_view line, std::size_t begin) {
  const std::size_t end = line.find_first_of(">(;<", begin);
  const bool empty = line.find_first_not_of(kBlanks, begin) == end;
  return end == kNone || empty || line[end] != '>' ? kNone : end + 1;
}

std::size_t end_of_number(std::string_view line, std::size_t begin) {
  std::size_t at = begin, digits = 0;
  for (; at < line.size() && (is_digit(line[at]) || is_blank(line[at])); ++at) {
    if (is_digit(line[at]) && (digits > 0 || line[at] != '0')) ++digits;
  }
  const bool any = line.find_first_not_of(kBlanks, begin) < at;
  return any && digits <= kMostDigits ? at : kNone;
}

/// Behind the name or number that stands at `at`; kNone where there is neither.
std::size_t end_of_label(std::string_view line, std::size_t at) {
  const std::size_t begin = line.find_first_not_of(kBlanks, at);
  if (begin == kNone) return kNone;
  return line[begin] == '<' ? end_of_name(line, begin + 1) : end_of_number(line, begin);
}

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
    block.line = block.main_line = line_;
    block.block_delete = block_delete;
    read_o_word(block);
    return true;
  }
  return false;
}

/// To an O word behind `/` and a line number whose label and keyword can be read. A calculated
/// number is that of a call, whose parameters may not be set yet.
bool Lexer::skip_to_o() {
  if (cursor_.line.size() > kMostLineBytes) return false;
  if (!at_end() && here() == '/') ++cursor_.at;
  while (rules_.numbered_skips && !at_end() && is_digit(here())) ++cursor_.at;
  skip_blanks();
  if (!at_end() && upper(here()) == 'N') {
    ++cursor_.at;
    while (!at_end() && (is_digit(here()) || here() == '.' || is_blank(here()))) ++cursor_.at;
  }
  if (!begins_o_word()) return false;
  const std::size_t end = end_of_label(cursor_.line, cursor_.at + 1);
  const std::size_t keyword = end == kNone ? kNone : cursor_.line.find_first_not_of(kBlanks, end);
  if (keyword == kNone) return end != kNone;
  const char c = cursor_.line[keyword];
  return is_letter(c) || c == '(' || c == ';';
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

/// The keyword that the letters begin with, as LinuxCNC finds it; all letters where there is none.
void Lexer::read_keyword(OWord& o_word) {
  skip_blanks();
  const std::size_t begin = cursor_.at;
  o_word.keyword_column = column_of(begin);
  for (; !at_end() && (is_letter(here()) || is_blank(here())); ++cursor_.at) {
    if (is_letter(here())) o_word.keyword += lower(here());
  }
  if (const std::size_t length = keyword_length(o_word.keyword); length > 0) {
    o_word.keyword.resize(length);
    cursor_.at = begin;
    for (std::size_t letters = 0; letters < length; ++cursor_.at) {
      if (is_letter(here())) ++letters;
    }
  }
  o_word.rest = cursor_.at;
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
      fail(cursor_.at, "more than 100 values behind an O word", "100 at most");
    if (here() != '[')
      fail(cursor_.at, in_quotes(here()) + " behind an O word", "values in brackets, or a comment");
    values.push_back(read_value(cursor_, parameters_, fail_));
  }
  return values;
}

}  // namespace limitgauge::model::gcode
