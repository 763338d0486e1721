#include <algorithm>
#include <stdexcept>

#include "app/job/job_parts.h"
#include "app/toml/toml_table.h"
#include "model/text/message_text.h"
#include "verifier/robust/certifiable.h"

namespace limitgauge::app {
namespace {

/// `zero = 0.005` would be a guess at what is meant of three axes, so each is stated.
model::Vec3 half_widths(const TomlTable& table, std::string_view key) {
  model::Vec3 out;
  const std::array<model::Interval, 3> ranges = table.tolerances_mm(key);
  for (int axis = 0; axis < 3; ++axis) {
    if (ranges[axis].low != -ranges[axis].high)
      throw model::InputError(table.place(key),
                              "\"" + std::string(key) + "\" of " + table.where() +
                                  " differs from move to move, so it has no preferred side",
                              "half widths, as [0.002, 0.002, 0.001]");
    out[axis] = ranges[axis].high;
  }
  return out;
}

model::ToolTolerance read_tool(const toml::table& table, const std::string& id,
                               const model::Cutter& cutter) {
  const TomlTable keys(table, "\"tool." + id + "\" of [tolerances]",
                       {"radius", "length", "corner_radius", "flat"});
  model::ToolTolerance tool;
  if (keys.has("radius")) tool.radius_mm = keys.tolerance_mm("radius");
  if (keys.has("length")) tool.length_mm = keys.tolerance_mm("length");
  if (keys.has("corner_radius")) tool.corner_radius_mm = keys.tolerance_mm("corner_radius");
  if (keys.has("flat")) tool.flat_mm = keys.tolerance_mm("flat");
  try {
    model::require_valid(tool, cutter);
  } catch (const std::invalid_argument& error) {
    throw model::InputError(place_of(table.source()), keys.where() + ": " + error.what(),
                            "tolerances at both of whose ends there is such a cutter");
  }
  return tool;
}

}  // namespace

void read_tolerances(const TomlTable& root, std::span<const model::Cutter> tools, Job& job) {
  if (!root.has("tolerances")) return;
  const TomlTable table(root.table("tolerances"), "[tolerances]",
                        {"zero", "tool", "path", "runout", "positioning", "margin"});
  model::Tolerances out = job.tolerances.value_or(model::Tolerances{});
  if (table.has("zero")) out.zero_mm = table.tolerances_mm("zero");
  if (table.has("tool")) {
    std::vector<const char*> ids;
    for (const model::Cutter& cutter : tools) ids.push_back(cutter.id.c_str());
    const TomlTable stated(table.table("tool"), "\"tool\" of [tolerances]", {}, ids);
    for (const model::Cutter& cutter : tools) {
      const std::string& id = cutter.id;
      if (!stated.has(id)) continue;
      const toml::node& value = *table.table("tool").get(id);
      if (!value.is_table())
        throw model::InputError(place_of(value.source()),
                                "\"tool." + id + "\" of [tolerances] is no table",
                                "a table as { radius = 0.01, length = 0.005 }");
      out.tools[id] = read_tool(*value.as_table(), id, cutter);
    }
  }
  if (table.has("path")) out.path_mm = table.length_or_zero_mm("path");
  if (table.has("runout")) out.runout_mm = table.length_or_zero_mm("runout");
  if (table.has("positioning")) out.positioning_mm = half_widths(table, "positioning");
  if (table.has("margin")) job.finds_margin = table.boolean("margin");
  for (const model::Cutter& cutter : tools) try {
      verifier::require_certifiable(out, cutter);
    } catch (const std::invalid_argument& error) {
      throw model::InputError(root.place("tolerances"), error.what(),
                              "tolerances that can be certified of this tool");
    }
  job.tolerances = std::move(out);
}

}  // namespace limitgauge::app
