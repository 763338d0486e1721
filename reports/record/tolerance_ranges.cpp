#include "reports/record/tolerance_ranges.h"

namespace limitgauge::reports::record {
namespace {

using Ranges = ToleranceRanges;
using model::Interval;

void add(Ranges& out, const std::string& name, const Interval& range) {
  if (!model::is_none(range)) out[name] = range;
}

/// Of the half width.
void add(Ranges& out, const std::string& name, double half_mm) {
  add(out, name, model::about_zero(half_mm));
}

}  // namespace

Ranges tolerance_ranges(const model::Tolerances& tolerances) {
  Ranges out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    add(out, "zero." + name, tolerances.zero_mm[axis]);
    add(out, "positioning." + name, tolerances.positioning_mm[static_cast<int>(axis)]);
  }
  for (const auto& [id, tool] : tolerances.tools) {
    const std::string of_tool = "tool." + id + ".";
    add(out, of_tool + "radius", tool.radius_mm);
    add(out, of_tool + "length", tool.length_mm);
    add(out, of_tool + "corner_radius", tool.corner_radius_mm);
    // Stated, it says what else the corner radius leaves as it is.
    if (tool.flat_mm) out[of_tool + "flat"] = *tool.flat_mm;
  }
  add(out, "path", tolerances.path_mm);
  add(out, "runout", tolerances.runout_mm);
  return out;
}

}  // namespace limitgauge::reports::record
