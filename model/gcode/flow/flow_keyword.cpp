#include "model/gcode/flow/flow_keyword.h"

#include <algorithm>
#include <array>

#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

/// In the order of FlowKeyword.
constexpr std::array<std::string_view, 16> kTexts = {
    "",      "sub",      "endsub", "return", "call", "do",    "while",  "endwhile",
    "break", "continue", "if",     "elseif", "else", "endif", "repeat", "endrepeat"};

bool is_number(std::string_view label) {
  return std::all_of(label.begin(), label.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::optional<FlowKeyword> flow_keyword(std::string_view lower_case) {
  const auto* const found = std::find(kTexts.begin(), kTexts.end(), lower_case);
  if (found == kTexts.end()) return std::nullopt;
  return static_cast<FlowKeyword>(found - kTexts.begin());
}

std::size_t keyword_length(std::string_view lower_case) {
  std::size_t longest = 0;
  for (const std::string_view text : kTexts) {
    if (lower_case.starts_with(text)) longest = std::max(longest, text.size());
  }
  return longest;
}

FlowKeyword keyword_of(const Block& block, const Lexer& lexer) {
  const OWord& o_word = *block.o_word;
  const std::optional<FlowKeyword> keyword = flow_keyword(o_word.keyword);
  if (!keyword)
    lexer.fail_at(block.line, o_word.keyword_column,
                  in_quotes(o_word.keyword) + " means nothing behind an O number",
                  "sub, endsub, return, call, do, while, endwhile, break, continue, if, elseif, "
                  "else, endif, repeat or endrepeat");
  return *keyword;
}

std::string_view to_text(FlowKeyword keyword) {
  return kTexts[static_cast<std::size_t>(keyword)];
}

std::string label_text(const OWord& o_word) {
  return is_number(o_word.label) ? "o" + o_word.label : "o<" + o_word.label + ">";
}

std::string o_text(const OWord& o_word, FlowKeyword keyword) {
  return label_text(o_word).append(" ").append(to_text(keyword));
}

}  // namespace limitgauge::model::gcode
