#include "verifier/certificate/rim_strips.h"

#include <algorithm>
#include <cmath>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Cells larger than this hold more than a piece of the rim as good as straight.
constexpr double kLargest_mm = 0.3;
/// Sine of the angle to the plane from which on a face is taken to stand on it.
constexpr double kUpright = 0.7;
constexpr int kSplits = 2;

bool is_flat(const OffsetCell& cell) {
  if (cell.spread_rad > kFlat_rad || cell.remainder > kFlat_rad) return false;
  for (int k = 0; k < 16; ++k)
    if (std::abs(dot(cell.shape.control(k) - cell.middle, cell.normal)) > kDistanceRounding_mm)
      return false;
  return control_radius(cell.shape, cell.middle) <= kLargest_mm;
}

}  // namespace

Bezier RimStrips::Frame::strip(double from_x, double to_x) const {
  Bezier out;
  for (int k = 0; k < 16; ++k) {
    const double u = (k % 4) / 3.0, v = (k / 4) / 3.0;
    out.set(k, origin + across * (from_x + u * (to_x - from_x)) + along * (y0 + v * (y1 - y0)));
  }
  return out;
}

/// By the faces that stand on the plane next to the cell's corners and middle: the nearest one
/// gives the direction, and the others must not turn from it by more than a strip allows.
std::optional<RimStrips::Frame> RimStrips::frame_of(const OffsetCell& cell, double t_mm) {
  Vec3 across, turned[5];
  int found = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 5; ++k) {
    constexpr int kCorners[] = {0, 3, 12, 15};
    const Vec3 p = k < 4 ? cell.shape.control(kCorners[k]) : cell.middle;
    const Nearest at = bounds_.nearest(p + cell.normal * t_mm);
    const Vec3& g = at.distance.gradient;
    const Vec3 level = g - cell.normal * dot(g, cell.normal);
    if (length(level) < kUpright) continue;
    turned[found++] = normalized(level);
    if (std::abs(at.distance.value) < nearest)
      nearest = std::abs(at.distance.value), across = normalized(level);
  }
  const double size = 2 * control_radius(cell.shape, cell.middle);
  for (int k = 0; k < found; ++k)
    if (length(turned[k] - across) * size / 8 > kBeside_mm) return std::nullopt;
  if (found == 0) return std::nullopt;
  Frame f{cell.middle, across, cross(cell.normal, across), cell.normal};
  for (int k = 0; k < 16; ++k) {
    const Vec3 p = cell.shape.control(k) - cell.middle;
    f.x0 = std::min(f.x0, dot(p, f.across)), f.x1 = std::max(f.x1, dot(p, f.across));
    f.y0 = std::min(f.y0, dot(p, f.along)), f.y1 = std::max(f.y1, dot(p, f.along));
  }
  return f;
}

/// Up to where strips from the inner side on are proven to have no longer run: what was cut, and
/// what is beside it by next to nothing.
double RimStrips::gone_up_to(const Frame& f, double length_mm) {
  constexpr int kStrips = 3;
  constexpr double kFine_mm = kBeside_mm / 16;
  double from = f.x0;
  for (int k = 0; k < kStrips && from < f.x1; ++k) {
    const auto is_gone_to = [&](double x) {
      return bounds_.surely_within(offset_cell(f.strip(from, x), {}), length_mm);
    };
    if (is_gone_to(f.x1)) return f.x1;
    double low = from, high = f.x1;
    while (high - low > kFine_mm) {
      const double x = (low + high) / 2;
      (is_gone_to(x) ? low : high) = x;
    }
    if (low == from) break;
    from = low;
  }
  return from;
}

/// The outer part first, which is proven soonest.
bool RimStrips::unreachable_between(const Frame& f, double from_x, double to_x, int splits) {
  if (reach_.surely_unreachable(offset_cell(f.strip(from_x, to_x), f.normal, 0), &memory_))
    return true;
  if (splits == 0) return false;
  const double x = from_x + (to_x - from_x) / 4;
  return unreachable_between(f, x, to_x, splits - 1) &&
         unreachable_between(f, from_x, x, splits - 1);
}

std::optional<bool> RimStrips::surely_within(const OffsetCell& cell, double allowance_mm,
                                             double length_mm) {
  if (!is_flat(cell)) return std::nullopt;
  const auto frame = frame_of(cell, allowance_mm + length_mm);
  if (!frame) return std::nullopt;
  const double from = gone_up_to(*frame, length_mm);
  return from >= frame->x1 || unreachable_between(*frame, from, frame->x1, kSplits);
}

}  // namespace limitgauge::verifier
