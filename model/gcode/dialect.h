#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limitgauge::model {

/// The controllers that programs are written for.
enum class Dialect : std::uint8_t { linuxcnc, fanuc, grbl };
const char* name(Dialect dialect);

/// What a controller takes in a line.
struct DialectRules {
  int most_decimals = 9;
  int default_decimals = 4;
  /// Digits of the longest number; more are refused or lost.
  int most_digits = 18;
  /// Without its point, a controller may read 1 as the least increment.
  bool point_always = false;
  /// Feed rates are rounded to this; empty: written as exactly as they were computed.
  std::optional<int> feed_decimals = std::nullopt;
  bool percents = false;       ///< `%` around the program, its number behind the first
  bool tool_change = true;     ///< T and M6 are understood
  bool arc_mode = true;        ///< G91.1 is understood
  bool capitals_only = false;  ///< in comments, and few signs beside them
  std::size_t longest_comment = std::numeric_limits<std::size_t>::max();
  std::string_view modes = {};  ///< the modes that a program starts from, a line each
};

/// Sources of what is not common to all: LinuxCNC's G-code reference; Fanuc's operator's manuals
/// (eight digits a number, least increment 0.001 mm of IS-B and 0.0001 mm of IS-C, decimals beyond
/// it lost, G21 alone in its block before all motion, O number behind the first `%`); Grbl 1.1's
/// list of supported codes, its line buffer of 80 characters and its reader of numbers, which keeps
/// eight digits.
const DialectRules& rules(Dialect dialect);

/// `text` as comment lines: no parentheses within, nothing but printable ASCII, or less where the
/// dialect has less; cut into several where a line is too long for the controller.
std::vector<std::string> comment_lines(Dialect dialect, std::string_view text);

}  // namespace limitgauge::model
