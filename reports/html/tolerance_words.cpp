#include "reports/html/tolerance_words.h"

#include <algorithm>
#include <cmath>

#include "model/text/number_text.h"
#include "reports/text/interval_text.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

using model::Interval;
using Of = verifier::Tolerance::Of;
using AxisRanges = std::array<Interval, 3>;

constexpr const char* kAxisLetters[] = {"X", "Y", "Z"};

std::string with_sign(double mm, const LengthUnit& unit) {
  if (mm == 0) return "0";
  return (mm < 0 ? "−" : "+") + stated_number(std::abs(mm), unit);
}

AxisRanges axes_about_zero(const model::Vec3& half_mm) {
  AxisRanges out;
  for (int axis = 0; axis < 3; ++axis) out[axis] = model::about_zero(half_mm[axis]);
  return out;
}

/// "zero ±5 µm an axis", "zero X ±5 µm, Z −1 to +2 µm"; empty where none is stated.
std::string axes_words(const char* what, const AxisRanges& ranges) {
  const auto is_like_first = [&](const Interval& r) {
    return r.low == ranges[0].low && r.high == ranges[0].high;
  };
  std::string out;
  if (std::all_of(ranges.begin(), ranges.end(), is_like_first))
    return model::is_none(ranges[0])
               ? out
               : std::string(what) + " " + range_words(ranges[0]) + " an axis";
  for (int axis = 0; axis < 3; ++axis)
    if (!model::is_none(ranges[axis]))
      out += (out.empty() ? std::string(what) + " " : std::string(", ")) + kAxisLetters[axis] +
             " " + range_words(ranges[axis]);
  return out;
}

std::string tool_words(const std::string& id, const model::ToolTolerance& tool) {
  std::string out;
  const auto add = [&](const char* what, const Interval& range) {
    if (!model::is_none(range))
      out += (out.empty() ? "" : ", ") + std::string(what) + " " + range_words(range);
  };
  add("radius", tool.radius_mm);
  add("length", tool.length_mm);
  add("corner radius", tool.corner_radius_mm);
  if (tool.flat_mm) add("corner’s centre from the axis", *tool.flat_mm);
  return out.empty() ? out : escape_markup(id) + ": " + out;
}

void add_tool(const std::string& id, const model::ToolTolerance& tool,
              std::vector<verifier::Tolerance>& out) {
  const auto add = [&](Of of, const Interval& range) { out.push_back({of, 0, id, range}); };
  add(Of::radius, tool.radius_mm);
  add(Of::length, tool.length_mm);
  add(Of::corner_radius, tool.corner_radius_mm);
  if (tool.flat_mm) add(Of::flat, *tool.flat_mm);
}

}  // namespace

std::vector<verifier::Tolerance> stated_tolerances(const model::Tolerances& tolerances) {
  std::vector<verifier::Tolerance> out;
  const auto add_axes = [&](Of of, const AxisRanges& ranges) {
    for (int axis = 0; axis < 3; ++axis) out.push_back({of, axis, {}, ranges[axis]});
  };
  const double path = tolerances.path_mm;
  add_axes(Of::zero, tolerances.zero_mm);
  for (const auto& [id, tool] : tolerances.tools) add_tool(id, tool, out);
  out.push_back({Of::runout, 0, {}, model::about_zero(tolerances.runout_mm)});
  add_axes(Of::positioning, axes_about_zero(tolerances.positioning_mm));
  add_axes(Of::path, axes_about_zero({path, path, path}));
  return out;
}

std::string range_words(const Interval& range_mm) {
  const LengthUnit unit = unit_for(std::max(std::abs(range_mm.low), std::abs(range_mm.high)));
  if (range_mm.low == -range_mm.high)
    return "±" + stated_number(range_mm.high, unit) + " " + unit.symbol;
  return with_sign(range_mm.low, unit) + " to " + with_sign(range_mm.high, unit) + " " +
         unit.symbol;
}

std::string offset_words(double mm) {
  if (mm == 0) return "0";
  const LengthUnit unit = unit_for(std::abs(mm));
  // Of a share of a range, which may have many digits.
  const double shown = std::stod(three_digits(std::abs(mm) * unit.per_mm));
  return (mm < 0 ? "−" : "+") + model::shortest(shown) + " " + unit.symbol;
}

std::string tolerances_words(const model::Tolerances& tolerances) {
  std::vector<std::string> parts = {axes_words("zero", tolerances.zero_mm)};
  for (const auto& [id, tool] : tolerances.tools) parts.push_back(tool_words(id, tool));
  const auto add_half = [&](const char* what, double half_mm) {
    if (half_mm != 0)
      parts.push_back(std::string(what) + " " + range_words(model::about_zero(half_mm)));
  };
  add_half("path", tolerances.path_mm);
  add_half("runout", tolerances.runout_mm);
  parts.push_back(axes_words("positioning", axes_about_zero(tolerances.positioning_mm)));
  std::string out;
  for (const std::string& part : parts)
    if (!part.empty()) out += (out.empty() ? "" : "; ") + part;
  return out;
}

}  // namespace limitgauge::reports::html
