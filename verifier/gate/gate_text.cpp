#include "verifier/gate/gate_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/text/rounded.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

std::string four_digits(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g %s", value, unit);
  return text;
}

struct Unit {
  double per_mm;
  const char* name;
};

Unit unit_of(double mm) {
  constexpr double kMicrometres_mm = 0.1, kNanometres_mm = 1e-6;
  if (std::abs(mm) >= kMicrometres_mm) return {1, "mm"};
  if (mm == 0 || std::abs(mm) >= kNanometres_mm) return {1e3, "µm"};
  return {1e6, "nm"};
}

/// Four digits, or as many as show on which side of the limit it lies.
std::string end_text(double value, const Unit& unit, model::Rounding rounding,
                     const std::optional<double>& limit) {
  double shown = value * unit.per_mm;
  std::optional<double> beside;
  if (limit) {
    beside = model::without_dust(*limit * unit.per_mm);
    if (value == *limit) shown = *beside;
  }
  const std::string number =
      model::rounded_text(shown, model::significant_decimals(shown, 4), rounding, beside);
  return model::without_trailing_zeros(number) + " " + unit.name;
}

std::string end_text(double mm, model::Rounding rounding, const std::optional<double>& limit_mm) {
  return end_text(mm, unit_of(mm), rounding, limit_mm);
}

}  // namespace

std::string length_text(double mm) {
  const Unit unit = unit_of(mm);
  return four_digits(mm * unit.per_mm, unit.name);
}

std::string length_text(double mm, const std::optional<double>& limit_mm) {
  return limit_mm ? end_text(mm, model::Rounding::nearest, limit_mm) : length_text(mm);
}

std::string range_text(const Interval& figure, const std::optional<double>& limit_mm) {
  return "between " + end_text(figure.low, model::Rounding::down, limit_mm) + " and " +
         end_text(figure.high, model::Rounding::up, limit_mm);
}

std::string area_text(double mm2) {
  return four_digits(mm2, "mm²");
}

std::string share_text(double share) {
  return four_digits(100 * share, "%");
}

std::string area_range_text(const Interval& area_mm2, double whole_mm2,
                            const std::optional<double>& limit_mm2) {
  constexpr Unit kArea{1, "mm²"}, kShare{100, "%"};
  std::optional<double> share;
  if (limit_mm2) share = *limit_mm2 / whole_mm2;
  const auto low = model::Rounding::down, high = model::Rounding::up;
  return "between " + end_text(area_mm2.low, kArea, low, limit_mm2) + " and " +
         end_text(area_mm2.high, kArea, high, limit_mm2) + " (" +
         end_text(area_mm2.low / whole_mm2, kShare, low, share) + " to " +
         end_text(area_mm2.high / whole_mm2, kShare, high, share) + ")";
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

std::string deepest_text(const std::vector<Finding>& findings, std::span<const std::string> stages,
                         const std::optional<double>& limit_mm) {
  if (findings.empty()) return {};
  const Finding& f =
      *std::max_element(findings.begin(), findings.end(),
                        [](const Finding& a, const Finding& b) { return a.depth_mm < b.depth_mm; });
  const std::string text =
      "; deepest " + length_text(f.depth_mm, limit_mm) + " " + place_text(f.place.point);
  if (f.line > 0) return text + ", " + line_text(f.stage, f.line, stages);
  return text + (f.raw_stock ? ", a face of the raw stock" : "");
}

std::string reached_text(const RobustFigure& figure) {
  if (!figure.place) return {};
  std::string text = "; reached " + place_text(figure.place->point);
  const char* before = " with ";
  for (const NamedLength& value : figure.at) {
    if (value.mm == 0) continue;
    text += before + value.name + (value.mm > 0 ? " +" : " ") + length_text(value.mm);
    before = ", ";
  }
  return text;
}

std::string tolerances_text(const RobustFigure& figure, const Interval& stated_mm,
                            double limit_mm) {
  std::string text =
      " for all values of the tolerances (as stated " + range_text(stated_mm, limit_mm);
  if (figure.margin && figure.margin->proven) {
    text += "; proven up to " + model::factor_text(*figure.margin->proven, model::Rounding::down) +
            " times the tolerances";
  }
  return text + ")";
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
