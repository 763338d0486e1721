#include "verifier/feet/closest_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "model/base/chunks.h"
#include "verifier/cells/normal_cone.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using std::numbers::pi;

/// Stands for an unlimited search.
constexpr double kFarthest_mm = 1e9;
constexpr std::size_t kChunk = 256;

/// Sides k and k + 3 of the patch meet in corner k.
struct NearFeatures {
  std::array<bool, 4> sides{};
  bool at_corner(int k) const { return sides[k] && sides[(k + 3) % 4]; }
};

NearFeatures near_features(const FootCell& cell, double s, double t, const BezierJet& j) {
  // Cells so small surround an irregular vertex, and not all of them reach the patch's sides.
  if (length(j.du) + length(j.dv) < 2 * kOnFeature_mm) {
    const bool right = cell.u > 0.5, upper = cell.v > 0.5;
    return {{!upper, right, upper, !right}};
  }
  const double du = length(j.du), dv = length(j.dv);
  return {{cell.v <= 0 && t * dv <= kOnFeature_mm,
           cell.u + cell.size_u >= 1 && (1 - s) * du <= kOnFeature_mm,
           cell.v + cell.size_v >= 1 && (1 - t) * dv <= kOnFeature_mm,
           cell.u <= 0 && s * du <= kOnFeature_mm}};
}

void name_feature(const PatchFeatures& features, const NearFeatures& near, ClosestPoint& out) {
  for (int k = 0; k < 4; ++k)
    if (near.at_corner(k)) {
      out.feature = features.corners[k], out.open = features.open[k];
      return;
    }
  for (int k = 0; k < 4; ++k)
    if (near.sides[k] && features.sides[k] != SurfaceFeature::smooth) {
      out.feature = features.sides[k];
      out.open = out.feature == SurfaceFeature::boundary;
    }
}

Vec3 normal_of(const FootCell& cell, const BezierJet& j) {
  return cell.is_point ? cell.vertex_normal : normalized(cross(j.du, j.dv));
}

ClosestPoint describe(const SurfaceCells& cells, const Foot& foot, const Vec3& p) {
  ClosestPoint out;
  const FootCell& cell = cells.feet().cells()[foot.cell];
  const BezierJet j = jet(cell.shape, foot.s, foot.t);
  out.place = {cell.patch, cell.u_at(foot.s), cell.v_at(foot.t), j.position};
  out.normal = normal_of(cell, j);
  out.distance_mm = std::sqrt(foot.squared);
  name_feature(cells.features().of(cell.patch), near_features(cell, foot.s, foot.t, j), out);
  const Vec3 to = p - j.position;
  const Vec3 aside = to - out.normal * dot(to, out.normal);
  out.perpendicular = length(aside) <= kPerpendicular * out.distance_mm + kOnFeature_mm;
  return out;
}

/// How much of the surroundings of a place a cell takes up, as an angle.
double angle_taken(const FootCell& cell, const Foot& foot, const BezierJet& j) {
  if (cell.is_point) return angle_between(cell.vertex_u, cell.vertex_v);
  const auto at_end = [](double x, double size) {
    return x * size <= kOnFeature_mm || (1 - x) * size <= kOnFeature_mm;
  };
  const bool end_s = at_end(foot.s, length(j.du)), end_t = at_end(foot.t, length(j.dv));
  if (!end_s || !end_t) return end_s || end_t ? pi : 2 * pi;
  return angle_between(foot.s < 0.5 ? j.du : -j.du, foot.t < 0.5 ? j.dv : -j.dv);
}

Vec3 pseudo_normal(const FootTree& feet, const Vec3& place) {
  const double within = 2 * kOnFeature_mm;
  // A patch that ends in an irregular vertex here is seen through the vertex alone.
  std::set<int> ends_here;
  feet.each_near(place, within, [&](const FootCell& cell, const Foot&) {
    if (cell.is_point) ends_here.insert(cell.patch);
  });
  Vec3 sum;
  feet.each_near(place, within, [&](const FootCell& cell, const Foot& foot) {
    if (!cell.is_point && ends_here.contains(cell.patch)) return;
    const BezierJet j = jet(cell.shape, foot.s, foot.t);
    sum += normal_of(cell, j) * angle_taken(cell, foot, j);
  });
  return sum;
}

}  // namespace

std::optional<ClosestPoint> closest_point(const SurfaceCells& cells, const Vec3& p,
                                          double within_mm) {
  Foot best;
  within_mm = std::min(within_mm, kFarthest_mm);
  best.squared = within_mm * within_mm;
  cells.feet().nearest(p, best);
  if (best.cell == Foot::kNone) return std::nullopt;
  return describe(cells, best, p);
}

std::vector<std::optional<ClosestPoint>> closest_points(const SurfaceCells& cells,
                                                        std::span<const Vec3> points,
                                                        double within_mm,
                                                        const model::RunControl& control) {
  std::vector<std::optional<ClosestPoint>> out(points.size());
  model::parallel_chunks(points.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out[i] = closest_point(cells, points[i], within_mm);
  });
  return out;
}

std::optional<double> signed_distance_mm(const SurfaceCells& cells, const Vec3& p,
                                         const ClosestPoint& closest) {
  const Vec3 to = p - closest.place.point;
  if (closest.distance_mm <= kOnFeature_mm) return 0.0;
  if (closest.perpendicular)
    return dot(to, closest.normal) >= 0 ? closest.distance_mm : -closest.distance_mm;
  if (closest.open) return std::nullopt;
  const Vec3 normal = pseudo_normal(cells.feet(), closest.place.point);
  return dot(to, normal) >= 0 ? closest.distance_mm : -closest.distance_mm;
}

}  // namespace limitgauge::verifier
