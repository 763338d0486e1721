#include "app/run/stage_program.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app/job/foreign_programs.h"
#include "app/job/setup_frame.h"
#include "engine/strategy/axes/leaning_path.h"
#include "model/base/error.h"
#include "model/base/output_file.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/program_path.h"
#include "model/gcode/turning/axis_travel.h"
#include "model/gcode/turning/turning_path.h"
#include "model/gcode/turning/turning_program.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

model::WriterOptions writer_options(const Job& job, std::size_t stage) {
  model::WriterOptions options;
  options.program_name = job.name + " " + job.stages[stage].name;
  options.comment = model::to_text(job.stages[stage].cutter);
  options.tool_number = static_cast<int>(stage) + 1;
  options.dialect = job.post.dialect;
  options.decimals = job.post.decimals;
  options.arc_tolerance_mm = job.post.arc_tolerance_mm;
  options.line_numbers = job.post.line_numbers;
  return options;
}

std::string cl_data(const engine::strategy::StagePath& planned, const model::Cutter& cutter,
                    const model::WriterOptions& options) {
  std::ostringstream out;
  write_cl_data(planned.path, cutter, {options.program_name, options.tool_number, options.decimals},
                out, planned.axes ? &*planned.axes : nullptr);
  return std::move(out).str();
}

model::Toolpath read_back(const std::string& program, const std::string& name,
                          double chord_error_mm) {
  return to_toolpath(model::read_program(std::string_view(program), name), chord_error_mm);
}

void write(const Job& job, std::size_t stage, double chord_error_mm, PlannedStage& planned) {
  const model::WriterOptions options = writer_options(job, stage);
  model::Toolpath& path = planned.path.path;
  std::ostringstream out;
  write_program(path, options, out);
  planned.program = std::move(out).str();
  if (job.post.cl_data) planned.cl_data = cl_data(planned.path, job.stages[stage].cutter, options);
  if (!job.post.arc_tolerance_mm) return;
  path = read_back(planned.program, job.stages[stage].name + "/toolpath.ngc", chord_error_mm);
  planned.path.memory_bytes = path.moves.size() * sizeof(model::Move);
}

}  // namespace

void write_stage_program(const Job& job, std::size_t stage, double chord_error_mm,
                         PlannedStage& planned) {
  try {
    write(job, stage, chord_error_mm, planned);
  } catch (const std::invalid_argument& error) {
    throw model::InputError(
        {}, "stage \"" + job.stages[stage].name + "\": " + error.what(),
        "a path that dialect " + std::string(name(job.post.dialect)) + " can express");
  }
}

namespace {

/// In words of the job's machine.
model::TurningWriter turning_writer(const Job& job, std::size_t stage) {
  model::WriterOptions options = writer_options(job, stage);
  options.tool_number = job.stages[stage].tool_number.value_or(options.tool_number);
  options.arc_tolerance_mm.reset();
  return {std::move(options), job.machine.control, *job.machine.kinematics};
}

model::RotaryPath posted(const Job& job, std::size_t stage,
                         const engine::strategy::StagePath& planned) {
  const JobStage& asked = job.stages[stage];
  const model::Pose machine = pose_of(machine_in_setup_frame(job)).inverse();
  const double bend_mm = engine::strategy::kBowShare * asked.plan->cut.tolerance_mm;
  return rotary_path(planned.path, planned.axes.value(),
                     {*job.machine.kinematics, pose_of(job.program_frame).inverse(), machine,
                      asked.cutter.radius_mm(), bend_mm, job.post.decimals});
}

/// Throws std::invalid_argument for a motion that takes X, Y or Z beyond the job's travel.
void require_travel(const Job& job, const JobStage& asked, const model::Program& program,
                    const model::PathOptions& options) {
  if (!job.travel_mm) return;
  const std::vector<model::TravelBreach> beyond = beyond_travel(program,
                                                                {*job.machine.kinematics,
                                                                 *job.travel_mm,
                                                                 pose_of(options.machine_in_part),
                                                                 {},
                                                                 asked.tool_length_mm.value_or(0)},
                                                                options.first, options.last);
  if (beyond.empty()) return;
  const model::TravelBreach& worst =
      *std::ranges::max_element(beyond, {}, &model::TravelBreach::depth_mm);
  throw std::invalid_argument("line " + std::to_string(worst.line) + " of its program takes " +
                              "XYZ"[worst.axis] + (worst.above ? " above" : " below") +
                              " its travel by " + model::six_digits(worst.depth_mm) + " mm");
}

/// As a program of somebody else's, from where its path begins.
model::TurningPath read_turning(const Job& job, std::size_t stage, const std::string& text,
                                std::uint32_t first_line, double chord_error_mm) {
  const JobStage& asked = job.stages[stage];
  const model::Program program = model::read_program(
      std::string_view(text), asked.name + "/toolpath.ngc", machine_for(job, asked.cutter));
  const auto first =
      std::ranges::find_if(program.motions, [&](const auto& m) { return m.line >= first_line; });
  model::PathOptions options;
  options.chord_error_mm = chord_error_mm;
  options.machine_in_part = machine_in_setup_frame(job);
  options.kinematics = job.machine.kinematics;
  options.reach_mm = reach_mm(asked.cutter);
  options.first = static_cast<std::size_t>(first - program.motions.begin());
  require_travel(job, asked, program, options);
  return to_turning_path(program, options);
}

}  // namespace

void write_leaning_program(const Job& job, std::size_t stage, double chord_error_mm,
                           PlannedStage& planned) {
  const model::TurningWriter writer = turning_writer(job, stage);
  if (job.post.cl_data)
    planned.cl_data = cl_data(planned.path, job.stages[stage].cutter, writer.text);
  std::ostringstream out;
  const std::uint32_t first = write_turning_program(posted(job, stage, planned.path), writer, out);
  planned.program = std::move(out).str();
  model::TurningPath made = read_turning(job, stage, planned.program, first, chord_error_mm);
  planned.path.path = std::move(made.path);
  planned.path.axes = std::move(made.axes);
  planned.path.memory_bytes =
      planned.path.path.moves.size() * (sizeof(model::Move) + sizeof(model::Vec3));
}

void write_program_files(const StageToCut& stage, const std::filesystem::path& folder) {
  model::write_file(folder / "toolpath.ngc", [&](std::ostream& out) { out << *stage.program; });
  if (stage.cl_data.empty()) return;
  model::write_file(folder / "toolpath.apt", [&](std::ostream& out) { out << stage.cl_data; });
}

}  // namespace limitgauge::app
