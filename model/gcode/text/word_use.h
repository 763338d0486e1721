#pragma once

#include <optional>

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// The motion that a block asks for, in tenths: by its own code, or by the modal one where axis
/// words (arcs: centre words) stand without a code that uses them. G0 and G1 alone are motions of
/// no length, as in LinuxCNC. Throws InputError for axis words that no code or two codes would use.
std::optional<int> motion_of(const Statement& statement, std::optional<int> modal_motion);

/// Throws InputError at a word that no code of the block uses, that two of them would use, or that
/// a code of the block lacks.
void check_word_use(const Statement& statement, std::optional<int> motion);

}  // namespace limitgauge::model::gcode
