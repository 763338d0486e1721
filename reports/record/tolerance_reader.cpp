#include "reports/record/record_reader.h"

namespace limitgauge::reports::record {
namespace {

/// Zero or more, or null where none is known.
std::optional<double> read_factor(const JsonValue& factor) {
  if (factor.is_null()) return std::nullopt;
  return factor.length();
}

verifier::ToleranceMargin read_margin(const JsonValue& margin) {
  const verifier::ToleranceMargin out{read_factor(margin["proven"]),
                                      read_factor(margin["refuted"])};
  if (out.proven && out.refuted && *out.refuted < *out.proven)
    margin.refuse("is refuted below what is proven", "a margin");
  return out;
}

bool reached_resolution(const JsonValue& figure) {
  const std::optional<JsonValue> stated = figure.find("reached_resolution");
  return !stated || stated->flag();
}

/// A figure of which nothing is said is as stated.
void read_range(const JsonValue& tool, const char* key, verifier::Interval& out) {
  if (const std::optional<JsonValue> range = tool.find(key)) out = range->range();
}

model::ToolTolerance read_tool(const JsonValue& tool) {
  model::ToolTolerance out;
  read_range(tool, "radius_mm", out.radius_mm);
  read_range(tool, "length_mm", out.length_mm);
  read_range(tool, "corner_radius_mm", out.corner_radius_mm);
  if (const std::optional<JsonValue> flat = tool.find("flat_mm")) out.flat_mm = flat->range();
  return out;
}

}  // namespace

RobustMeasures read_robust(const JsonValue& robust, const std::string& name,
                           const LineTexts& texts) {
  RobustMeasures out;
  const JsonValue gouge = robust["gouge_mm"], uncut = robust["uncut_mm"];
  out.gouge_mm = gouge.interval();
  out.uncut_mm = uncut.interval();
  out.reached_resolution = reached_resolution(gouge) && reached_resolution(uncut);
  out.gouge = read_reached(gouge, name, texts);
  out.uncut = read_reached(uncut, name, texts);
  if (const std::optional<JsonValue> margin = robust.find("margin"))
    out.margin = read_margin(*margin);
  return out;
}

model::Tolerances read_tolerances(const JsonValue& tolerances) {
  model::Tolerances out;
  const std::vector<JsonValue> zero = tolerances["zero_mm"].items();
  if (zero.size() != out.zero_mm.size())
    tolerances["zero_mm"].refuse("has not three entries", "a range for each axis");
  for (std::size_t axis = 0; axis < zero.size(); ++axis) out.zero_mm[axis] = zero[axis].range();
  for (const auto& [id, tool] : tolerances["tools"].members()) out.tools[id] = read_tool(tool);
  out.path_mm = tolerances["path_mm"].length();
  out.runout_mm = tolerances["runout_mm"].length();
  out.positioning_mm = tolerances["positioning_mm"].point();
  return out;
}

}  // namespace limitgauge::reports::record
