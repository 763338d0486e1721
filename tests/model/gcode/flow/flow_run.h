#pragma once

#include <string>

#include "model/base/error.h"
#include "model/gcode/flow/flow.h"

namespace limitgauge::model::test {

inline bool ends_program(const gcode::Word& word) {
  return word.letter == 'M' && (word.value == 2 || word.value == 30);
}

/// The lines of the blocks with words that come, in their order: `1 3 3`; a `/` before lines that
/// come only to be listed. An error is the last entry.
inline std::string lines_of(const std::string& text, const gcode::FlowLimits& limits = {}) {
  std::string lines;
  try {
    gcode::Parameters parameters;
    gcode::Lexer lexer(text, "flow.ngc", parameters);
    gcode::Flow flow(lexer, parameters, limits);
    for (gcode::Block block; flow.next(block);) {
      const bool only_listed = block.block_delete && block.words.empty();
      if (block.words.empty() && !only_listed) continue;
      lines.append(lines.empty() ? "" : " ").append(only_listed ? "/" : "");
      lines += std::to_string(block.line);
      if (!only_listed && ends_program(block.words.front())) break;
    }
  } catch (const InputError& error) {
    lines.append(lines.empty() ? "" : " ").append(error.what());
  }
  return lines;
}

}  // namespace limitgauge::model::test
