#pragma once

#include <optional>

#include "model/gcode/machine/machine_state.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// The motion that a block asks for, in tenths: by its own code, or by the modal one where axis
/// words (arcs: centre words) stand without a code that uses them. G0 and G1 alone are motions of
/// no length, as in LinuxCNC. `beside_cycles` is the mode of G0 to G3 that holds behind a cycle,
/// where cycles are a group of their own; `by_vector` says that I, J and K are the tool's axis in
/// straight motions (G43.5). Throws InputError for axis words that no code or two codes would use.
std::optional<int> motion_of(const Statement& statement, std::optional<int> modal_motion,
                             std::optional<int> beside_cycles = std::nullopt,
                             bool by_vector = false);
/// Whether axis words of the block are those of a code of group 0, as G28's.
bool axes_are_taken(const Statement& statement);
/// Whether the block is a G53 that the control carries out as a rapid, whatever motion is in force.
bool is_rapid_in_machine_frame(const Statement& statement);

/// Throws InputError at a word that no code of the block uses, that two of them would use, or that
/// a code of the block lacks.
void check_word_use(const Statement& statement, std::optional<int> motion, bool by_vector = false);

}  // namespace limitgauge::model::gcode
