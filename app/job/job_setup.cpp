#include "app/job/job_parts.h"

#include <iterator>

namespace limitgauge::app {
namespace {

constexpr const char* kNames[] = {"G54", "G55",   "G56",   "G57",  "G58",
                                  "G59", "G59.1", "G59.2", "G59.3"};
static_assert(std::size(kNames) == model::kWorkOffsets);

/// `G54 = [x, y, z]` or `"G59.1" = { origin = [x, y, z], rotate_z = a }`.
model::WorkOffset read_offset(const TomlTable& offsets, const std::string& key) {
  if (!offsets.is_table(key)) return {offsets.position(key), 0};
  const TomlTable turned(offsets.table(key), key + " of [machine]", {"origin", "rotate_z"});
  return {turned.position("origin"), turned.has("rotate_z") ? turned.number("rotate_z") : 0};
}

void read_offsets(const TomlTable& machine, model::MachineSetup& setup) {
  const TomlTable offsets(machine.table("work_offsets"), "\"work_offsets\" of [machine]", {},
                          kNames);
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (offsets.has(kNames[i])) setup.work_offsets[i] = read_offset(offsets, kNames[i]);
}

}  // namespace

void read_setup(const TomlTable& root, const TomlTable& machine, Job& job) {
  if (machine.has("work_offsets")) read_offsets(machine, job.machine);
  if (machine.has("home")) job.machine.home_mm = machine.position("home");
  if (machine.has("second_home")) job.machine.second_home_mm = machine.position("second_home");
  if (machine.has("start")) job.machine.start_mm = machine.position("start");
  if (!root.has("program_frame")) return;
  const TomlTable frame(root.table("program_frame"), "[program_frame]", {"offset", "rotate_z"});
  if (frame.has("offset")) job.program_frame.translate_mm = frame.position("offset");
  if (frame.has("rotate_z")) job.program_frame.rotate_z_deg = frame.number("rotate_z");
}

std::vector<model::ToolEntry> tool_table(const std::vector<JobTool>& tools) {
  std::vector<model::ToolEntry> entries;
  for (const JobTool& tool : tools)
    if (tool.number) entries.push_back({*tool.number, tool.length_mm, tool.cutter.diameter_mm});
  return entries;
}

}  // namespace limitgauge::app
