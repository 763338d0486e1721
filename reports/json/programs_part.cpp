#include "reports/json/programs_part.h"

namespace limitgauge::reports::json {

Json programs_part(const RunResult& result) {
  const model::MachineSetup& machine = result.machine;
  Json offsets = Json::array(), tools = Json::array();
  for (std::size_t i = 0; i < machine.work_offsets.size(); ++i) {
    if (!machine.work_offsets[i]) continue;
    const model::WorkOffset& offset = *machine.work_offsets[i];
    offsets.push_back({{"name", model::work_offset_name(i)},
                       {"origin_mm", point("work_offsets", offset.origin_mm)},
                       {"rotate_z_deg", finite("work_offsets", offset.rotation_deg)}});
  }
  for (const model::ToolEntry& tool : machine.tools) {
    Json entry = {{"number", tool.number}};
    if (tool.length_mm) entry["length_mm"] = finite("tools.length_mm", *tool.length_mm);
    if (tool.diameter_mm) entry["diameter_mm"] = finite("tools.diameter_mm", *tool.diameter_mm);
    tools.push_back(std::move(entry));
  }
  Json out = {{"offset_mm", point("programs.offset_mm", result.program_frame.translate_mm)},
              {"rotate_z_deg", finite("programs.rotate_z_deg", result.program_frame.rotate_z_deg)},
              {"work_offsets", std::move(offsets)},
              {"tools", std::move(tools)}};
  if (result.program_start) {
    out["start_mm"] = point("programs.start_mm", result.program_start->at_mm);
    out["start_assumed"] = result.program_start->assumed;
  }
  if (machine.home_mm) out["home_mm"] = point("programs.home_mm", *machine.home_mm);
  if (machine.second_home_mm)
    out["second_home_mm"] = point("programs.second_home_mm", *machine.second_home_mm);
  return out;
}

}  // namespace limitgauge::reports::json
