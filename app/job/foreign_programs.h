#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/job/job.h"
#include "app/job/program_parts.h"
#include "app/job/settings.h"
#include "model/gcode/turning/axis_travel.h"
#include "model/part/fixture.h"

namespace limitgauge::app {

/// A program, or a part of one, as a stage's path.
struct ForeignPath {
  std::shared_ptr<const model::Toolpath> path;
  std::shared_ptr<const model::ToolAxes> axes;  ///< of one that turns its tool; else null
  model::ProgramStart start;                    ///< the same for all programs of a job
  std::vector<std::string> ignored_words;       ///< "line: word" that moves nothing
  std::vector<std::string> assumed;             ///< what the reader took for granted
  std::shared_ptr<const std::string> text;      ///< the whole program
  /// Motions of a machine with rotary axes, those that turn them included, that take X, Y or Z
  /// beyond the job's travel, where the stage is a stretch of its program.
  std::vector<model::TravelBreach> beyond_travel;
  std::string file;  ///< as the job states it
  /// The line that left other work or tool offsets than the program began with; 0: none did.
  std::uint32_t offsets_left = 0;
  std::string unended;  ///< what is to be said of a program without an end; else empty
};

/// The programs of the job's stages, each read once and shared out among the stages that take a
/// part of it; empty for a stage that is planned. Where the job does not say where they start, that
/// is their zero in X and Y, and in Z above stock, fixtures, `part` (the box of the surface) and
/// every height that a program names, by the job's clearance. Throws InputError for what cannot be
/// read, and for parts that do not fit together.
std::vector<std::optional<ForeignPath>> load_programs(const Job& job, const Settings& settings,
                                                      const std::vector<model::Fixture>& fixtures,
                                                      const model::Box3& part);
/// Lists with each program that begins with the job's offsets though one before it left others; of
/// a whole job, whose programs stand by stage.
void tell_offsets_left(std::vector<std::optional<ForeignPath>>& programs);
/// A program, and which of its motions each of its stages takes.
struct StagePrograms {
  std::vector<std::size_t> stages;
  model::Program program;
  std::vector<MotionRange> ranges;
};
/// The programs of the job's stages as they stand, read from an assumed start. Throws InputError as
/// load_programs does.
std::vector<StagePrograms> read_stage_programs(const Job& job);
/// What programs take from the machine when `cutter` stands in its spindle.
model::MachineSetup machine_for(const Job& job, const model::Cutter& cutter);

}  // namespace limitgauge::app
