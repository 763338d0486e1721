// The lexer's part for text that is no word: what it may have been meant as.
#include <algorithm>

#include "model/gcode/text/functions.h"
#include "model/gcode/text/lexer.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

/// A run of letters of this length is a word of some language, and no letter before its value.
constexpr std::size_t kStatementLetters = 4;

/// The character that the bytes from `at` on are in UTF-8; 0 where they are none.
std::uint32_t utf8_at(std::string_view line, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < line.size() ? static_cast<unsigned char>(line[at + i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  if ((byte(0) & 0xE0U) == 0xC0U && follows(1)) return (byte(0) & 0x1FU) << 6U | (byte(1) & 0x3FU);
  if ((byte(0) & 0xF0U) == 0xE0U && follows(1) && follows(2))
    return (byte(0) & 0x0FU) << 12U | (byte(1) & 0x3FU) << 6U | (byte(2) & 0x3FU);
  return 0;
}

std::string code_point_text(std::uint32_t code_point) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text = "U+";
  for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[(code_point >> shift) & 0xFU];
  return text;
}

bool is_dash(std::uint32_t code_point) {
  return (code_point >= 0x2010 && code_point <= 0x2015) || code_point == 0x2212;
}

}  // namespace

void Lexer::fail_at_stray(std::size_t at) const {
  if (const std::uint32_t code_point = utf8_at(cursor_.line, at); code_point != 0)
    fail(at,
         "the character " + code_point_text(code_point) +
             (is_dash(code_point) ? ", a dash that no number follows," : "") + " begins no word",
         is_dash(code_point) ? "'-' before a number" : "letters, digits and signs of ASCII");
  fail(at, in_quotes(cursor_.line[at]) + " does not begin a word",
       "a letter and a number, or a comment");
}

/// Behind other words an O word means nothing, but a slip for 0 often stands there.
void Lexer::fail_at_letter_o(std::size_t at) const {
  const std::string_view line = cursor_.line;
  const char before = at > 0 ? line[at - 1] : ' ';
  if (is_digit(before) || before == '.' || before == '-' || before == '+')
    fail(at, "the letter O within a number", "the digit 0");
  fail(at, "O after other words", "O at the beginning of the line");
}

/// A letter whose number does not begin with a digit or sign: O for 0, or a word of another
/// language.
void Lexer::check_known_word(std::size_t begin) const {
  const std::string_view line = cursor_.line;
  std::size_t end = begin;
  while (end < line.size() && is_letter(line[end])) ++end;
  const std::string_view letters = line.substr(begin, end - begin);
  const char behind = end < line.size() ? line[end] : ' ';
  const bool plain_end = is_digit(behind) || behind == '.' || is_blank(behind);
  if (letters.size() == 2 && upper(letters[1]) == 'O' && plain_end)
    fail(begin + 1, "the letter O within a number", "the digit 0");
  std::string rest;
  for (const char c : letters.substr(std::min<std::size_t>(1, letters.size()))) rest += lower(c);
  if (letters.size() < kStatementLetters || behind == '[' || function_named(rest)) return;
  std::size_t word_end = end;
  while (word_end < line.size() && (is_digit(line[word_end]) || line[word_end] == '_')) ++word_end;
  fail(begin,
       in_quotes(line.substr(begin, word_end - begin)) +
           " is no word of G-code, but perhaps a statement of another control's language",
       "a letter and a number; the post processor's output in G-code (DIN/ISO)");
}

/// Where `;` ends a block, what stands behind it on the line would be the next.
void Lexer::check_behind_semicolon(std::size_t begin) const {
  if (!rules_.semicolon_ends_block) return;
  const std::size_t text = cursor_.line.find_first_not_of(" \t\r;", begin + 1);
  if (text == std::string_view::npos || cursor_.line[text] == '(') return;
  fail(text, "text behind ';', which ends a block on " + std::string(rules_.title),
       "comments in parentheses, one block a line");
}

}  // namespace limitgauge::model::gcode
