#pragma once

#include "model/gcode/program.h"
#include "model/gcode/read/assumptions.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// Lists what a block has that does not move the tool: auxiliary words with the words that belong
/// to them, a leading `/`, comments that a controller acts on; and comments that stand alone. Each
/// list ends after a million entries, each entry after 200 bytes.
/// `motions` is the number of motions before the block.
void list_auxiliaries(const Statement& statement, Program& program, std::size_t motions);

/// Lists a centre word of 0 along the axis of an arc, and a control's line that begins with `$`;
/// `moved`: motions stand before it. Throws InputError for one that would move the machine.
void list_idle_centre(const Statement& statement, ArcPlane plane, Program& program);
void list_dollar(const Statement& statement, Program& program, bool moved, Assumptions& assumed);

/// Lists an F word that nothing takes: under G93 beside no feed motion.
void list_unused_feed(const Statement& statement, Program& program);

}  // namespace limitgauge::model::gcode
