#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/gcode/text/lexer.h"

namespace limitgauge::model::gcode {

/// What an O line says; `program` is an O number alone, as Fanuc begins a program.
enum class FlowKeyword : std::uint8_t {
  program,
  sub,
  endsub,
  return_,
  call,
  do_,
  while_,
  endwhile,
  break_,
  continue_,
  if_,
  elseif,
  else_,
  endif,
  repeat,
  endrepeat
};

/// Nothing for a keyword that RS274/NGC does not have.
std::optional<FlowKeyword> flow_keyword(std::string_view lower_case);
/// The length of the longest keyword that `lower_case` begins with; 0: none.
std::size_t keyword_length(std::string_view lower_case);
/// The keyword of an O line; throws InputError for one that RS274/NGC does not have.
FlowKeyword keyword_of(const Block& block, const Lexer& lexer);
std::string_view to_text(FlowKeyword keyword);

/// `o100` or `o<name>`, and with the keyword behind it.
std::string label_text(const OWord& o_word);
std::string o_text(const OWord& o_word, FlowKeyword keyword);

}  // namespace limitgauge::model::gcode
