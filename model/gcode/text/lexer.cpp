#include "model/gcode/text/lexer.h"

#include <algorithm>
#include <utility>

#include "model/gcode/text/plain_number.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// RS274/NGC has no use for more; a file that is one long line must not fill the memory.
constexpr std::size_t kMostItems = 100;

}  // namespace

Lexer::Lexer(std::string_view text, std::string name, const Parameters& parameters)
    : text_(text),
      name_(std::move(name)),
      parameters_(parameters),
      fail_([this](std::size_t at, const std::string& wrong, const std::string& expected) {
        fail(at, wrong, expected);
      }) {
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text_.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text_[first] != '%') return;
  const std::size_t line_end = text_.rfind('\n', first);
  opening_percent_ = line_end == std::string_view::npos ? 0 : line_end + 1;
}

SourcePlace Lexer::place(std::uint32_t line, std::uint32_t column) const {
  return {name_, static_cast<int>(line), static_cast<int>(column)};
}

void Lexer::fail_at(std::uint32_t line, std::uint32_t column, const std::string& wrong,
                    const std::string& expected) const {
  throw InputError(place(line, column), wrong, expected);
}

void Lexer::fail(std::size_t at, const std::string& wrong, const std::string& expected) const {
  fail_at(line_, column_of(at), wrong, expected);
}

void Lexer::skip_blanks() {
  while (!at_end() && is_blank(here())) ++cursor_.at;
}

/// False at the end of the text.
bool Lexer::take_line() {
  line_ = next_.line;
  if (next_.at >= text_.size()) {
    cursor_ = {};
    return false;
  }
  const std::size_t end = std::min(text_.find('\n', next_.at), text_.size());
  cursor_ = {text_.substr(next_.at, end - next_.at), 0};
  next_ = {end + 1, next_.line + 1};
  skip_blanks();
  return true;
}

Lexer::Percent Lexer::percent() const {
  if (at_end() || here() != '%') return Percent::none;
  const auto begin = static_cast<std::size_t>(cursor_.line.data() - text_.data());
  return opening_percent_ == begin ? Percent::opening : Percent::closing;
}

void Lexer::check_percent() const {
  const std::size_t text = cursor_.line.find_first_not_of(" \t\r", cursor_.at + 1);
  if (text != std::string_view::npos) fail(text, "text after '%'", "'%' alone on its line");
  if (!opening_percent_)
    fail(cursor_.at, "'%' ends a program that no '%' began", "'%' on the first line too");
}

bool Lexer::next(Block& block) {
  block.clear();
  const Bookmark before = next_;
  if (!take_line()) {
    if (opening_percent_)
      fail(0, "the program that '%' began does not end; it may have been cut off",
           "'%', M2 or M30");
    return false;
  }
  block.line = line_;
  const Percent found = percent();
  if (found != Percent::none) check_percent();
  if (found == Percent::closing) next_ = before;
  if (found == Percent::none) read_line(block);
  return found != Percent::closing;
}

void Lexer::read_line(Block& block) {
  if (cursor_.line.size() > kMostLineBytes)
    fail(kMostLineBytes, "a line of more than 10000 bytes", "a line that ends sooner");
  if (!at_end() && here() == '/') {
    block.block_delete = true;
    ++cursor_.at;
    skip_blanks();
  }
  if (!at_end() && upper(here()) == 'N') {
    read_line_number(cursor_.at++);
    skip_blanks();
  }
  if (!at_end() && upper(here()) == 'O') return read_o_word(block);
  read_items(block);
}

void Lexer::read_items(Block& block) {
  for (std::size_t items = 0; !at_end(); skip_blanks()) {
    if (++items > kMostItems + 1)
      fail(cursor_.at, "more than 100 words and comments in one line", "a line that ends sooner");
    const char c = here();
    if (is_letter(c)) {
      read_word(block);
    } else if (c == '(' || c == ';') {
      read_comment(block);
    } else if (c == '#') {
      read_setting(block);
    } else {
      fail(cursor_.at, in_quotes(c) + " does not begin a word",
           "a letter and a number, or a comment");
    }
  }
}

void Lexer::read_comment(Block& block) {
  const std::size_t begin = cursor_.at;
  skip_comment();
  std::string_view text = cursor_.line.substr(begin, cursor_.at - begin);
  while (is_blank(text.back())) text.remove_suffix(1);
  block.comments.push_back({column_of(begin), text});
}

void Lexer::skip_comment() {
  const std::size_t begin = cursor_.at++;
  if (cursor_.line[begin] == ';') {
    cursor_.at = cursor_.line.size();
    return;
  }
  while (!at_end() && here() != ')') {
    if (here() == '(') fail(cursor_.at, "a comment inside a comment", "')' first");
    ++cursor_.at;
  }
  if (at_end()) fail(begin, "the comment does not end in its line", "')'");
  ++cursor_.at;
}

void Lexer::read_word(Block& block) {
  const std::size_t begin = cursor_.at++;
  const char letter = upper(cursor_.line[begin]);
  if (letter == 'N') fail(begin, "N after other words", "N at the beginning of the line");
  if (letter == 'O') fail(begin, "O after other words", "O at the beginning of the line");
  double value = 0;
  if (!read_plain_value(value)) value = read_general_value(begin);
  block.words.push_back(
      {letter, value, column_of(begin), cursor_.line.substr(begin, cursor_.at - begin)});
}

/// A number with at most one sign and no blanks inside; false without moving for all else.
bool Lexer::read_plain_value(double& value) {
  const char* const data = cursor_.line.data();
  const char* const limit = data + cursor_.line.size();
  const char* at = data + cursor_.at;
  const bool negative = at < limit && *at == '-';
  if (negative || (at < limit && *at == '+')) ++at;
  const std::optional<PlainNumber> number = read_plain_number(at, limit);
  if (!number) return false;
  at = number->end;
  while (at < limit && is_blank(*at)) ++at;
  if (at < limit && (is_digit(*at) || *at == '.')) return false;
  cursor_.at = static_cast<std::size_t>(number->end - data);
  value = negative ? -number->value : number->value;
  return true;
}

double Lexer::read_general_value(std::size_t word_begin) {
  if (!value_begins(cursor_))
    fail(word_begin,
         "the number of " + in_quotes(cursor_.line[word_begin]) + " is missing or malformed",
         "a number, a parameter, a function or an expression in brackets");
  return read_value(cursor_, parameters_, fail_);
}

void Lexer::read_setting(Block& block) {
  const std::size_t begin = cursor_.at++;
  Setting setting{{}, 0, column_of(begin)};
  setting.parameter = read_parameter_name(cursor_, parameters_, fail_);
  const ParameterName& name = setting.parameter;
  if (name.name.empty() ? !Parameters::is_settable(name.number)
                        : !Parameters::is_settable(name.name))
    fail(begin,
         "parameter " + in_quotes(cursor_.line.substr(begin, cursor_.at - begin)) +
             " belongs to the machine",
         "a code that sets it, as G10, or another parameter");
  skip_blanks();
  if (at_end() || here() != '=')
    fail(cursor_.at, "a parameter at the beginning of a word", "'=' and a value");
  ++cursor_.at;
  setting.value = read_value(cursor_, parameters_, fail_);
  block.settings.push_back(std::move(setting));
}

/// LinuxCNC takes decimals too.
void Lexer::read_line_number(std::size_t word_begin) {
  skip_blanks();
  if (at_end() || !is_digit(here()))
    fail(word_begin, "the number of 'N' is missing or malformed", "digits");
  double value = 0;
  if (!read_plain_value(value)) read_value(cursor_, parameters_, fail_);
}

}  // namespace limitgauge::model::gcode
