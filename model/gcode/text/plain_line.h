#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace limitgauge::model::gcode {

/// A line that holds nothing but where X, Y and Z go, as nearly all lines of a long program: a line
/// number and G0 or G1 may stand before these.
struct PlainLine {
  std::array<double, 3> axes{};  ///< of X, Y, Z, as they stand in the program
  unsigned stated = 0;           ///< bit 0 is X: the axes that have a word
  std::optional<int> motion;     ///< the G code in tenths
  /// A number other than 0 has no decimal point: what some controls take for increments.
  bool has_whole_number = false;
  std::ptrdiff_t most_decimals = 0;  ///< digits behind a point
  std::uint32_t line = 0;            ///< Block::line

  bool states(std::size_t axis) const { return (stated >> axis & 1U) != 0; }
};

/// Reads the line that begins at `begin` into `line`, all but its number, and gives the place of
/// its line feed, or `limit` where it has none. Null for every line that is not plain or may be
/// wrong: expressions, parameters, comments, blanks within numbers, a letter twice, more than 15
/// digits. `line` is of no account then. What is read has the values that Lexer::next gives.
const char* read_plain_line(const char* begin, const char* limit, PlainLine& line);

}  // namespace limitgauge::model::gcode
