#include "simulator/process/tool_bodies.h"

#include <algorithm>
#include <cmath>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

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

double top_of(const ToolBody& body) {
  return body.base_mm + body.profile.length();
}

// Onto the last one of the same kind and radius, or as one of its own.
void add_cylinder(std::vector<ToolBody>& stack, const ToolBody& next) {
  if (!stack.empty() && stack.back().part == next.part) {
    ToolBody& last = stack.back();
    const double a = last.profile.largest_radius(), b = next.profile.largest_radius();
    if (std::abs(a - b) <= kSameRadius_mm) {
      last.profile = CutterProfile(std::min(a, b), top_of(next) - last.base_mm);
      return;
    }
  }
  stack.push_back(next);
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
      add_cylinder(above, {part, CutterProfile(c.diameter_mm / 2, c.length_mm), base});
      base += c.length_mm;
    }
  };
  stack(cutter.shank, ToolPart::shank);
  stack(cutter.holder, ToolPart::holder);
  for (const ToolBody& body : above)
    if (!is_wide(body) && body.base_mm < height_mm) over_flutes.push_back(body);
  // Nobody says what is above the last part.
  if (base < height_mm)
    over_flutes.push_back({ToolPart::cutter, CutterProfile(top_radius_mm, height_mm - base), base});
  join_parts(cutter);
}

void ToolBodies::join_parts(const model::Cutter& cutter) {
  // With room for rounding: what is wider by less is no step.
  const auto holds = [](const ToolBody& body, double radius) {
    return body.profile.largest_radius() >= radius - kSameRadius_mm;
  };
  for (std::size_t k = 0; k < above.size(); ++k) {
    const double radius = above[k].profile.largest_radius() - kSameRadius_mm;
    std::size_t first = k, last = k;
    while (first > 0 && holds(above[first - 1], radius)) --first;
    while (last + 1 < above.size() && holds(above[last + 1], radius)) ++last;
    const bool into_flutes = first == 0 && top_radius_mm >= radius;
    if (first == last && !into_flutes) continue;
    const double low = into_flutes ? flutes.profile.nose_height(radius) : above[first].base_mm;
    joined.push_back({above[k].part, CutterProfile(radius, top_of(above[last]) - low), low});
  }
  // Of a side that leans, more length is another shape.
  if (above.empty() || cutter.taper_angle_deg != 0 || !holds(above.front(), top_radius_mm)) return;
  std::size_t last = 0;
  while (last + 1 < above.size() && holds(above[last + 1], top_radius_mm)) ++last;
  model::Cutter longer = cutter;
  longer.flute_length_mm = top_of(above[last]);
  joined.push_back({ToolPart::cutter, CutterProfile(longer), 0});
}

std::vector<ToolBody> ToolBodies::parts() const {
  std::vector<ToolBody> all{flutes};
  all.insert(all.end(), above.begin(), above.end());
  return all;
}

ToolPart ToolBodies::part_at(double height_mm) const {
  if (above.empty() || height_mm <= flutes.profile.length()) return ToolPart::cutter;
  const auto part = std::find_if(above.begin(), above.end(),
                                 [&](const ToolBody& body) { return height_mm <= top_of(body); });
  return part == above.end() ? above.back().part : part->part;
}

bool ToolBodies::is_wide(const ToolBody& body) const {
  return body.profile.largest_radius() >= top_radius_mm - kSameRadius_mm;
}

bool ToolBodies::trails(const ToolBody& body) const {
  const double radius = body.profile.largest_radius();
  return radius <= top_radius_mm && std::all_of(above.begin(), above.end(), [&](const ToolBody& b) {
           return b.base_mm >= body.base_mm || b.profile.largest_radius() >= radius;
         });
}

bool ToolBodies::widest_at_top() const {
  return top_radius_mm >= flutes.profile.largest_radius() - kSameRadius_mm;
}

}  // namespace limitgauge::simulator
