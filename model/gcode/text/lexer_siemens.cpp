// The lexer's part for Siemens (SINUMERIK 840D sl, "Fundamentals", 6FC5398-1BP40).
#include <algorithm>
#include <array>

#include "model/gcode/text/lexer.h"
#include "model/gcode/text/siemens_value.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

/// Statements that say how the control moves along the programmed path, and not where.
constexpr std::array<std::string_view, 21> kSettings = {
    "SOFT",  "BRISK", "DRIVE",   "FFWON",    "FFWOF",   "NORM",     "CFC",
    "CFTCP", "CFIN",  "COMPOF",  "CUT2D",    "CUT2DF",  "DIAMOF",   "STOPRE",
    "UPATH", "SPATH", "TRAFOOF", "FIFOCTRL", "DYNNORM", "DYNROUGH", "DYNFINISH"};
constexpr std::array<std::string_view, 3> kRemarks = {"MSG", "WORKPIECE", "SETAL"};

template <std::size_t count>
bool is_among(const std::array<std::string_view, count>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Why a statement is refused.
std::string reason_of(const std::string& name) {
  const auto begins = [&](std::string_view head) { return name.starts_with(head); };
  if (begins("CYCLE8") || begins("MCALL") || begins("CYCLE") || begins("POCKET") ||
      begins("SLOT") || begins("HOLES") || begins("LONGHOLE"))
    return "the control's own cycles are not known here";
  if (begins("TRANS") || begins("ATRANS") || begins("ROT") || begins("AROT") || begins("SCALE") ||
      begins("ASCALE") || begins("MIRROR") || begins("AMIRROR"))
    return "programmable frames are not carried out";
  if (begins("TRAORI") || begins("ORI")) return "orientations are not supported yet";
  if (begins("GOTO") || begins("IF") || begins("WHILE") || begins("FOR") || begins("REPEAT") ||
      begins("LOOP") || begins("CASE") || begins("ELSE") || begins("END"))
    return "jumps and loops of its language are not carried out";
  if (begins("KONT")) return "cutter compensation begins and ends by NORM";
  return "it is a statement of Siemens's language that is not carried out";
}

}  // namespace

void Lexer::read_siemens_items(Block& block) {
  constexpr std::size_t kMostSiemensItems = 100;
  for (std::size_t items = 0; !at_end(); skip_blanks()) {
    if (++items > kMostSiemensItems)
      fail(cursor_.at, "more than 100 words in one line", "a line that ends sooner");
    if (here() == ';') {
      read_comment(block);
    } else if (here() == '(') {
      fail(cursor_.at, "parentheses do not begin a comment on Siemens", "';'");
    } else if (is_letter(here())) {
      read_siemens_item(block);
    } else {
      fail_at_stray(cursor_.at);
    }
  }
}

/// A word as X10, X=R1+2, CR=5, R1=3, or a statement by its name.
void Lexer::read_siemens_item(Block& block) {
  const std::size_t begin = cursor_.at;
  std::size_t end = begin;
  while (end < cursor_.line.size() && is_letter(cursor_.line[end])) ++end;
  std::string name;
  for (const char c : cursor_.line.substr(begin, end - begin)) name += upper(c);
  if (name.size() > 1) return read_siemens_statement(block, begin, end, name);
  cursor_.at = end;
  if (name == "R") return read_siemens_setting(block, begin);
  if (name == "P" || name == "H" || name == "O" || name == "L" || name == "N")
    fail(begin, in_quotes(name) + " here is nothing of Siemens's that is carried out",
         "G, M, X, Y, Z, I, J, K, F, S, T, D or R");
  double value = 0;
  skip_blanks();
  if (!at_end() && here() == '=') {
    ++cursor_.at;
    skip_blanks();
    if (!at_end() && here() == '"')
      fail(begin, in_quotes(name) + " by a name, whose number nothing states", "a number");
    value = read_siemens_value(block);
  } else if (!read_plain_value(value)) {
    fail(begin, "the number of " + in_quotes(name) + " is missing or malformed",
         "a number, or '='");
  } else if (!at_end() && here() == '=') {
    fail(begin,
         in_quotes(cursor_.line.substr(begin, cursor_.at - begin)) +
             " of another spindle "
             "or axis",
         "words of X, Y, Z and one spindle");
  }
  block.words.push_back(
      {name.front(), value, column_of(begin), cursor_.line.substr(begin, cursor_.at - begin)});
}

void Lexer::read_siemens_setting(Block& block, std::size_t begin) {
  const int number = read_r_number(cursor_, fail_);
  skip_blanks();
  if (at_end() || here() != '=')
    fail(begin, "an R parameter that is not set", "'=' and a value; a radius is CR=");
  ++cursor_.at;
  const double value = read_siemens_value(block);
  block.settings.push_back({{kFirstRParameter + number, {}}, value, column_of(begin)});
}

/// What a block sets counts from the next one on.
double Lexer::read_siemens_value(Block& block) {
  std::vector<int> read;
  const std::size_t begin = cursor_.at;
  const double value = gcode::read_siemens_value(cursor_, parameters_, fail_, read);
  for (const Setting& setting : block.settings) {
    const int number = setting.parameter.number - kFirstRParameter;
    if (std::find(read.begin(), read.end(), number) != read.end())
      fail(begin, "R" + std::to_string(number) + " is set and read in one block", "two blocks");
  }
  return value;
}

void Lexer::read_siemens_statement(Block& block, std::size_t begin, std::size_t end,
                                   const std::string& name) {
  cursor_.at = end;
  skip_blanks();
  const bool equals = !at_end() && here() == '=';
  const auto text = [&] { return cursor_.line.substr(begin, cursor_.at - begin); };
  if (equals && (name == "CR" || name == "TURN")) {
    ++cursor_.at;
    const double value = read_siemens_value(block);
    // TURN counts whole turns beside the last part of one; P counts that as well.
    block.words.push_back(
        {name == "CR" ? 'R' : 'P', name == "CR" ? value : value + 1, column_of(begin), text()});
    return;
  }
  if (name == "SUPA") {
    block.words.push_back({'G', 153, column_of(begin), text()});
    return;
  }
  if (name == "RET") {
    block.words.push_back({'M', 17, column_of(begin), text()});
    return;
  }
  const bool remark = is_among(kRemarks, name);
  if (remark && !at_end() && here() == '(') {
    const std::size_t close = cursor_.line.rfind(')');
    if (close == std::string_view::npos) fail(begin, "'(' is not closed in its line", "')'");
    cursor_.at = close + 1;
  } else if (!is_among(kSettings, name)) {
    std::size_t word = end;
    while (word < cursor_.line.size() && is_digit(cursor_.line[word])) ++word;
    fail(begin,
         in_quotes(cursor_.line.substr(begin, word - begin)) +
             " is not carried out: " + reason_of(name),
         "G-code: G, M, X, Y, Z, I, J, K, F, S, T, D, R parameters");
  }
  std::string_view statement = text();
  while (is_blank(statement.back())) statement.remove_suffix(1);
  block.set_aside.emplace_back(statement);
}

}  // namespace limitgauge::model::gcode
