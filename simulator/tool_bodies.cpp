#include "simulator/tool_bodies.h"

#include <algorithm>

namespace limitgauge::simulator {
namespace {

// Two radii that are meant to be the same: diameters are stated to micrometres.
constexpr double kSameRadius_mm = 1e-6;

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
    : flutes{ToolPart::cutter, CutterProfile(cutter), 0} {
  double base = cutter.flute_length_mm;
  const auto stack = [&](const std::vector<model::CylinderPart>& parts, ToolPart part) {
    for (const model::CylinderPart& c : parts) {
      above.push_back({part, CutterProfile(c.diameter_mm / 2, c.length_mm), base});
      base += c.length_mm;
    }
  };
  stack(cutter.shank, ToolPart::shank);
  stack(cutter.holder, ToolPart::holder);
  const double radius = flutes.profile.largest_radius();
  double free_from = cutter.flute_length_mm;
  const auto fill = [&](double to) {
    to = std::min(to, height_mm);
    if (to > free_from)
      over_flutes.push_back({ToolPart::cutter, CutterProfile(radius, to - free_from), free_from});
  };
  for (const ToolBody& body : above) {
    if (!is_wide(body)) continue;
    fill(body.base_mm);
    free_from = body.base_mm + body.profile.length();
  }
  fill(height_mm);
}

bool ToolBodies::is_wide(const ToolBody& body) const {
  return body.profile.largest_radius() >= flutes.profile.largest_radius() - kSameRadius_mm;
}

bool ToolBodies::widest_at_top() const {
  const CutterProfile& p = flutes.profile;
  return p.sample(p.largest_radius(), p.length()).distance <= kSameRadius_mm;
}

}  // namespace limitgauge::simulator
