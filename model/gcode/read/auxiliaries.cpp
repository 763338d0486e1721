#include "model/gcode/read/auxiliaries.h"

#include <initializer_list>

#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::size_t kMostEntries = 1'000'000;
constexpr std::size_t kMostBytes = 200;

std::string cut(std::string_view text) {
  return std::string(text.substr(0, kMostBytes));
}

/// Upper case and without blanks.
std::string plain(const Word& word) {
  std::string text(1, word.letter);
  for (const char c : word.text.substr(1, kMostBytes)) {
    if (!is_blank(c)) text += c;
  }
  return text;
}

void add_ignored(Program& program, std::uint32_t line, std::string word) {
  if (program.ignored.size() < kMostEntries) program.ignored.push_back({line, std::move(word)});
}

/// Comments that a controller acts on: a message to the operator, output to a file.
bool is_active(std::string_view comment) {
  if (comment.front() != '(') return false;
  std::string word;
  for (const char c : comment.substr(1)) {
    if (is_blank(c)) continue;
    if (c == ',') break;
    if (c == ')' || word.size() > 10) return false;
    word += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  }
  return word == "MSG" || word == "DEBUG" || word == "PRINT" || word == "LOG" ||
         word == "LOGOPEN" || word == "LOGAPPEND" || word == "PROBEOPEN";
}

/// Without parentheses or semicolon, trimmed.
std::string_view inside(std::string_view comment) {
  if (comment.starts_with('(') && comment.ends_with(')')) comment.remove_suffix(1);
  comment.remove_prefix(1);
  while (!comment.empty() && is_blank(comment.front())) comment.remove_prefix(1);
  while (!comment.empty() && is_blank(comment.back())) comment.remove_suffix(1);
  return comment;
}

void list_comments(const Block& block, Program& program, std::size_t motions) {
  const bool alone = block.words.empty() && block.settings.empty() && !block.o_word;
  for (const Comment& comment : block.comments) {
    if (is_active(comment.text)) add_ignored(program, block.main_line, cut(comment.text));
    if (alone && program.comments.size() < kMostEntries)
      program.comments.push_back({block.main_line, motions, cut(inside(comment.text))});
  }
}

/// The letters that belong to the auxiliary `word`, where it is one; null where it is not.
const char* companions(const Statement& statement, const Word& word) {
  if (word.letter == 'S' || word.letter == 'T') return "";
  if (&word == statement.g_word(GGroup::non_modal))
    return statement.g(GGroup::non_modal) == 40 ? "P" : nullptr;
  if (&word == statement.g_word(GGroup::path_control)) return "PQ";
  if (&word == statement.g_word(GGroup::spindle_mode)) return "D";
  if (word.letter != 'M' || &word == statement.m_word(MGroup::saved_state)) return nullptr;
  if (&word == statement.m_word(MGroup::stopping))
    return *statement.m(MGroup::stopping) == 2 || *statement.m(MGroup::stopping) == 30 ? nullptr
                                                                                       : "";
  if (&word == statement.m_word(MGroup::input_output)) return "PELQ";
  if (&word == statement.m_word(MGroup::overrides)) return "P";
  if (&word == statement.m_word(MGroup::tool_change)) return "Q";
  const bool orients =
      &word == statement.m_word(MGroup::spindle) && statement.m(MGroup::spindle) == 19;
  return orients ? "RPQ" : "";
}

void list_word(const Statement& statement, const Word& word, Program& program) {
  if (statement.is_set_aside(word)) return add_ignored(program, statement.line(), plain(word));
  const char* const letters = companions(statement, word);
  if (!letters) return;
  std::string text = plain(word);
  for (const char letter : std::string_view(letters)) {
    if (const Word* companion = statement.word(letter)) text.append(" ").append(plain(*companion));
  }
  add_ignored(program, statement.line(), std::move(text));
}

}  // namespace

void list_auxiliaries(const Statement& statement, Program& program, std::size_t motions) {
  const Block& block = statement.block();
  if (block.block_delete) add_ignored(program, block.main_line, "/");
  if (!block.comments.empty()) list_comments(block, program, motions);
  for (const std::string& text : block.set_aside) add_ignored(program, block.main_line, cut(text));
  if ((statement.letters() & letter_bits("GMST")) == 0 && !statement.any_set_aside()) return;
  for (const Word& word : block.words) list_word(statement, word, program);
}

void list_idle_centre(const Statement& statement, ArcPlane plane, Program& program) {
  const Word* const word = statement.word("IJK"[axes_of(plane)[2]]);
  if (word && word->value == 0 && statement.rules().idle_centre_words)
    add_ignored(program, statement.line(), plain(*word));
}

namespace {

/// Grbl's settings of directions ($3) and of steps to the millimetre ($100 to $102), and what sets
/// all of them back. Grbl reads a number up to its point.
bool sets_geometry(std::string_view text) {
  std::string plain;
  for (const char c : text)
    if (c != ' ') plain += upper(c);
  if (plain.starts_with("$RST")) return true;
  std::size_t at = 1;
  int number = 0;
  for (; at < plain.size() && is_digit(plain[at]) && number < 1000; ++at)
    number = number * 10 + (plain[at] - '0');
  return at > 1 && plain.find('=') != std::string::npos &&
         (number == 3 || (number >= 100 && number <= 102));
}

}  // namespace

/// Grbl 1.1, "Commands": settings, states and modes; of these $H and $J move the machine.
void list_dollar(const Statement& statement, Program& program, bool moved, Assumptions& assumed) {
  const Block& block = statement.block();
  const std::string text = cut(block.dollar);
  const char command = text.size() > 1 ? upper(text[1]) : '\0';
  if (command == 'J' || (command == 'H' && moved))
    statement.fail_line(in_quotes(text) + " moves the machine by itself",
                        "G0 and G1; homing before the first motion");
  if (command == 'C')
    statement.fail_line(in_quotes(text) + " is Grbl's check mode, in which nothing is carried out",
                        "a program without it");
  if (sets_geometry(text))
    statement.fail_line(in_quotes(text) + " changes which way or how far the machine's axes move",
                        "a program without it");
  if (command == 'H')
    assumed.add(statement.line(), "the machine is homed by $H before it comes to its start");
  add_ignored(program, statement.line(), text);
}

void list_unused_feed(const Statement& statement, Program& program) {
  if (const Word* f = statement.word('F')) add_ignored(program, statement.line(), plain(*f));
}

}  // namespace limitgauge::model::gcode
