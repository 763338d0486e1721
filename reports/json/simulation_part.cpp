#include "reports/json/result_parts.h"

#include <cmath>

#include "reports/run/process.h"
#include "reports/text/text.h"

namespace limitgauge::reports::json {
namespace {

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

/// Null for an axis without limits.
Json travel_part(const model::Box3& travel) {
  Json out = Json::array();
  for (int axis = 0; axis < 3; ++axis)
    out.push_back(std::isfinite(travel.low[axis]) && std::isfinite(travel.high[axis])
                      ? Json::array({travel.low[axis], travel.high[axis]})
                      : Json());
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

Json fixture_part(const record::CheckedFixture& f) {
  Json out = {{"name", clean_text(f.name)},
              {"file", clean_text(f.file)},
              {"translate_mm", point("fixture.translate_mm", f.translate_mm)}};
  if (f.setup) out["setup"] = clean_text(*f.setup);
  if (f.axis) out["axis"] = *f.axis;
  return out;
}

/// Null for an end without a limit.
Json rotary_axis_part(const record::RotaryAxis& a) {
  const auto end = [](double deg) { return std::isfinite(deg) ? Json(deg) : Json(); };
  return {{"word", a.word},
          {"carries", a.is_head ? "tool" : "part"},
          {"direction", point("rotary_axis.direction", a.direction)},
          {"point_mm", point("rotary_axis.point_mm", a.point_mm)},
          {"range_deg", Json::array({end(a.low_deg), end(a.high_deg)})}};
}

template <class All, class Part>
Json parts_of(const All& all, const Part& part) {
  Json out = Json::array();
  for (const auto& one : all) out.push_back(part(one));
  return out;
}

}  // namespace

Json process_limits_part(const record::ProcessLimits& limits) {
  Json out = {{"contact_tolerance_mm", finite("process_limits", limits.contact_tolerance_mm)},
              {"near_miss_mm", finite("process_limits", limits.near_miss_mm)},
              {"travel_mm", limits.travel_mm ? travel_part(*limits.travel_mm) : Json()}};
  if (limits.fixtures) out["fixtures"] = parts_of(*limits.fixtures, fixture_part);
  if (limits.rotary_axes) out["rotary_axes"] = parts_of(*limits.rotary_axes, rotary_axis_part);
  return out;
}

Json simulation_part(const StageRun& r) {
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

}  // namespace limitgauge::reports::json
