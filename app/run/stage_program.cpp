#include "app/run/stage_program.h"

#include <sstream>
#include <stdexcept>

#include "model/base/error.h"
#include "model/base/output_file.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/program_path.h"

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

std::string cl_data(const model::Toolpath& path, const model::Cutter& cutter,
                    const model::WriterOptions& options) {
  std::ostringstream out;
  write_cl_data(path, cutter, {options.program_name, options.tool_number, options.decimals}, out);
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
  if (job.post.cl_data) planned.cl_data = cl_data(path, job.stages[stage].cutter, options);
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

void write_program_files(const StageToCut& stage, const std::filesystem::path& folder) {
  model::write_file(folder / "toolpath.ngc", [&](std::ostream& out) { out << *stage.program; });
  if (stage.cl_data.empty()) return;
  model::write_file(folder / "toolpath.apt", [&](std::ostream& out) { out << stage.cl_data; });
}

}  // namespace limitgauge::app
