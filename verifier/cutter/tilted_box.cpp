#include "verifier/cutter/tilted_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Moves beyond which a node has no box of its own: the bound along the axes is as good there.
constexpr std::size_t kMostBodies = 1024;

/// Normal of the plane z = ax + by + c that fits the tips best; the axis where none is one.
Vec3 normal_of(std::span<const SweptBody> bodies) {
  Vec3 mean;
  for (const SweptBody& body : bodies) mean += body.from + body.to;
  mean = mean / (2 * static_cast<double>(bodies.size()));
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (const SweptBody& body : bodies)
    for (const Vec3& tip : {body.from, body.to}) {
      const Vec3 d = tip - mean;
      xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y, xz += d.x * d.z, yz += d.y * d.z;
    }
  // Tips on a line leave the plane to turn about it: it leans as little as it can.
  const double aside = 1e-9 * (xx + yy);
  xx += aside, yy += aside;
  const double whole = xx * yy - xy * xy;
  if (!(whole > 0)) return {0, 0, 1};
  return normalized(Vec3{-(xz * yy - yz * xy) / whole, -(yz * xx - xz * xy) / whole, 1});
}

}  // namespace

double reach_of(const Vec3& way, const Vec3& half) {
  return std::abs(way.x) * half.x + std::abs(way.y) * half.y + std::abs(way.z) * half.z;
}

TiltedBox::TiltedBox(std::span<const SweptBody> bodies) : normal_(normal_of(bodies)) {
  const double level = std::hypot(normal_.x, normal_.y);
  side_ = level > 0 ? Vec3{-normal_.y / level, normal_.x / level, 0} : Vec3{1, 0, 0};
  third_ = cross(normal_, side_);
  level_ = {level, std::hypot(side_.x, side_.y), std::hypot(third_.x, third_.y)};
  model::Box3 box;
  lowest_z_ = std::numeric_limits<double>::infinity();
  for (const SweptBody& body : bodies)
    for (const Vec3& tip : {body.from, body.to}) {
      box.add(Vec3{dot(normal_, tip), dot(side_, tip), dot(third_, tip)});
      lowest_z_ = std::min(lowest_z_, tip.z);
    }
  low_ = box.low, high_ = box.high;
}

bool TiltedBox::serves(const CutterProfile& profile) {
  return profile.slope == 0 && profile.rise == 0 && profile.flat_mm >= 0;
}

/// A cutter is all points within its rounding of a level disc and what is above it. From a point
/// below all of these the nearest is on the discs themselves, which reach over the sides of the
/// tips' box by what they measure that way.
double TiltedBox::bound(const CutterProfile& profile, const Vec3& p, const Vec3& half) const {
  if (!is_above(profile, p, half)) return -std::numeric_limits<double>::infinity();
  return std::sqrt(square(profile, p, half)) - profile.rounding_mm - kDistanceRounding_mm;
}

double TiltedBox::square(const CutterProfile& profile, const Vec3& p, const Vec3& half) const {
  const Vec3 q{p.x, p.y, p.z - profile.core_mm};
  double square = 0;
  const auto add = [&](const Vec3& axis, double level, double low, double high) {
    const double at = dot(axis, q);
    double gap = std::max(low - at, at - high) - reach_of(axis, half);
    if (profile.flat_mm > 0) gap -= profile.flat_mm * level;
    if (gap > 0) square += gap * gap;
  };
  add(normal_, level_.x, low_.x, high_.x);
  add(side_, level_.y, low_.y, high_.y);
  add(third_, level_.z, low_.z, high_.z);
  return square;
}

std::vector<TiltedBox> tilted_boxes(const std::vector<model::BoxNode>& nodes,
                                    std::span<const SweptBody> bodies) {
  std::vector<TiltedBox> boxes(nodes.size());
  const auto ranges = model::element_ranges(nodes);
  for (std::size_t at = 0; at < nodes.size(); ++at) {
    const auto [first, last] = ranges[at];
    if (last - first <= kMostBodies) boxes[at] = TiltedBox(bodies.subspan(first, last - first));
  }
  return boxes;
}

}  // namespace limitgauge::verifier
