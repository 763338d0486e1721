#include "model/part/tolerances.h"

#include <algorithm>
#include <stdexcept>

#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

Interval scaled(const Interval& range, double factor) {
  const bool holds_stated = range.low <= 0 && range.high >= 0;
  const double about = holds_stated ? 0 : (range.low + range.high) / 2;
  return {about + factor * (range.low - about), about + factor * (range.high - about)};
}

bool has_corner(CutterType type) {
  return type != CutterType::ball && type != CutterType::drill;
}

/// A taper whose tip is a ball stays one: its corner goes with its radius.
bool is_ball_tipped(const Cutter& cutter) {
  return cutter.type == CutterType::taper && cutter.corner_radius_mm == cutter.radius_mm();
}

void require_range(const Interval& range, const char* what) {
  if (!(range.low <= range.high))
    throw std::invalid_argument(std::string(what) + " runs from " + shortest(range.low) + " to " +
                                shortest(range.high) + "; expected a range from low to high");
}

}  // namespace

bool is_none(const Interval& range) {
  return range.low == 0 && range.high == 0;
}

Interval about_zero(double half) {
  return {-half, half};
}

Tolerances scaled(const Tolerances& tolerances, double factor) {
  Tolerances out = tolerances;
  for (Interval& range : out.zero_mm) range = scaled(range, factor);
  for (auto& [id, tool] : out.tools) {
    for (Interval* range : {&tool.radius_mm, &tool.length_mm, &tool.corner_radius_mm})
      *range = scaled(*range, factor);
    if (tool.flat_mm) tool.flat_mm = scaled(*tool.flat_mm, factor);
  }
  out.path_mm *= factor, out.runout_mm *= factor;
  out.positioning_mm = out.positioning_mm * factor;
  return out;
}

double farthest_off_mm(const Tolerances& tolerances) {
  double tool_mm = 0;
  for (const auto& [id, tool] : tolerances.tools) {
    const double flat = tool.flat_mm ? tool.flat_mm->largest() : 0;
    tool_mm = std::max(tool_mm, tool.radius_mm.largest() + tool.length_mm.largest() +
                                    tool.corner_radius_mm.largest() + flat);
  }
  const auto& zero = tolerances.zero_mm;
  return tool_mm + length(Vec3{zero[0].largest(), zero[1].largest(), zero[2].largest()}) +
         tolerances.path_mm + tolerances.runout_mm + length(tolerances.positioning_mm);
}

Cutter varied(const Cutter& cutter, const CutterOffset& by) {
  Cutter out = cutter;
  const double corner = by.corner_radius_mm;
  out.diameter_mm += 2 * by.radius_mm + 2 * (by.flat_mm ? *by.flat_mm + corner : 0);
  out.corner_radius_mm += corner;
  if (cutter.type == CutterType::ball || is_ball_tipped(cutter))
    out.corner_radius_mm = out.radius_mm();
  if (cutter.type == CutterType::flat && corner != 0) out.type = CutterType::bull;
  if (out.diameter_mm != cutter.diameter_mm || corner != 0) require_valid(out);
  return out;
}

void require_valid(const ToolTolerance& tolerance, const Cutter& cutter) {
  require_range(tolerance.radius_mm, "radius");
  require_range(tolerance.length_mm, "length");
  require_range(tolerance.corner_radius_mm, "corner_radius");
  if (tolerance.flat_mm) require_range(*tolerance.flat_mm, "flat");
  const bool corner = !is_none(tolerance.corner_radius_mm);
  if ((corner || tolerance.flat_mm) && (!has_corner(cutter.type) || is_ball_tipped(cutter)))
    throw std::invalid_argument(
        std::string(corner ? "corner_radius" : "flat") + " is no figure of its own of a " +
        (is_ball_tipped(cutter) ? "taper with a ball tip" : name(cutter.type)) +
        "; expected radius");
  if (tolerance.flat_mm && cutter.type == CutterType::apt)
    throw std::invalid_argument(
        "flat of an apt cutter follows from its other figures; expected "
        "radius or corner_radius");
  if (tolerance.flat_mm && !is_none(tolerance.radius_mm))
    throw std::invalid_argument(
        "radius and flat of one tool are both stated; the radius is flat and corner radius");
  for (const bool grown : {true, false}) {
    const auto end = [&](const Interval& r, bool high) { return high ? r.high : r.low; };
    CutterOffset by{end(tolerance.radius_mm, grown),
                    0,
                    end(tolerance.corner_radius_mm, tolerance.flat_mm ? grown : !grown),
                    {}};
    if (tolerance.flat_mm) by.flat_mm = end(*tolerance.flat_mm, grown);
    (void)varied(cutter, by);
  }
}

}  // namespace limitgauge::model
