#include "verifier/gate/gate_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using Rounding = double (*)(double);

/// `value` in four significant digits, rounded by `up_or_down`: what is said of an end of a
/// certified interval stays true. A number of four digits is itself, whatever its last bits say.
double outwards(double value, Rounding up_or_down) {
  if (value <= 0) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3);
  const double units = value / unit;
  const double nearest = std::round(units);
  return (std::abs(units - nearest) < kFourthDigit ? nearest : up_or_down(units)) * unit;
}

std::string four_digits(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g %s", value, unit);
  return text;
}

Interval outwards(const Interval& figure) {
  return {outwards(figure.low, std::floor), outwards(figure.high, std::ceil)};
}

}  // namespace

std::string length_text(double mm) {
  constexpr double kMicrometres_mm = 0.1, kNanometres_mm = 1e-6;
  if (std::abs(mm) >= kMicrometres_mm) return four_digits(mm, "mm");
  if (mm == 0 || std::abs(mm) >= kNanometres_mm) return four_digits(mm * 1e3, "µm");
  return four_digits(mm * 1e6, "nm");
}

std::string range_text(const Interval& figure) {
  const Interval shown = outwards(figure);
  return "between " + length_text(shown.low) + " and " + length_text(shown.high);
}

std::string area_text(double mm2) {
  return four_digits(mm2, "mm²");
}

std::string share_text(double share) {
  return four_digits(100 * share, "%");
}

std::string area_range_text(const Interval& area_mm2, double whole_mm2) {
  const Interval area = outwards(area_mm2),
                 share = outwards(Interval{area_mm2.low / whole_mm2, area_mm2.high / whole_mm2});
  return "between " + area_text(area.low) + " and " + area_text(area.high) + " (" +
         share_text(share.low) + " to " + share_text(share.high) + ")";
}

std::string place_text(const model::Vec3& p) {
  char text[128];
  std::snprintf(text, sizeof text, "at (%.3f, %.3f, %.3f) mm", p.x, p.y, p.z);
  return text;
}

std::string line_text(std::size_t stage, std::uint32_t line, std::span<const std::string> stages) {
  const std::string text = "program line " + std::to_string(line);
  return stage + 1 < stages.size() ? text + " of stage " + stages[stage] : text;
}

std::string deepest_text(const std::vector<Finding>& findings,
                         std::span<const std::string> stages) {
  if (findings.empty()) return {};
  const Finding& f =
      *std::max_element(findings.begin(), findings.end(),
                        [](const Finding& a, const Finding& b) { return a.depth_mm < b.depth_mm; });
  const std::string text = "; deepest " + length_text(f.depth_mm) + " " + place_text(f.place.point);
  if (f.line > 0) return text + ", " + line_text(f.stage, f.line, stages);
  return text + (f.raw_stock ? ", a face of the raw stock" : "");
}

std::string out_of_reach_text(const DeviationField& field, std::span<const std::string> stages) {
  const DeviationField::Sample* highest = nullptr;
  for (const DeviationField::Sample& s : field.samples)
    if (!s.reachable && (!highest || s.deviation_mm > highest->deviation_mm)) highest = &s;
  if (!highest) return {};
  const std::string text = "; of the places out of reach the highest, " +
                           length_text(std::max(0.0F, highest->deviation_mm)) + ", is " +
                           place_text(highest->place.point);
  return highest->line > 0 ? text + ", " + line_text(highest->stage, highest->line, stages) : text;
}

}  // namespace limitgauge::verifier
