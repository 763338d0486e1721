#include "reports/json/result_parts.h"

#include "reports/text/text.h"

namespace limitgauge::reports::json {
namespace {

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
    if (const MeshDesign* mesh = result.mesh_design())
      finding["triangle"] = mesh->triangle_of(f.place.patch);
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

/// Seconds by their own name, as everywhere: what compares results leaves those out.
Json phases_part(const verifier::StageDeviation::Phases& p) {
  const auto phase = [](double seconds) { return Json{{"seconds", finite("phases", seconds)}}; };
  return {{"reach", phase(p.reach_s)}, {"certificate", phase(p.certificate_s)},
          {"field", phase(p.field_s)}, {"unavoidable", phase(p.unavoidable_s)},
          {"rays", phase(p.rays_s)},   {"findings", phase(p.findings_s)}};
}

}  // namespace

Json deviation_part(const RunResult& result, const verifier::StageDeviation& d,
                    const verifier::GateLimits& limits) {
  Json out = {
      {"gouge_mm", interval("deviation.gouge_mm", d.gouge_mm)},
      {"uncut_mm", interval("deviation.uncut_mm", d.uncut_mm)},
      {"missing_stock_mm", interval("deviation.missing_stock_mm", d.missing_stock_mm)},
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
      {"reach",
       {{"reachable_mm2", finite("reach", d.proven_reach.reachable_mm2)},
        {"unreachable_mm2", finite("reach", d.proven_reach.unreachable_mm2)},
        {"undecided_mm2", finite("reach", d.proven_reach.undecided_mm2)}}},
      {"unavoidable_uncut_mm",
       finite("deviation.unavoidable_uncut_mm", d.unavoidable_uncut_mm.low)},
      {"unavoidable_uncut_certified_mm",
       interval("deviation.unavoidable_uncut", d.unavoidable_uncut_mm)},
      {"resolution_mm", finite("deviation.resolution_mm", d.resolution_mm)},
      {"reached_resolution", d.reached_resolution},
      {"cells", d.cells},
      {"seconds", finite("deviation.seconds", d.seconds)},
      {"phases", phases_part(d.phases)},
      {"histogram",
       {{"edges_mm", numbers("histogram.edges_mm", d.histogram.edges_mm)},
        {"area_mm2", numbers("histogram.area_mm2", d.histogram.area_mm2)}}},
      {"bodies", bodies_part(result, d.bodies)},
      {"gouge_threshold_mm", finite("deviation.gouge_threshold_mm", d.gouge_threshold_mm)},
      {"uncut_threshold_mm", finite("deviation.uncut_threshold_mm", d.uncut_threshold_mm)},
      {"findings_complete", d.findings_complete},
      {"gouges", findings(result, d.gouges)},
      {"uncuts", findings(result, d.uncuts)},
      {"missing_stocks", findings(result, d.missing_stock)},
      {"uncertainty", budget_part(d.budget)}};
  if (d.missing_allowance)
    out["missing_allowance"] = {
        {"depth_mm", finite("missing_allowance.depth_mm", d.missing_allowance->depth_mm)},
        {"at", point("missing_allowance.at", d.missing_allowance->place.point)}};
  if (d.robust) out["robust"] = robust_part(result, *d.robust, limits);
  return out;
}

}  // namespace limitgauge::reports::json
