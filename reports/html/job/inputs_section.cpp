#include "reports/html/job/job_sections.h"

#include <variant>

#include <fmt/format.h>
#include "model/text/number_text.h"
#include "reports/html/markup.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string mesh_stock_text(const model::MeshStock& stock) {
  const model::Vec3 s = bounding_box(*stock.mesh).size();
  const std::string source = stock.voxel_mm > 0 ? fmt::format(", zero set at a voxel of {} mm",
                                                              model::shortest(stock.voxel_mm))
                                                : std::string();
  return fmt::format("{}: mesh of {} triangles{}, {} × {} × {} mm", escape_markup(stock.file),
                     grouped(std::uint64_t(stock.mesh->triangles.size())), source, fixed(s.x, 3),
                     fixed(s.y, 3), fixed(s.z, 3));
}

std::string origin_text(const model::Vec3& origin_mm, double turn_deg) {
  std::string out = coordinates(origin_mm) + " mm";
  if (turn_deg != 0) out += ", turned by " + typeset(model::shortest(turn_deg)) + "°";
  return out;
}

/// What programs of somebody else were told of the machine.
void add_machine(const RunResult& result, std::vector<Term>& list) {
  const model::MachineSetup& machine = result.machine;
  list.push_back(
      {result.surface ? "Programs' frame in the cage's" : "Programs' frame in the stock's",
       origin_text(result.program_frame.translate_mm, result.program_frame.rotate_z_deg)});
  for (std::size_t i = 0; i < machine.work_offsets.size(); ++i)
    if (const auto& offset = machine.work_offsets[i])
      list.push_back({std::string("Work offset ") + model::work_offset_name(i),
                      origin_text(offset->origin_mm, offset->rotation_deg)});
  for (const auto& [number, offset] : machine.extended_offsets)
    list.push_back({"Work offset " + model::work_offset_name(model::kWorkOffsets +
                                                             static_cast<std::size_t>(number - 1)),
                    origin_text(offset.origin_mm, offset.rotation_deg)});
  if (result.program_start)
    list.push_back({"Programs read by the habits of", std::string(model::name(machine.control))});
  if (const auto& start = result.program_start)
    list.push_back(
        {"Programs start at", origin_text(start->at_mm, 0) + (start->assumed ? " (assumed)" : "")});
  if (machine.home_mm) list.push_back({"Home (G28)", origin_text(*machine.home_mm, 0)});
  if (machine.second_home_mm)
    list.push_back({"Second home (G30)", origin_text(*machine.second_home_mm, 0)});
}

std::string machine_tools(const std::vector<model::ToolEntry>& tools) {
  if (tools.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const model::ToolEntry& tool : tools)
    rows.push_back({"T" + std::to_string(tool.number),
                    tool.length_mm ? model::shortest(*tool.length_mm) + " mm" : "–",
                    tool.diameter_mm ? model::shortest(*tool.diameter_mm) + " mm" : "–"});
  return table("The machine's tool table, as programs were read with it",
               {{"Number"}, {"Length", true}, {"Diameter", true}}, rows);
}

std::string files_table(const std::vector<InputFile>& inputs) {
  if (inputs.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const InputFile& input : inputs)
    rows.push_back({escape_markup(input.role), escape_markup(input.file), grouped(input.bytes),
                    "<code class=\"sum\">" + escape_markup(input.sha256) + "</code>"});
  return table("Files that were read, named as the job or the command line states them",
               {{"What"}, {"File"}, {"Bytes", true}, {"SHA-256"}}, rows);
}

}  // namespace

std::string stock_text(const model::Stock& stock) {
  if (const auto* mesh = std::get_if<model::MeshStock>(&stock)) return mesh_stock_text(*mesh);
  if (const auto* box = std::get_if<model::BoxStock>(&stock)) {
    const model::Vec3& s = box->size_mm;
    return fmt::format("block {} × {} × {} mm", model::shortest(s.x), model::shortest(s.y),
                       model::shortest(s.z));
  }
  const auto& bar = std::get<model::CylinderStock>(stock);
  return fmt::format("bar ⌀{} × {} mm", model::shortest(bar.diameter_mm),
                     model::shortest(bar.height_mm));
}

std::string inputs_section(const RunResult& result) {
  std::vector<Term> list = {{"Threads", std::to_string(result.threads)}};
  for (const std::string& override : result.overrides)
    list.push_back({"Set on the command line", "<code>" + escape_markup(override) + "</code>"});
  add_machine(result, list);
  return "<section id=\"inputs\"><h2>Job and inputs</h2>\n" +
         fold("more", "What the job stated and every file that was read",
              terms(list) + machine_tools(result.machine.tools) + files_table(result.inputs)) +
         "</section>\n";
}

namespace {

/// The rules that shape this cage's surface, in words.
std::string rules_text(const verifier::SurfaceRules& r) {
  std::string text = "Catmull-Clark, boundary ";
  switch (r.boundary) {
    case model::BoundaryRule::none:
      text += "none (faces at it are no surface)";
      break;
    case model::BoundaryRule::edge_and_corner:
      text += "edge and corner";
      break;
    case model::BoundaryRule::edge_only:
      text += "edge only";
      break;
  }
  const auto add = [&](model::Index count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(r.sharp_edges, "sharp edges"), add(r.semi_sharp_edges, "semi-sharp edges, uniform");
  add(r.sharp_vertices, "sharp vertices"), add(r.semi_sharp_vertices, "semi-sharp vertices");
  add(r.darts, "darts"), add(r.holes, "holes");
  return text;
}

std::string witness_text(const witness::Agreement& w) {
  std::string text =
      fmt::format("{}: {} limit points within {} mm, {} normals within {} rad",
                  escape_markup(w.evaluator), grouped(w.points), typeset(three_digits(w.worst_mm)),
                  grouped(w.normals), typeset(three_digits(w.worst_normal_rad)));
  text += fmt::format(" (rounding may amount to {} mm)", typeset(three_digits(w.bound_mm)));
  if (w.normals_left_out > 0)
    text += fmt::format("; {} normals at sharp or irregular places not compared",
                        grouped(w.normals_left_out));
  if (w.points_left_out > 0)
    text += fmt::format("; {} points not compared", grouped(w.points_left_out));
  return text;
}

}  // namespace

std::string surface_section(const SurfaceResult& s) {
  const model::Vec3 size = s.bbox_mm.size();
  return "<section id=\"surface\"><h2>Design surface</h2>\n" +
         terms(
             {{s.mesh ? "Size of the mesh" : "Size of the limit surface",
               fmt::format("{} × {} × {} mm", fixed(size.x, 3), fixed(size.y, 3),
                           fixed(size.z, 3))},
              {"Area", three_digits(s.area_mm2) + " mm²"},
              {"Patches", grouped(std::uint64_t(s.summary.patches))},
              {s.mesh ? "Triangles of the mesh" : "Faces of the cage",
               grouped(std::uint64_t(s.summary.faces))},
              {"Boundary edges", grouped(std::uint64_t(s.summary.boundary_edges))},
              {"Extraordinary vertices", grouped(std::uint64_t(s.summary.extraordinary_vertices))},
              {"Rules of the surface", s.mesh ? "the facets themselves" : rules_text(s.rules)},
              {"Held against", witness_text(s.witness)}}) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
