#include "engine/model/gcode/lexer.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "engine/model/words.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// RS274/NGC has no use for more; a file that is one long line must not fill the memory.
constexpr std::size_t kMostItems = 100;

constexpr std::size_t kProgramDigits = 8;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}
bool is_numeral(char c) {
  return (c >= '0' && c <= '9') || c == '.';
}
bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7F) return in_quotes(std::string_view(&c, 1));
  constexpr std::string_view kDigits = "0123456789abcdef";
  return std::string("byte 0x") + kDigits[byte / 16] + kDigits[byte % 16];
}

}  // namespace

void Block::clear() {
  block_delete = false;
  words.clear();
  comments.clear();
}

Lexer::Lexer(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
}

SourcePlace Lexer::place(std::uint32_t line, std::uint32_t column) const {
  return {name_, static_cast<int>(line), static_cast<int>(column)};
}

void Lexer::fail(std::size_t at, const std::string& wrong, const std::string& expected) const {
  throw InputError(place(line_, column_of(at)), wrong, expected);
}

void Lexer::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

void Lexer::end_line() {
  if (at_ < text_.size()) ++at_;
  ++line_;
  line_begin_ = at_;
}

bool Lexer::next(Block& block) {
  block.clear();
  if (at_ >= text_.size()) {
    if (in_percents_)
      fail(at_, "the program that '%' began does not end; it may have been cut off",
           "'%', M2 or M30");
    return false;
  }
  block.line = line_;
  skip_blanks();
  if (at_ < text_.size() && text_[at_] == '%') {
    if (take_percent()) return false;
  } else {
    read_line(block);
  }
  end_line();
  return true;
}

/// True for the `%` that ends the program.
bool Lexer::take_percent() {
  const std::size_t begin = at_++;
  skip_blanks();
  if (!at_line_end()) fail(at_, "text after '%'", "'%' alone on its line");
  if (in_percents_) return true;
  if (started_) fail(begin, "'%' ends a program that no '%' began", "'%' on the first line too");
  in_percents_ = started_ = true;
  return false;
}

void Lexer::read_line(Block& block) {
  if (!at_line_end() && text_[at_] == '/') {
    block.block_delete = true;
    ++at_;
    skip_blanks();
  }
  for (; !at_line_end(); skip_blanks()) {
    started_ = true;
    if (block.words.size() + block.comments.size() > kMostItems)
      fail(at_, "more than 100 words and comments in one line", "a line that ends sooner");
    const char c = text_[at_];
    if (is_letter(c)) {
      read_word(block);
    } else if (c == '(') {
      read_comment(block);
    } else if (c == ';') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (c == '#') {
      fail(at_, "parameters are not supported in this release", "plain numbers");
    } else {
      fail(at_, shown(c) + " does not begin a word", "a letter and a number, or a comment");
    }
  }
}

void Lexer::read_comment(Block& block) {
  const std::size_t begin = at_++;
  while (!at_line_end() && text_[at_] != ')') {
    if (text_[at_] == '(') fail(at_, "a comment inside a comment", "')' first");
    ++at_;
  }
  if (at_line_end()) fail(begin, "the comment does not end in its line", "')'");
  ++at_;
  block.comments.push_back({column_of(begin), text_.substr(begin, at_ - begin)});
}

void Lexer::read_word(Block& block) {
  const std::size_t begin = at_;
  const char letter = upper(text_[at_++]);
  if (letter == 'O') return read_program_number(block, begin);
  words_read_ = true;
  const double value = read_number(begin);
  if (letter == 'N') {
    if (!block.words.empty()) fail(begin, "N after other words", "N at the beginning of the line");
    return;
  }
  block.words.push_back({letter, value, column_of(begin), text_.substr(begin, at_ - begin)});
}

/// Fanuc names a program behind its first `%`; every other O word means subroutines or loops.
void Lexer::read_program_number(const Block& block, std::size_t word_begin) {
  const bool may_stand = in_percents_ && !words_read_ && block.comments.empty();
  const std::size_t digits = at_;
  while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
  const std::size_t count = at_ - digits;
  skip_blanks();
  const bool alone = at_line_end() || text_[at_] == '(' || text_[at_] == ';';
  if (!may_stand || count == 0 || count > kProgramDigits || !alone)
    fail(word_begin, "O words other than a program's number are not supported in this release",
         "O and up to 8 digits alone behind the first '%', or none");
  words_read_ = true;
}

double Lexer::read_number(std::size_t word_begin) {
  skip_blanks();
  const std::size_t begin = at_;
  if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
  const std::size_t numerals = at_;
  while (at_ < text_.size() && is_numeral(text_[at_])) ++at_;
  const std::size_t end = at_;
  skip_blanks();
  const bool goes_on = at_ < text_.size() && is_numeral(text_[at_]);
  at_ = goes_on || numerals == end ? begin : end;
  if (at_ == begin) return read_spaced_number(word_begin);
  double value = 0;
  const auto [stop, error] =
      std::from_chars(text_.data() + numerals, text_.data() + end, value, std::chars_format::fixed);
  if (error != std::errc() || stop != text_.data() + end)
    fail(word_begin, in_quotes(text_.substr(begin, end - begin)) + " is not a number",
         "digits and one decimal point");
  return text_[begin] == '-' ? -value : value;
}

/// A number with blanks between its numerals, or none at all.
double Lexer::read_spaced_number(std::size_t word_begin) {
  std::string gathered;
  std::size_t end = at_;
  for (; !at_line_end(); ++at_) {
    const char c = text_[at_];
    const bool sign = gathered.empty() && (c == '+' || c == '-');
    if (!sign && !is_numeral(c) && !is_blank(c)) break;
    if (!is_blank(c)) gathered += c, end = at_ + 1;
  }
  const bool unsigned_empty = gathered.empty() || gathered == "+" || gathered == "-";
  if (unsigned_empty && !at_line_end() && text_[at_] == '[')
    fail(at_, "expressions are not supported in this release", "a plain number");
  if (unsigned_empty && !at_line_end() && text_[at_] == '#')
    fail(at_, "parameters are not supported in this release", "a plain number");
  const std::optional<double> value = parse_number(gathered);
  if (!value)
    fail(word_begin, "the number of " + shown(text_[word_begin]) + " is missing or malformed",
         "digits and one decimal point; functions are not supported in this release");
  at_ = end;
  return *value;
}

}  // namespace limitgauge::model::gcode
