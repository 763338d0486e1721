#include "reports/json/result_parts.h"

#include "reports/text/text.h"

namespace limitgauge::reports::json {

Json inputs_part(const std::vector<InputFile>& inputs) {
  Json out = Json::array();
  for (const InputFile& input : inputs)
    out.push_back({{"role", clean_text(input.role)},
                   {"file", clean_text(input.file)},
                   {"bytes", input.bytes},
                   {"sha256", input.sha256}});
  return out;
}

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
  for (const auto& [number, offset] : machine.extended_offsets)
    offsets.push_back({{"name", model::work_offset_name(model::kWorkOffsets +
                                                        static_cast<std::size_t>(number - 1))},
                       {"origin_mm", point("work_offsets", offset.origin_mm)},
                       {"rotate_z_deg", finite("work_offsets", offset.rotation_deg)}});
  for (const model::ToolEntry& tool : machine.tools) {
    Json entry = {{"number", tool.number}};
    if (tool.length_mm) entry["length_mm"] = finite("tools.length_mm", *tool.length_mm);
    if (tool.diameter_mm) entry["diameter_mm"] = finite("tools.diameter_mm", *tool.diameter_mm);
    tools.push_back(std::move(entry));
  }
  Json out = {{"offset_mm", point("programs.offset_mm", result.program_frame.translate_mm)},
              {"rotate_z_deg", finite("programs.rotate_z_deg", result.program_frame.rotate_z_deg)},
              {"control", std::string(model::name(machine.control))},
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

namespace {

Json mesh_stock_part(const model::MeshStock& stock) {
  const model::Box3 box = bounding_box(*stock.mesh);
  Json out = {{"shape", stock.voxel_mm > 0 ? "vdb" : "mesh"},
              {"file", clean_text(stock.file)},
              {"triangles", stock.mesh->triangles.size()},
              {"corner_mm", point("stock.corner_mm", box.low)},
              {"size_mm", point("stock.size_mm", box.size())},
              {"volume_mm3", finite("stock.volume_mm3", volume_mm3(*stock.mesh))}};
  if (stock.voxel_mm > 0) out["voxel_mm"] = finite("stock.voxel_mm", stock.voxel_mm);
  return out;
}

}  // namespace

Json setups_part(const std::vector<model::Setup>& setups) {
  Json out = Json::array();
  for (const model::Setup& setup : setups) {
    const model::Pose& pose = setup.from_part;
    Json rows = Json::array();
    for (const model::Vec3& row : pose.rows) rows.push_back(point("setups.rotation", row));
    out.push_back({{"name", clean_text(setup.name)},
                   {"rotation", std::move(rows)},
                   {"origin_mm", point("setups.origin_mm", pose.shift_mm)},
                   {"tool_axis", point("setups.tool_axis", tool_axis(setup))}});
  }
  return out;
}

Json stock_part(const model::Stock& stock) {
  if (const auto* mesh = std::get_if<model::MeshStock>(&stock)) return mesh_stock_part(*mesh);
  if (const auto* box = std::get_if<model::BoxStock>(&stock))
    return {{"shape", "box"},
            {"corner_mm", point("stock.corner_mm", box->corner_mm)},
            {"size_mm", point("stock.size_mm", box->size_mm)}};
  const auto& bar = std::get<model::CylinderStock>(stock);
  return {{"shape", "cylinder"},
          {"base_mm", point("stock.base_mm", bar.base_mm)},
          {"diameter_mm", finite("stock.diameter_mm", bar.diameter_mm)},
          {"height_mm", finite("stock.height_mm", bar.height_mm)}};
}

}  // namespace limitgauge::reports::json
