#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "model/gcode/text/codes.h"
#include "model/machine/control.h"

namespace limitgauge::model::gcode {

/// What a control makes of a code, where that is not what RS274/NGC makes of it.
enum class CodeUse : std::uint8_t {
  set_aside,   ///< a setting or the end of one: it moves nothing, and is listed as ignored
  same_as,     ///< another code by another number
  work_frame,  ///< G54.1 P of a number that follows from the code's, G110's being 1
  refused
};

struct CodeRule {
  int first = 0, last = 0;  ///< G codes in tenths
  CodeUse use = CodeUse::refused;
  std::string_view text;      ///< set_aside: letters that belong to it; refused: what is wrong
  std::string_view expected;  ///< of a refusal
  int other = 0;              ///< same_as: the code of RS274/NGC
};

/// Null where the control reads the code as RS274/NGC does, or not at all.
const CodeRule* g_rule(Control control, int tenths);
const CodeRule* m_rule(Control control, int number);

/// A code that says what programmed places mean while rotary axes are turned, by the number that it
/// is carried out as.
struct RotaryCode {
  GGroup group = GGroup::length_offset;
  int tenths = 0;
};
/// G43.4, G68.2, G53.1 and G69 of Fanuc, of Haas G234 (as G43.4), G254 and G255 too; of LinuxCNC
/// those of Fanuc's that its configurations with a tilted working plane remap: G68.2, G53.1, G69.
/// On a machine with rotary axes only.
std::optional<RotaryCode> rotary_code(Control control, int tenths);
/// LinuxCNC's M428 to M430, as its configurations with switchable kinematics remap them.
bool is_kinematics_switch(Control control, int number);

}  // namespace limitgauge::model::gcode
