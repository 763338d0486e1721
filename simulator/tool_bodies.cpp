#include "simulator/tool_bodies.h"

#include <algorithm>

namespace limitgauge::simulator {
namespace {

// Two radii that are meant to be the same: diameters are stated to micrometres.
constexpr double kSameRadius_mm = 1e-6;

// A profile that leans inwards is narrower at its top than below.
double top_radius(const CutterProfile& profile) {
  double in = 0, out = profile.largest_radius();
  if (profile.sample(out, profile.length()).distance <= kSameRadius_mm) return out;
  for (int i = 0; i < 60; ++i) {
    const double middle = (in + out) / 2;
    (profile.sample(middle, profile.length()).distance <= 0 ? in : out) = middle;
  }
  return in;
}

}  // namespace

const char* name(ToolPart part) {
  switch (part) {
    case ToolPart::cutter:
      return "cutter";
    case ToolPart::shank:
      return "shank";
    case ToolPart::holder:
      break;
  }
  return "holder";
}

ToolBodies::ToolBodies(const model::Cutter& cutter, double height_mm)
    : flutes{ToolPart::cutter, CutterProfile(cutter), 0},
      top_radius_mm(top_radius(flutes.profile)) {
  double base = cutter.flute_length_mm;
  const auto stack = [&](const std::vector<model::CylinderPart>& parts, ToolPart part) {
    for (const model::CylinderPart& c : parts) {
      above.push_back({part, CutterProfile(c.diameter_mm / 2, c.length_mm), base});
      base += c.length_mm;
    }
  };
  stack(cutter.shank, ToolPart::shank);
  stack(cutter.holder, ToolPart::holder);
  double free_from = cutter.flute_length_mm;
  const auto fill = [&](double to) {
    to = std::min(to, height_mm);
    if (to > free_from)
      over_flutes.push_back(
          {ToolPart::cutter, CutterProfile(top_radius_mm, to - free_from), free_from});
  };
  for (const ToolBody& body : above) {
    if (!is_wide(body)) continue;
    fill(body.base_mm);
    free_from = body.base_mm + body.profile.length();
  }
  fill(height_mm);
}

bool ToolBodies::is_wide(const ToolBody& body) const {
  return body.profile.largest_radius() >= top_radius_mm - kSameRadius_mm;
}

bool ToolBodies::widest_at_top() const {
  return top_radius_mm >= flutes.profile.largest_radius() - kSameRadius_mm;
}

}  // namespace limitgauge::simulator
