#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace limitgauge::model::gcode {

/// Modal groups of G codes: of each group, a block may have one code (LinuxCNC's groups).
enum class GGroup : std::uint8_t {
  non_modal,          ///< G4 G10 G28 G28.1 G30 G30.1 G52 G53 G92
  axis_offset,        ///< G92.1 G92.2 G92.3
  motion,             ///< G0 G1 G2 G3 G73 G74 G80 to G89
  plane,              ///< G17 G18 G19
  distance,           ///< G90 G91
  arc_distance,       ///< G90.1 G91.1
  feed_mode,          ///< G93 G94 G95
  units,              ///< G20 G21
  radius_offset,      ///< G40 G41 G42 G41.1 G42.1
  length_offset,      ///< G43 G43.1 G43.2 G49
  return_level,       ///< G98 G99
  coordinate_system,  ///< G54 to G59, G59.1 to G59.3; of Fanuc and Haas G54.1
  path_control,       ///< G61 G61.1 G64
  spindle_mode,       ///< G96 G97
  working_plane,      ///< G68.2 G69, on machines with rotary axes
  dynamic_offset,     ///< G254 G255, likewise
  count
};

/// Modal groups of M codes.
enum class MGroup : std::uint8_t {
  input_output,  ///< M62 to M68
  tool_change,   ///< M6 M61
  spindle,       ///< M3 M4 M5 M19
  saved_state,   ///< M70 to M73
  coolant,       ///< M7 M8 M9
  overrides,     ///< M48 to M53
  stopping,      ///< M0 M1 M2 M30 M60
  kinematics,    ///< M428 M429, on machines with rotary axes
  count
};

/// The group of G code `tenths` / 10, or nothing where it is not carried out.
std::optional<GGroup> g_group(int tenths);
/// The group of M code `number`, or nothing where it is not known.
std::optional<MGroup> m_group(int number);

/// Why a code that RS274/NGC has is refused; both empty for a code that is unknown.
struct Refusal {
  std::string_view wrong, expected;
};
Refusal g_refusal(int tenths);
Refusal m_refusal(int number);

/// G2, G3.
constexpr bool is_arc(int tenths) {
  return tenths == 20 || tenths == 30;
}

}  // namespace limitgauge::model::gcode
