#include "engine/strategy/levels/waterline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/strategy/raster/isoline.h"
#include "engine/tolerance.h"
#include "model/base/chunks.h"
#include "model/geometry/polyline.h"

namespace limitgauge::engine::strategy {
namespace {

/// Shares of the tolerance: how far chords between points of the curve may leave it, by how much
/// passes are pushed out so that chords may cut corners, and what reduction may use of the rest.
constexpr double kCurveShare = 0.1, kPushShare = 0.3, kCurveReductionShare = 0.8;
constexpr double kCrossingShare = 0.01;

/// To the left of the way from `a` to `b`: the free side.
FlatPoint left_of(const FlatPoint& a, const FlatPoint& b) {
  const double length = distance(a, b);
  if (length <= 0) return {0, 0};
  return {-(b.y - a.y) / length, (b.x - a.x) / length};
}

FlatPoint moved(const FlatPoint& p, const FlatPoint& direction, double by) {
  return {p.x + direction.x * by, p.y + direction.y * by};
}

/// The curves on which the tip height passes `height_mm`: what is higher is forbidden. Points lie
/// on the free side, within `tolerance_mm / 100` of the curve; the forbidden side is on the right.
class HeightCurves {
 public:
  HeightCurves(const CutterLocations& locations, const TipRaster& tips, double height_mm,
               double tolerance_mm)
      : locations_(locations), tips_(tips), height_(height_mm), tolerance_(tolerance_mm) {}

  /// Passes of the tip beside the curves: proven clear, within the tolerance of them, no denser
  /// than that asks for. A curve whose chords cannot be proven clear is left open there.
  std::vector<Waterline> passes() const;

 private:
  /// Tip height at a place less that of the curve; minus infinity where nothing is under the
  /// cutter.
  double above(const FlatPoint& p) const;
  bool held_at(const FlatPoint& p) const { return above(p) > 0; }
  /// The curve between a free and a forbidden place, from the free side.
  FlatPoint crossing(FlatPoint free, FlatPoint held) const;
  FlatPoint exact(const FlatPoint& edge_middle) const;
  std::vector<FlatPoint> exact_points(const Isoline& line) const;
  std::vector<FlatPoint> densified(const std::vector<FlatPoint>& points) const;
  void densify(const FlatPoint& a, const FlatPoint& b, std::vector<FlatPoint>& dense) const;
  bool find_beside(const FlatPoint& a, const FlatPoint& b, FlatPoint& found) const;
  std::vector<FlatPoint> pushed(const std::vector<FlatPoint>& curve, bool closed) const;
  void add_passes(const std::vector<FlatPoint>& curve, bool closed,
                  std::vector<Waterline>& made) const;

  const CutterLocations& locations_;
  const TipRaster& tips_;
  double height_, tolerance_;
};

double HeightCurves::above(const FlatPoint& p) const {
  const auto z = locations_.tip_z(p.x, p.y);
  return z ? *z - height_ : -std::numeric_limits<double>::infinity();
}

/// Where heights are finite, looks where a straight line through them passes the curve, a little
/// toward the middle so that brackets close from both sides; halves what that leaves too wide.
FlatPoint HeightCurves::crossing(FlatPoint free, FlatPoint held) const {
  const double close = kCrossingShare * tolerance_;
  double below = above(free), over = above(held);
  const auto look = [&](double t) {
    const FlatPoint p = lerp(free, held, t);
    const double z = above(p);
    (z > 0 ? held : free) = p;
    (z > 0 ? over : below) = z;
  };
  for (double width = distance(free, held); width > close; width = distance(free, held)) {
    if (std::isfinite(below)) {
      const double at = below / (below - over), aside = close / (2 * width);
      look(at < 0.5 ? std::min(0.5, at + aside) : std::max(0.5, at - aside));
    }
    if (distance(free, held) > width / 2) look(0.5);
  }
  return free;
}

/// Marching over a field of two values meets every edge in its middle: half-odd in one coordinate.
FlatPoint HeightCurves::exact(const FlatPoint& edge_middle) const {
  const Raster& r = tips_.raster;
  const auto twice = [&](double at, double low) {
    return static_cast<int>(std::lround(2 * (at - low) / r.pixel_mm));
  };
  const int i2 = twice(edge_middle.x, r.x0), j2 = twice(edge_middle.y, r.y0);
  const int i = i2 / 2, j = j2 / 2, ni = i + i2 % 2, nj = j + j2 % 2;
  const FlatPoint a{r.x(i), r.y(j)}, b{r.x(ni), r.y(nj)};
  return tips_.at(i, j) > height_ ? crossing(b, a) : crossing(a, b);
}

std::vector<FlatPoint> HeightCurves::exact_points(const Isoline& line) const {
  std::vector<FlatPoint> points;
  for (const FlatPoint& p : line.points) points.push_back(exact(p));
  std::reverse(points.begin(), points.end());
  return points;
}

/// Looks for the curve on the line across the middle of a chord, beyond what chords may leave it by
/// and no farther than leaves both halves shorter than the chord.
bool HeightCurves::find_beside(const FlatPoint& a, const FlatPoint& b, FlatPoint& found) const {
  const FlatPoint middle = lerp(a, b, 0.5), left = left_of(a, b);
  const bool held = held_at(middle);
  const double side = held ? 1 : -1;
  FlatPoint before = middle;
  constexpr double kFarthest = 0.8;
  const double farthest = kFarthest * distance(a, b);
  const double close = kCurveShare * tolerance_;
  for (double away = close; away <= farthest; away *= 2) {
    const FlatPoint next = moved(middle, left, side * away);
    if (held_at(next) != held) {
      if (away <= close) return false;
      found = held ? crossing(next, before) : crossing(before, next);
      return true;
    }
    before = next;
  }
  return false;
}

void HeightCurves::densify(const FlatPoint& a, const FlatPoint& b,
                           std::vector<FlatPoint>& dense) const {
  FlatPoint beside;
  if (distance(a, b) > 2 * kCurveShare * tolerance_ && find_beside(a, b, beside)) {
    densify(a, beside, dense);
    densify(beside, b, dense);
    return;
  }
  dense.push_back(b);
}

std::vector<FlatPoint> HeightCurves::densified(const std::vector<FlatPoint>& points) const {
  std::vector<FlatPoint> dense = {points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) densify(points[i - 1], points[i], dense);
  return dense;
}

std::vector<FlatPoint> HeightCurves::pushed(const std::vector<FlatPoint>& curve,
                                            bool closed) const {
  std::vector<FlatPoint> out;
  const std::size_t n = curve.size();
  for (std::size_t i = 0; i < n; ++i) {
    // Of a closed curve the last point is the first again.
    const FlatPoint& before = i > 0 ? curve[i - 1] : closed ? curve[n - 2] : curve[i];
    const FlatPoint& after = i + 1 < n ? curve[i + 1] : closed ? curve[1] : curve[i];
    const FlatPoint left = left_of(before, after);
    double by = kPushShare * tolerance_;
    constexpr double kLeast = 0.1;
    const double least = kLeast * by;
    while (by > least && held_at(moved(curve[i], left, by))) by /= 2;
    out.push_back(by > least ? moved(curve[i], left, by) : curve[i]);
  }
  return out;
}

void HeightCurves::add_passes(const std::vector<FlatPoint>& curve, bool closed,
                              std::vector<Waterline>& made) const {
  std::vector<Vec3> exact, tips;
  for (const FlatPoint& p : curve) exact.push_back({p.x, p.y, height_});
  for (const FlatPoint& p : pushed(curve, closed)) tips.push_back({p.x, p.y, height_});
  const auto kept = model::reduce_chords(tips.size(), [&](std::size_t i, std::size_t j) {
    for (std::size_t k = i + 1; k < j; ++k)
      if (distance_to_segment(exact[k], tips[i], tips[j]) > kCurveReductionShare * tolerance_)
        return false;
    return locations_.clears(tips[i], tips[j], 0);
  });
  std::vector<Waterline> parts(1);
  parts.back().closed = false;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const bool neighbours = k > 0 && kept[k] == kept[k - 1] + 1;
    if (neighbours && !locations_.clears(tips[kept[k - 1]], tips[kept[k]], 0))
      parts.push_back({{}, false});
    parts.back().tips.push_back(tips[kept[k]]);
  }
  if (closed && parts.size() == 1) {
    parts.front().closed = true;
    parts.front().tips.pop_back();
  } else if (closed) {
    // What ends where the curve began goes on with what begins there.
    auto& first = parts.front().tips;
    parts.back().tips.insert(parts.back().tips.end(), first.begin() + 1, first.end());
    parts.erase(parts.begin());
  }
  for (Waterline& part : parts)
    if (part.tips.size() > 1) made.push_back(std::move(part));
}

std::vector<Waterline> HeightCurves::passes() const {
  const Raster& raster = tips_.raster;
  std::vector<float> field(tips_.z.size());
  std::transform(tips_.z.begin(), tips_.z.end(), field.begin(),
                 [&](double z) { return z > height_ ? 1.0F : -1.0F; });
  std::vector<Waterline> made;
  for (const Isoline& line : isolines(raster, field, whole(raster), 0)) {
    std::vector<FlatPoint> points = exact_points(line);
    const auto same = [](const FlatPoint& a, const FlatPoint& b) {
      return a.x == b.x && a.y == b.y;
    };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() > 2) add_passes(densified(points), line.closed, made);
  }
  return made;
}

}  // namespace

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const TipRaster& tips,
                                               const std::vector<double>& heights_mm,
                                               double tolerance_mm,
                                               const model::RunControl& control) {
  std::vector<std::vector<Waterline>> made(heights_mm.size());
  model::parallel_chunks(made.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      made[i] =
          HeightCurves(locations, tips, heights_mm[i] + kAbovePlateaus_mm, tolerance_mm).passes();
    control.report(static_cast<double>(end) / static_cast<double>(made.size()));
  });
  return made;
}

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const std::vector<double>& heights_mm,
                                               const WaterlineRequest& request,
                                               const model::RunControl& control) {
  return waterlines(locations,
                    make_tip_raster(locations, request.window, request.spacing_mm, control),
                    heights_mm, request.tolerance_mm, control);
}

}  // namespace limitgauge::engine::strategy
