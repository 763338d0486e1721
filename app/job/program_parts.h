#pragma once

#include <span>
#include <vector>

#include "app/job/job.h"
#include "model/gcode/program.h"

namespace limitgauge::app {

/// The changes of `program` to another tool that then moves. T0 takes the tool out: rapids then
/// belong to the part before, as if it were still there.
std::vector<model::ToolChange> loadings(const model::Program& program);

/// Whether two stages that are not planned name one file, in whatever words.
bool same_program(const JobStage& a, const JobStage& b);

/// The motions [first, last) of a program that one stage takes.
struct MotionRange {
  std::size_t first = 0, last = 0;
};

/// Which motions each of `stages` takes, all of which name `program`, in their order. Together they
/// take every motion once: motions before the first part belong to it, the others each to the part
/// before them. Throws InputError with the program's line for a part that is not there or not in
/// its order, for a part in which a second tool is loaded, for a tool whose number is not the
/// stage's, and for a feed before the first tool is loaded or after T0 took one out.
std::vector<MotionRange> assign_parts(const model::Program& program, const std::string& file,
                                      std::span<const JobStage* const> stages);

}  // namespace limitgauge::app
