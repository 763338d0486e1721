#include "model/gcode/dialect.h"

#include <algorithm>
#include <array>

namespace limitgauge::model {
namespace {

constexpr int kEightDigits = 8;
/// 80 with the parentheses and the end of the string, and what a sender may put before.
constexpr std::size_t kGrblComment = 70;

constexpr DialectRules kLinuxcnc = {.modes = "G21 G90 G94 G17 G40 G49\n"};
constexpr DialectRules kFanuc = {.most_decimals = 4,
                                 .default_decimals = 3,
                                 .most_digits = kEightDigits,
                                 .point_always = true,
                                 .feed_decimals = 3,
                                 .percents = true,
                                 .arc_mode = false,
                                 .capitals_only = true,
                                 .modes = "G21\nG17 G40 G49 G54 G80 G90 G94\n"};
constexpr DialectRules kGrbl = {.most_decimals = 4,
                                .most_digits = kEightDigits,
                                .feed_decimals = 3,
                                .tool_change = false,
                                .longest_comment = kGrblComment,
                                .modes = "G21 G90 G94 G17\n"};

/// Letters, digits and signs that stand on every keyboard of a control; `%` would end a program.
char capital(char c) {
  if (c >= 'a' && c <= 'z') return static_cast<char>(c - 'a' + 'A');
  const bool plain = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return plain || std::string_view(".,-+=/ ").find(c) != std::string_view::npos ? c : ' ';
}

/// Parentheses and line ends would end a comment, and not every controller reads more than ASCII.
char commented(char c, bool capitals_only) {
  if (capitals_only) return capital(c);
  const bool printable = c >= ' ' && c <= '~';
  return c == '(' ? '[' : c == ')' ? ']' : printable ? c : ' ';
}

}  // namespace

const char* name(Dialect dialect) {
  constexpr std::array kNames = {"linuxcnc", "fanuc", "grbl"};
  return kNames[static_cast<std::size_t>(dialect)];
}

const DialectRules& rules(Dialect dialect) {
  if (dialect == Dialect::fanuc) return kFanuc;
  return dialect == Dialect::grbl ? kGrbl : kLinuxcnc;
}

std::vector<std::string> comment_lines(Dialect dialect, std::string_view text) {
  const DialectRules& rule = rules(dialect);
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::size_t length = std::min(end, rule.longest_comment);
    std::string line = "(";
    for (const char c : text.substr(0, length)) line += commented(c, rule.capitals_only);
    lines.push_back(line + ")");
    text.remove_prefix(length == end ? std::min(end + 1, text.size()) : length);
  }
  return lines;
}

}  // namespace limitgauge::model
