#include "reports/json/result_parts.h"

#include "reports/text/text.h"

namespace limitgauge::reports::json {
namespace {

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

Json rules_part(const verifier::SurfaceRules& r, bool is_mesh) {
  return {{"scheme", is_mesh ? "facets" : "catmull-clark"},
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

Json left_out_part(const witness::Agreement& w) {
  return Json::array(
      {{{"what", "points without a limit mask, beyond those followed by refinement"},
        {"count", w.points_left_out}},
       {{"what",
         "normals at sharp or semi-sharp edges and vertices, ends of creases, interior "
         "valence 2, boundary vertices of three and more faces, and folds"},
        {"count", w.normals_left_out}}});
}

Json witness_part(const witness::Agreement& w) {
  Json part = {{"evaluator", clean_text(w.evaluator)},
               {"levels", w.levels},
               {"points", w.points},
               {"by_refinement", w.by_refinement},
               {"worst_mm", finite("surface.witness.worst_mm", w.worst_mm)},
               {"bound_mm", finite("surface.witness.bound_mm", w.bound_mm)},
               {"normals", w.normals},
               {"worst_normal_rad", finite("surface.witness", w.worst_normal_rad)},
               {"normal_bound_rad", finite("surface.witness", w.normal_bound_rad)},
               {"left_out", left_out_part(w)},
               {"seconds", finite("surface.witness.seconds", w.seconds)}};
  if (const auto& at = w.worst_at)
    part["worst_at"] = {{"x", finite("surface.witness.worst_at", at->point.x)},
                        {"y", finite("surface.witness.worst_at", at->point.y)},
                        {"z", finite("surface.witness.worst_at", at->point.z)},
                        {"patch", at->patch},
                        {"u", at->u},
                        {"v", at->v}};
  return part;
}

}  // namespace

Json surface_part(const SurfaceResult& s) {
  Json part = {
      {s.mesh ? "mesh" : "cage", clean_text(s.cage)},
      {"patches", s.summary.patches},
      {"faces", s.summary.faces},
      {"vertices", s.summary.vertices},
      {"boundary_edges", s.summary.boundary_edges},
      {"extraordinary_vertices", s.summary.extraordinary_vertices},
      {"creases", s.summary.creases},
      {"corners", s.summary.corners},
      {"holes", s.summary.holes},
      {"boundary_rule", rule_name(s.rules.boundary)},
      {"rules", rules_part(s.rules, s.mesh.has_value())},
      {"bbox_mm", Json::array({point("surface.bbox_mm", s.bbox_mm.low),
                               point("surface.bbox_mm", s.bbox_mm.high)})},
      {"area_mm2", finite("surface.area_mm2", s.area_mm2)},
      {"witness", witness_part(s.witness)},
      {"depth", {{"min", s.depth_min}, {"max", s.depth_max}}},
      {"depths", s.depths},
      {"sampling_interval", {{"min", s.sampling_interval_min}, {"max", s.sampling_interval_max}}},
      {"seconds", finite("surface.seconds", s.seconds)},
      {"memory_bytes", s.memory_bytes},
      {"cell_bytes_counted", s.cell_bytes_counted},
      {"cell_bytes_allocated", s.cell_bytes_allocated}};
  if (s.mesh) part["dropped_triangles"] = s.mesh->dropped_triangles;
  return part;
}

}  // namespace limitgauge::reports::json
