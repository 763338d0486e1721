#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace limitgauge::model::gcode {

/// Modal groups of G codes: of each group, a block may have one code (LinuxCNC's groups).
enum class GGroup : std::uint8_t {
  non_modal,          ///< G4
  motion,             ///< G0 G1 G2 G3 G80
  plane,              ///< G17 G18 G19
  distance,           ///< G90 G91
  arc_distance,       ///< G90.1 G91.1
  feed_mode,          ///< G94
  units,              ///< G20 G21
  radius_offset,      ///< G40
  length_offset,      ///< G49
  coordinate_system,  ///< G54
  path_control,       ///< G61 G61.1 G64
  count
};

/// Modal groups of M codes.
enum class MGroup : std::uint8_t {
  stopping,     ///< M0 M1 M2 M30
  tool_change,  ///< M6
  spindle,      ///< M3 M4 M5
  coolant,      ///< M7 M8 M9
  count
};

/// The group of G code `tenths` / 10, or nothing where this release does not carry it out.
std::optional<GGroup> g_group(int tenths);
/// The group of M code `number`, or nothing where this release does not know it.
std::optional<MGroup> m_group(int number);
/// What a G code does that RS274/NGC has but this release refuses; empty for a code that is
/// unknown.
std::string_view refused_g_meaning(int tenths);
/// The same for M codes.
std::string_view refused_m_meaning(int number);

}  // namespace limitgauge::model::gcode
