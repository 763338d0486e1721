#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/job/job.h"
#include "engine/strategy/stage_path.h"

namespace limitgauge::app {

/// A planned stage's toolpath with its program.
struct PlannedStage {
  engine::strategy::StagePath path;
  std::string program;  ///< the text that stands in toolpath.ngc
  std::string cl_data;  ///< the text of toolpath.apt; empty where none is asked for
};

/// A stage's toolpath as it is cut, and all that is told of it. Path and program of a foreign stage
/// are those that the inputs hold, not copies.
struct StageToCut {
  std::shared_ptr<const model::Toolpath> path;
  std::shared_ptr<const std::string> program;  ///< the text that stands in toolpath.ngc
  std::string cl_data;                         ///< as in PlannedStage
  std::vector<std::string> ignored_words;
  engine::strategy::StagePath figures;               ///< of the planning; its own path is empty
  std::shared_ptr<const model::ToolAxes> axes = {};  ///< of a program that turns its tool
  std::optional<engine::strategy::ToolLean> lean = std::nullopt;  ///< of a planned one that leans
};

/// Writes the path of planned stage `stage` as the job's [post] asks: into `planned.program`, and
/// into `planned.cl_data` where CL data are asked for. Afterwards `planned.path.path` is what the
/// program moves: the planned points as rounded, or, with arcs, the program read back with its arcs
/// as chords within `chord_error_mm`, as for a program of somebody else. The CL data keep the
/// planned points. Throws InputError where the dialect cannot express the path.
void write_stage_program(const Job& job, std::size_t stage, double chord_error_mm,
                         PlannedStage& planned);

/// The same of a stage whose tool leans, for the job's machine: `planned.path` is what the program
/// moves, read back as a program of somebody else's, and its axes. The CL data keep the planned
/// points and axes. Throws std::invalid_argument where the machine's axes cannot follow or the
/// dialect cannot express the path.
void write_leaning_program(const Job& job, std::size_t stage, double chord_error_mm,
                           PlannedStage& planned);

/// toolpath.ngc, and toolpath.apt where there are CL data, into the stage's folder.
void write_program_files(const StageToCut& stage, const std::filesystem::path& folder);

}  // namespace limitgauge::app
