#include "verifier/reach/contact_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verifier/cells/normal_cone.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

Vec3 tip_at(const Vec3& core, double r, double angle, double z) {
  return core + Vec3{r * std::cos(angle), r * std::sin(angle), -z};
}

/// Parts of a cutter reach into each other by so much, so that what lies just beyond the end of one
/// is as deep in them together as in the whole cutter.
constexpr double kOverlap_mm = 1;

/// A cylinder of that radius or somewhat less, and how far it may be sunk into the top of flutes.
struct Sunk {
  double radius_mm = 0, by_mm = 0;
};

/// The flutes are convex: what holds the rim of its lower end and all of their axis holds it.
double sunk_mm(const CutterProfile& flutes, double radius_mm) {
  constexpr double kLeast_mm = 0.02;
  for (double by = kOverlap_mm; by >= kLeast_mm; by /= 2)
    if (closed_standing_distance(flutes, {}, {radius_mm, 0, flutes.top_mm - by}).value <= 0)
      return by;
  return 0;
}

Sunk sunk_into(const CutterProfile& flutes, double radius_mm) {
  constexpr double kNarrower = 0.95, kNarrowest = 1.0 / 16;
  Sunk sunk{radius_mm, sunk_mm(flutes, radius_mm)};
  while (sunk.by_mm == 0 && sunk.radius_mm > kNarrowest * radius_mm)
    sunk.radius_mm *= kNarrower, sunk.by_mm = sunk_mm(flutes, sunk.radius_mm);
  return sunk;
}

}  // namespace

std::vector<StandingPart> necked_parts(const CutterProfile& flutes, double top_mm,
                                       std::span<const model::CylinderPart> cylinders) {
  std::vector<StandingPart> parts{{flutes, 0, false}};
  double base = top_mm;
  for (std::size_t k = 0; k < cylinders.size(); ++k) {
    const auto overlap_with = [&](std::size_t other, bool counts) {
      return counts && other < cylinders.size() &&
                     cylinders[k].diameter_mm <= cylinders[other].diameter_mm
                 ? std::min(kOverlap_mm, cylinders[other].length_mm)
                 : 0.0;
    };
    const double down = overlap_with(k - 1, k > 0), up = overlap_with(k + 1, true);
    const model::CylinderPart& own = cylinders[k];
    parts.push_back({CutterProfile(model::CylinderPart{own.diameter_mm, own.length_mm + down + up}),
                     base - down, false});
    base += own.length_mm;
  }
  if (cylinders.empty()) return parts;
  const model::CylinderPart& lowest = cylinders.front();
  const Sunk sunk = sunk_into(flutes, std::min(lowest.diameter_mm / 2, flutes.top_radius_mm()));
  const model::CylinderPart joint{2 * sunk.radius_mm,
                                  sunk.by_mm + std::min(kOverlap_mm, lowest.length_mm)};
  parts.insert(parts.begin() + 1, {CutterProfile(joint), top_mm - sunk.by_mm, false});
  return parts;
}

Vec3 middle_tip(const ContactRegion& g) {
  const Vec3 core = (g.cores[0] + g.cores[1] + g.cores[2] + g.cores[3]) / 4;
  return tip_at(core, (g.r0 + g.r1) / 2, (g.angle0 + g.angle1) / 2, (g.z0 + g.z1) / 2);
}

BodyDistance part_plane(const StandingPart& part, const Vec3& tip, const Vec3& p) {
  const Vec3 at = tip + Vec3{0, 0, part.lift_mm};
  return part.endless ? standing_distance(part.profile, at, p)
                      : closed_standing_distance(part.profile, at, p);
}

PlanPiece::PlanPiece(const ContactRegion& g)
    : outer_(g.r1), cos_half_(std::cos(std::min((g.angle1 - g.angle0) / 2, std::numbers::pi))) {
  middle_ = tip_at({}, 1, (g.angle0 + g.angle1) / 2, 0);
  const Vec3 ends[] = {tip_at({}, 1, g.angle0, 0), tip_at({}, 1, g.angle1, 0)};
  corners_ = {ends[0] * g.r0, ends[1] * g.r0, ends[0] * g.r1, ends[1] * g.r1};
}

Vec3 PlanPiece::farthest(const Vec3& core, const Vec3& p) const {
  const double x = core.x - p.x, y = core.y - p.y, apart = std::sqrt(x * x + y * y);
  if (x * middle_.x + y * middle_.y >= apart * cos_half_) {
    const double scale = apart > 0 ? outer_ / apart : 0;
    const Vec3 out = apart > 0 ? Vec3{x * scale, y * scale, 0} : middle_ * outer_;
    return core + out;
  }
  Vec3 out;
  double most = -1;
  for (const Vec3& corner : corners_) {
    const double cx = x + corner.x, cy = y + corner.y, square = cx * cx + cy * cy;
    if (square > most) most = square, out = corner;
  }
  return core + out;
}

PlanHull hull_of(const ContactRegion& g) {
  constexpr int kTangents = 4;
  PlanHull sector = {{g.r0 * std::cos(g.angle0), g.r0 * std::sin(g.angle0)},
                     {g.r0 * std::cos(g.angle1), g.r0 * std::sin(g.angle1)},
                     {g.r1 * std::cos(g.angle0), g.r1 * std::sin(g.angle0)},
                     {g.r1 * std::cos(g.angle1), g.r1 * std::sin(g.angle1)}};
  const double step = (g.angle1 - g.angle0) / kTangents, out = g.r1 / std::cos(step / 2);
  for (int k = 0; k < kTangents; ++k) {
    const double angle = g.angle0 + (k + 0.5) * step;
    sector.push_back({out * std::cos(angle), out * std::sin(angle)});
  }
  PlanHull hull;
  for (const Vec3& core : g.cores)
    for (const model::Vec2& p : sector) hull.push_back({core.x + p.x, core.y + p.y});
  return corners_of(std::move(hull));
}

BodyDistance greatest_distance(const StandingPart& part, const ContactRegion& g,
                               const PlanPiece& plan, const Vec3& p) {
  BodyDistance out;
  out.value = -std::numeric_limits<double>::infinity();
  for (const Vec3& core : g.cores) {
    const Vec3 far = plan.farthest(core, p);
    for (const double z : {g.z0, g.z1}) {
      const BodyDistance d = part_plane(part, far - Vec3{0, 0, z}, p);
      if (d.value > out.value) out = d;
      if (g.z0 == g.z1) break;
    }
  }
  return out;
}

double part_bound_mm(const StandingPart& part, const Vec3& tip, const model::Box3& box) {
  const double dx = std::max({box.low.x - tip.x, 0.0, tip.x - box.high.x});
  const double dy = std::max({box.low.y - tip.y, 0.0, tip.y - box.high.y});
  const double base = tip.z + part.lift_mm;
  const double open = open_value(part.profile, std::sqrt(dx * dx + dy * dy), box.high.z - base);
  return part.endless ? open : std::max(open, box.low.z - base - part.profile.top_mm);
}

CellRectangle rectangle_round(const Bezier& cell, const Vec3& normal) {
  const Vec3 centre = middle(cell);
  const InnerChords chords = inner_chords(cell);
  const Vec3 longer = dot(chords.u, chords.u) >= dot(chords.v, chords.v) ? chords.u : chords.v;
  Vec3 along = longer - normal * dot(longer, normal);
  along = dot(along, along) > 0 ? normalized(along) : verifier::across(normal);
  const Vec3 across = cross(normal, along);
  double wide = 0, tall = 0;
  CellRectangle out;
  for (int k = 0; k < 16; ++k) {
    const Vec3 p = cell.control(k) - centre;
    wide = std::max(wide, std::abs(dot(p, along)));
    tall = std::max(tall, std::abs(dot(p, across)));
    out.thickness_mm = std::max(out.thickness_mm, std::abs(dot(p, normal)));
  }
  for (int k = 0; k < 4; ++k)
    out.corners[k] = centre + along * (k & 1 ? wide : -wide) + across * (k & 2 ? tall : -tall);
  return out;
}

}  // namespace limitgauge::verifier
