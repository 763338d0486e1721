#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/json_inputs.h"
#include "reports/process.h"
#include "reports/program_lines.h"
#include "reports/report.h"
#include "reports/text.h"

namespace limitgauge::reports {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity: a figure that is one is a bug of whoever measured it.
double finite(const char* key, double value) {
  if (!std::isfinite(value))
    throw std::domain_error(std::string("result.json: ") + key + " is not a finite number");
  return value;
}

Json point(const char* key, const model::Vec3& p) {
  return Json::array({finite(key, p.x), finite(key, p.y), finite(key, p.z)});
}

Json texts(const std::vector<std::string>& lines) {
  Json out = Json::array();
  for (const std::string& line : lines) out.push_back(clean_text(line));
  return out;
}

Json numbers(const char* key, const std::vector<double>& values) {
  Json out = Json::array();
  for (const double v : values) out.push_back(finite(key, v));
  return out;
}

Json interval(const char* key, const verifier::Interval& i) {
  return {{"low", finite(key, i.low)}, {"high", finite(key, i.high)}};
}

const char* rule_name(model::BoundaryRule rule) {
  switch (rule) {
    case model::BoundaryRule::none:
      return "none";
    case model::BoundaryRule::edge_and_corner:
      return "edge_and_corner";
    case model::BoundaryRule::edge_only:
      break;
  }
  return "edge_only";
}

Json rules_part(const verifier::SurfaceRules& r) {
  return {{"scheme", "catmull-clark"},
          {"boundary", rule_name(r.boundary)},
          {"creases", "uniform"},
          {"infinite_sharpness", finite("rules.infinite_sharpness", r.infinite_sharpness)},
          {"sharp_edges", r.sharp_edges},
          {"semi_sharp_edges", r.semi_sharp_edges},
          {"sharp_vertices", r.sharp_vertices},
          {"semi_sharp_vertices", r.semi_sharp_vertices},
          {"darts", r.darts},
          {"holes", r.holes}};
}

Json surface_part(const SurfaceResult& s) {
  return {
      {"cage", clean_text(s.cage)},
      {"patches", s.summary.patches},
      {"faces", s.summary.faces},
      {"vertices", s.summary.vertices},
      {"boundary_edges", s.summary.boundary_edges},
      {"extraordinary_vertices", s.summary.extraordinary_vertices},
      {"creases", s.summary.creases},
      {"corners", s.summary.corners},
      {"holes", s.summary.holes},
      {"boundary_rule", rule_name(s.rules.boundary)},
      {"rules", rules_part(s.rules)},
      {"bbox_mm", Json::array({point("surface.bbox_mm", s.bbox_mm.low),
                               point("surface.bbox_mm", s.bbox_mm.high)})},
      {"area_mm2", finite("surface.area_mm2", s.area_mm2)},
      {"depth", {{"min", s.depth_min}, {"max", s.depth_max}}},
      {"depths", s.depths},
      {"sampling_interval", {{"min", s.sampling_interval_min}, {"max", s.sampling_interval_max}}},
      {"seconds", finite("surface.seconds", s.seconds)},
      {"memory_bytes", s.memory_bytes},
      {"cell_bytes_counted", s.cell_bytes_counted},
      {"cell_bytes_allocated", s.cell_bytes_allocated}};
}

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

Json toolpath_part(const StageResult::Ran& r) {
  return {
      {"moves", r.path ? r.path->moves.size() : 0},
      {"planes", r.planes},
      {"sampling_interval", {{"min", r.sampling_interval_min}, {"max", r.sampling_interval_max}}},
      {"sampling_intervals", r.sampling_intervals},
      {"cut_length_mm", finite("toolpath.cut_length_mm", r.cut_length_mm)},
      {"rapid_length_mm", finite("toolpath.rapid_length_mm", r.rapid_length_mm)},
      {"machining_time_s", finite("toolpath.machining_time_s", r.machining_time_s)},
      {"chord_error_mm", finite("toolpath.chord_error_mm", r.path ? r.path->chord_error_mm : 0)},
      {"ignored_words", texts(r.ignored_words)},
      {"seconds", finite("toolpath.seconds", r.plan_seconds)},
      {"memory_bytes", r.path_memory_bytes}};
}

Json collision(const simulator::Finding& c, bool with_part) {
  Json out = {{"line", c.line},
              {"move", c.move},
              {"x", finite("collision.x", c.point.x)},
              {"y", finite("collision.y", c.point.y)},
              {"z", finite("collision.z", c.point.z)},
              {"depth_mm", finite("collision.depth_mm", c.depth_mm)}};
  if (with_part) out["part"] = clean_text(c.part);
  return out;
}

Json rapid_collisions(const std::vector<simulator::Finding>& all) {
  Json out = Json::array();
  for (const simulator::Finding& f : all)
    if (f.kind == simulator::FindingKind::rapid_through_stock) out.push_back(collision(f, false));
  return out;
}

Json holder_collisions(const std::vector<simulator::Finding>& all) {
  Json out = Json::array();
  for (const simulator::Finding& f : all)
    if (is_holder_collision(f.kind)) out.push_back(collision(f, true));
  return out;
}

/// Runs of moves with the same finding as one entry, at its worst place.
Json process_findings(const std::vector<simulator::Finding>& all) {
  Json out = Json::array();
  for (const simulator::FindingGroup& g : simulator::group_findings(all)) {
    const simulator::Finding& f = g.worst;
    const bool near = f.kind == simulator::FindingKind::near_miss;
    out.push_back({{"kind", simulator::name(g.kind)},
                   {"fails", fails(g.kind)},
                   {"part", clean_text(g.part)},
                   {"against", clean_text(g.against)},
                   {"first_line", g.first_line},
                   {"last_line", g.last_line},
                   {"count", g.count},
                   {"line", f.line},
                   {"move", f.move},
                   {"x", finite("process.x", f.point.x)},
                   {"y", finite("process.y", f.point.y)},
                   {"z", finite("process.z", f.point.z)},
                   {near ? "distance_mm" : "depth_mm",
                    finite("process.depth_mm", near ? -f.depth_mm : f.depth_mm)}});
  }
  return out;
}

Json removal_part(const simulator::RemovalTotals& t) {
  return {{"volume_mm3", finite("removal.volume_mm3", t.volume_mm3)},
          {"largest_rate_mm3_min", finite("removal.rate", t.largest_rate_mm3_min)},
          {"largest_rate_move", t.largest_rate_move},
          {"largest_axial_engagement_mm", finite("removal.axial", t.largest_axial_mm)},
          {"largest_radial_engagement_mm", finite("removal.radial", t.largest_radial_mm)},
          {"air_length_mm", finite("removal.air_length_mm", t.air_length_mm)},
          {"air_time_s", finite("removal.air_time_s", t.air_time_s)},
          {"line_spacing_mm", finite("removal.line_spacing_mm", t.spacing_mm)}};
}

Json surface_part(const StockSurfaceFigures& s) {
  return {{"vertices", s.vertices},
          {"triangles", s.triangles},
          {"voxel_mm", finite("simulation.surface.voxel_mm", s.voxel_mm)},
          {"unmoved_vertices", s.unmoved_vertices}};
}

Json agreement_part(const simulator::StockAgreement& a) {
  return {
      {"lines", a.lines},
      {"ends", a.ends},
      {"worst_end_mm", finite("agreement.worst_end_mm", a.worst_end_mm)},
      {"worst_side_mm", finite("agreement.worst_side_mm", a.worst_side_mm)},
      {"volume_difference_mm3", finite("agreement.volume", a.volume_difference_mm3())},
      {"volume_error_mm3", finite("agreement.error", a.dexel_error_mm3 + a.level_set_error_mm3)}};
}

Json simulation_part(const StageResult::Ran& r) {
  Json out = {{"voxel_mm", finite("simulation.voxel_mm", r.voxel_mm)},
              {"removed_volume_mm3", finite("simulation.removed_volume_mm3", r.removed_volume_mm3)},
              {"tiles", r.tiles},
              {"seconds", finite("simulation.seconds", r.simulation_seconds)},
              {"peak_memory_bytes", r.peak_memory_bytes},
              {"removal", removal_part(r.removal.totals)},
              {"agreement", agreement_part(r.agreement)},
              {"rapid_collisions", rapid_collisions(r.process)},
              {"holder_collisions", holder_collisions(r.process)},
              {"findings", process_findings(r.process)}};
  if (r.surface) out["surface"] = surface_part(*r.surface);
  return out;
}

std::string stage_name(const RunResult& result, std::size_t stage) {
  return stage < result.stages.size() ? clean_text(result.stages[stage].name) : "";
}

Json near_passes(const RunResult& result, const std::vector<verifier::NearPass>& passes) {
  Json out = Json::array();
  for (const verifier::NearPass& p : passes)
    out.push_back({{"stage", stage_name(result, p.stage)},
                   {"line", p.line},
                   {"move", p.move},
                   {"distance_mm", finite("finding.distance_mm", p.distance_mm)}});
  return out;
}

Json findings(const RunResult& result, const std::vector<verifier::Finding>& all) {
  Json out = Json::array();
  for (const verifier::Finding& f : all) {
    const model::Vec3& p = f.place.point;
    Json finding = {
        {"x", finite("finding.x", p.x)},
        {"y", finite("finding.y", p.y)},
        {"z", finite("finding.z", p.z)},
        {"depth_mm", finite("finding.depth_mm", f.depth_mm)},
        {"area_mm2", finite("finding.area_mm2", f.area_mm2)},
        {"patch", f.place.patch},
        {"u", finite("finding.u", f.place.u)},
        {"v", finite("finding.v", f.place.v)},
        {"stage", stage_name(result, f.stage)},
        {"line", f.line},
        {"move", f.move},
        {"body", clean_text(f.body)},
        {"extent_mm",
         {point("finding.extent", f.extent_mm.low), point("finding.extent", f.extent_mm.high)}}};
    if (!f.passes.empty()) finding["passes"] = near_passes(result, f.passes);
    out.push_back(std::move(finding));
  }
  return out;
}

Json bodies_part(const RunResult& result, const std::vector<verifier::BodyFigure>& bodies) {
  Json out = Json::array();
  for (const verifier::BodyFigure& b : bodies)
    out.push_back({{"stage", stage_name(result, b.stage)},
                   {"body", clean_text(b.body)},
                   {"gouge_mm", interval("bodies.gouge_mm", b.gouge_mm)}});
  return out;
}

Json budget_part(const std::vector<verifier::UncertaintyTerm>& terms) {
  Json out = Json::array();
  for (const verifier::UncertaintyTerm& t : terms)
    out.push_back({{"source", clean_text(t.source)},
                   {"bound_mm", finite("uncertainty.bound_mm", t.bound_mm)},
                   {"in_certificate", t.in_certificate}});
  return out;
}

Json deviation_part(const RunResult& result, const verifier::StageDeviation& d) {
  return {
      {"gouge_mm", interval("deviation.gouge_mm", d.gouge_mm)},
      {"uncut_mm", interval("deviation.uncut_mm", d.uncut_mm)},
      {"coverage", finite("deviation.coverage", d.coverage)},
      {"mean_mm", finite("deviation.mean_mm", d.mean_mm)},
      {"rms_mm", finite("deviation.rms_mm", d.rms_mm)},
      {"p01_mm", finite("deviation.p01_mm", d.p01_mm)},
      {"p50_mm", finite("deviation.p50_mm", d.p50_mm)},
      {"p99_mm", finite("deviation.p99_mm", d.p99_mm)},
      {"voxel_gouge_mm", finite("deviation.voxel_gouge_mm", d.voxel_gouge_mm)},
      {"voxel_uncut_mm", finite("deviation.voxel_uncut_mm", d.voxel_uncut_mm)},
      {"surface_area_mm2", finite("deviation.surface_area_mm2", d.surface_area_mm2)},
      {"reachable_area_mm2", finite("deviation.reachable_area_mm2", d.reachable_area_mm2)},
      {"unreachable_area_mm2", finite("deviation.unreachable_area_mm2", d.unreachable_area_mm2)},
      {"proven_reach",
       {{"reachable_mm2", finite("proven_reach", d.proven_reach.reachable_mm2)},
        {"unreachable_mm2", finite("proven_reach", d.proven_reach.unreachable_mm2)},
        {"undecided_mm2", finite("proven_reach", d.proven_reach.undecided_mm2)}}},
      {"unavoidable_uncut_mm",
       finite("deviation.unavoidable_uncut_mm", d.unavoidable_uncut_mm.low)},
      {"unavoidable_uncut_certified_mm",
       interval("deviation.unavoidable_uncut", d.unavoidable_uncut_mm)},
      {"resolution_mm", finite("deviation.resolution_mm", d.resolution_mm)},
      {"reached_resolution", d.reached_resolution},
      {"cells", d.cells},
      {"seconds", finite("deviation.seconds", d.seconds)},
      {"histogram",
       {{"edges_mm", numbers("histogram.edges_mm", d.histogram.edges_mm)},
        {"area_mm2", numbers("histogram.area_mm2", d.histogram.area_mm2)}}},
      {"bodies", bodies_part(result, d.bodies)},
      {"gouge_threshold_mm", finite("deviation.gouge_threshold_mm", d.gouge_threshold_mm)},
      {"uncut_threshold_mm", finite("deviation.uncut_threshold_mm", d.uncut_threshold_mm)},
      {"findings_complete", d.findings_complete},
      {"gouges", findings(result, d.gouges)},
      {"uncuts", findings(result, d.uncuts)},
      {"uncertainty", budget_part(d.budget)}};
}

/// Only the figures that the job limits.
Json gate_part(const verifier::GateLimits& l) {
  Json out = Json::object();
  if (l.has_gouge) out["gouge_mm"] = finite("gate.gouge_mm", l.gouge_mm);
  if (l.has_uncut) out["uncut_mm"] = finite("gate.uncut_mm", l.uncut_mm);
  if (l.has_coverage) out["coverage"] = finite("gate.coverage", l.coverage);
  return out;
}

Json cutter_part(const model::Cutter& c) {
  return {{"type", model::name(c.type)},
          {"diameter_mm", finite("cutter.diameter_mm", c.diameter_mm)},
          {"corner_radius_mm", finite("cutter.corner_radius_mm", c.corner_radius_mm)},
          {"flute_length_mm", finite("cutter.flute_length_mm", c.flute_length_mm)},
          {"taper_angle_deg", finite("cutter.taper_angle_deg", c.taper_angle_deg)},
          {"tip_angle_deg", finite("cutter.tip_angle_deg", c.tip_angle_deg)},
          {"text", model::to_text(c)}};
}

/// What programs were told of the machine, and where their frame lies.
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
  if (machine.home_mm) out["home_mm"] = point("programs.home_mm", *machine.home_mm);
  if (machine.second_home_mm)
    out["second_home_mm"] = point("programs.second_home_mm", *machine.second_home_mm);
  return out;
}

/// The text of the lines that findings name, of whatever stage found them.
Json named_program_lines(const RunResult& result, std::size_t index) {
  Json out = Json::array();
  if (!result.stages[index].ran || !result.stages[index].ran->program_text) return out;
  std::vector<std::uint32_t> wanted;
  for (std::size_t stage = index; stage < result.stages.size(); ++stage)
    for (const NamedLine& named : named_lines(result, stage, std::string::npos))
      if (named.stage == index) wanted.push_back(named.line);
  for (const ProgramLine& line : program_lines(*result.stages[index].ran->program_text, wanted, 0))
    out.push_back({{"line", line.line}, {"text", line.text}});
  return out;
}

Json stage_part(const RunResult& result, std::size_t index) {
  const StageResult& s = result.stages[index];
  Json out = {{"name", clean_text(s.name)}, {"tool", clean_text(s.tool)}};
  out["cutter"] = cutter_part(s.cutter);
  if (s.program.empty()) {
    out["strategy"] = clean_text(s.strategy);
  } else {
    out["program"] = clean_text(s.program);
    if (!s.program_part.empty()) out["program_part"] = clean_text(s.program_part);
  }
  out["allowance_mm"] = finite("stage.allowance_mm", s.allowance_mm);
  out["step_mm"] = finite("stage.step_mm", s.step_mm);
  out["tolerance_mm"] = finite("stage.tolerance_mm", s.tolerance_mm);
  out["gate"] = gate_part(s.limits);
  out["verdict"] = verifier::name(s.verdict());
  out["reasons"] = texts(s.decision.reasons);
  if (s.ran) {
    out["toolpath"] = toolpath_part(*s.ran);
    out["program_lines"] = named_program_lines(result, index);
    out["simulation"] = simulation_part(*s.ran);
    out["deviation"] = deviation_part(result, s.ran->deviation);
  }
  out["seconds"] = finite("stage.seconds", s.seconds);
  return out;
}

}  // namespace

void write_result_json(const RunResult& result, std::ostream& out) {
  Json root = {{"schema", "limitgauge.result/1"},
               {"job", clean_text(result.job)},
               {"version", clean_text(result.version)},
               {"created", clean_text(result.created)},
               {"threads", result.threads},
               {"verdict", verifier::name(result.verdict)}};
  root["inputs"] = inputs_json(result.inputs);
  root["stock"] = stock_part(result.raw_stock);
  root["surface"] = surface_part(result.surface);
  root["programs"] = programs_part(result);
  root["stages"] = Json::array();
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    root["stages"].push_back(stage_part(result, i));
  root["assumptions"] = texts(result.assumptions);
  out << root.dump(1) << '\n';
}

}  // namespace limitgauge::reports
