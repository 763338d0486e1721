#include <algorithm>

#include "reports/json/result_parts.h"
#include "reports/text/text.h"
#include "verifier/gate/verify.h"

namespace limitgauge::reports::json {
namespace {

Json lengths(const char* key, const std::vector<verifier::NamedLength>& all) {
  Json out = Json::object();
  for (const verifier::NamedLength& l : all) out[clean_text(l.name)] = finite(key, l.mm);
  return out;
}

Json factor(const std::optional<double>& value) {
  return value ? Json(finite("robust.margin", *value)) : Json(nullptr);
}

Json margin_part(const verifier::ToleranceMargin& margin) {
  return {{"proven", factor(margin.proven)}, {"refuted", factor(margin.refuted)}};
}

Json figure_part(const RunResult& result, const verifier::RobustFigure& figure) {
  Json out = interval("deviation.robust", figure.figure_mm);
  out["at"] = lengths("robust.at", figure.at);
  out["reached_resolution"] = figure.reached_resolution;
  if (figure.place) {
    out["place"] = {{"x", finite("robust.x", figure.place->point.x)},
                    {"y", finite("robust.y", figure.place->point.y)},
                    {"z", finite("robust.z", figure.place->point.z)},
                    {"patch", figure.place->patch},
                    {"u", finite("robust.u", figure.place->u)},
                    {"v", finite("robust.v", figure.place->v)}};
    out["sensitivity"] = lengths("robust.sensitivity", figure.sensitivity);
    if (figure.voxel_mm) out["voxel_mm"] = finite("robust.voxel_mm", *figure.voxel_mm);
    if (!figure.raw_stock) {
      out["stage"] = stage_name(result, figure.stage);
      out["line"] = figure.line, out["move"] = figure.move;
      out["body"] = clean_text(figure.body);
    }
  }
  if (figure.margin) out["margin"] = margin_part(*figure.margin);
  return out;
}

Json range_part(const model::Interval& range) {
  return Json::array({finite("tolerances", range.low), finite("tolerances", range.high)});
}

Json tool_part(const model::ToolTolerance& tool) {
  Json out = Json::object();
  if (!model::is_none(tool.radius_mm)) out["radius_mm"] = range_part(tool.radius_mm);
  if (!model::is_none(tool.length_mm)) out["length_mm"] = range_part(tool.length_mm);
  if (!model::is_none(tool.corner_radius_mm))
    out["corner_radius_mm"] = range_part(tool.corner_radius_mm);
  if (tool.flat_mm) out["flat_mm"] = range_part(*tool.flat_mm);
  return out;
}

}  // namespace

Json robust_part(const RunResult& result, const verifier::RobustDeviation& robust,
                 const verifier::GateLimits& limits) {
  Json out = {{"gouge_mm", figure_part(result, robust.gouge)},
              {"uncut_mm", figure_part(result, robust.uncut)}};
  out["verdict"] = verifier::name(verifier::judge_robust(robust, limits));
  if (const verifier::RobustFigure* least = verifier::least_margin(robust)) {
    out["margin"] = margin_part(*least->margin);
    out["sensitivity"] = lengths("robust.sensitivity", least->sensitivity);
  }
  out["seconds"] = finite("robust.seconds", robust.seconds);
  return out;
}

Json tolerances_part(const model::Tolerances& tolerances) {
  Json out = {{"zero_mm", Json::array()}, {"tools", Json::object()}};
  for (const model::Interval& range : tolerances.zero_mm)
    out["zero_mm"].push_back(range_part(range));
  for (const auto& [id, tool] : tolerances.tools) out["tools"][clean_text(id)] = tool_part(tool);
  out["path_mm"] = finite("tolerances.path", tolerances.path_mm);
  out["runout_mm"] = finite("tolerances.runout", tolerances.runout_mm);
  out["positioning_mm"] = point("tolerances.positioning", tolerances.positioning_mm);
  return out;
}

}  // namespace limitgauge::reports::json
