#include "engine/strategy/levels/waterline.h"

#include <algorithm>
#include <span>
#include <utility>

#include "engine/strategy/levels/height_curves.h"
#include "engine/tolerance.h"
#include "model/base/chunks.h"
#include "model/geometry/polyline.h"

namespace limitgauge::engine::strategy {
namespace {

/// Shares of the tolerance: by how much passes are pushed out so that chords may cut corners, and
/// what reduction may use of what the curve's chords leave.
constexpr double kPushShare = 0.3, kCurveReductionShare = 0.8;

/// Makes passes of the tip beside curves: proven clear, within the tolerance of them, no denser
/// than that asks for. A curve whose chords cannot be proven clear is left open there.
class PassMaker {
 public:
  PassMaker(const CutterLocations& locations, const HeightCurves& curves, double tolerance_mm)
      : locations_(locations), curves_(curves), tolerance_(tolerance_mm) {}

  std::vector<Waterline> passes() const {
    std::vector<Waterline> made;
    for (const Isoline& curve : curves_.curves()) add_passes(curve.points, curve.closed, made);
    return made;
  }

 private:
  std::vector<FlatPoint> pushed(const std::vector<FlatPoint>& curve, bool closed) const;
  bool keeps_to(std::span<const Vec3> exact, const Vec3& from, const Vec3& to) const;
  std::vector<std::size_t> reduced(const std::vector<Vec3>& exact,
                                   const std::vector<Vec3>& tips) const;
  void add_passes(const std::vector<FlatPoint>& curve, bool closed,
                  std::vector<Waterline>& made) const;

  const CutterLocations& locations_;
  const HeightCurves& curves_;
  double tolerance_;
};

std::vector<FlatPoint> PassMaker::pushed(const std::vector<FlatPoint>& curve, bool closed) const {
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
    while (by > least && curves_.held_at(moved(curve[i], left, by))) by /= 2;
    out.push_back(by > least ? moved(curve[i], left, by) : curve[i]);
  }
  return out;
}

/// Whether the chord keeps to the tolerance of the curve's points that it replaces, and does not
/// pass on the forbidden side of what the curve is away from them at most.
bool PassMaker::keeps_to(std::span<const Vec3> exact, const Vec3& from, const Vec3& to) const {
  const FlatPoint left = left_of({from.x, from.y}, {to.x, to.y});
  return std::all_of(exact.begin(), exact.end(), [&](const Vec3& p) {
    const double outside = left.x * (p.x - from.x) + left.y * (p.y - from.y);
    return outside <= kCrossingShare * tolerance_ &&
           distance_to_segment(p, from, to) <= kCurveReductionShare * tolerance_;
  });
}

/// Chords that keep to the curve are as a rule clear: only of others are shorter ones asked for.
std::vector<std::size_t> PassMaker::reduced(const std::vector<Vec3>& exact,
                                            const std::vector<Vec3>& tips) const {
  const auto keeps = [&](std::size_t i, std::size_t j) {
    return keeps_to(std::span(exact).subspan(i + 1, j - i - 1), tips[i], tips[j]);
  };
  const auto clears = [&](std::size_t i, std::size_t j) {
    return locations_.clears(tips[i], tips[j], 0);
  };
  std::vector<std::size_t> kept = {0};
  for (const std::size_t next : model::reduce_chords(tips.size(), keeps)) {
    const std::size_t from = kept.back();
    if (next <= from + 1 || clears(from, next)) {
      if (next > from) kept.push_back(next);
      continue;
    }
    const auto shorter = [&](std::size_t i, std::size_t j) {
      return keeps(from + i, from + j) && clears(from + i, from + j);
    };
    for (const std::size_t k : model::reduce_chords(next - from + 1, shorter))
      if (k > 0) kept.push_back(from + k);
  }
  return kept;
}

void PassMaker::add_passes(const std::vector<FlatPoint>& curve, bool closed,
                           std::vector<Waterline>& made) const {
  std::vector<Vec3> exact, tips;
  for (const FlatPoint& p : curve) exact.push_back({p.x, p.y, curves_.height_mm()});
  for (const FlatPoint& p : pushed(curve, closed)) tips.push_back({p.x, p.y, curves_.height_mm()});
  const std::vector<std::size_t> kept = reduced(exact, tips);
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

/// A curve lies in a cell that its line over the raster goes through, but where it bulges.
constexpr int kCellsOff = 2;

}  // namespace

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const TipRaster& tips, const CurveNeed& need,
                                               const std::vector<double>& heights_mm,
                                               double tolerance_mm,
                                               const model::RunControl& control) {
  CurveNeed wide = need;
  wide.cells = widened(need.cells, kCellsOff);
  const UnsureNodes unsure(tips, wide.cells);
  std::vector<std::vector<Waterline>> made(heights_mm.size());
  model::parallel_chunks(made.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const HeightCurves curves(locations, tips, wide, unsure, heights_mm[i] + kAbovePlateaus_mm,
                                tolerance_mm);
      made[i] = PassMaker(locations, curves, tolerance_mm).passes();
    }
    control.report(static_cast<double>(end) / static_cast<double>(made.size()));
  });
  return made;
}

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const std::vector<double>& heights_mm,
                                               const WaterlineRequest& request,
                                               const model::RunControl& control) {
  const TipRaster tips = make_tip_raster(locations, request.window, request.spacing_mm, control);
  CurveNeed everywhere{CellMask(tips.raster), 0, CellMask(tips.raster), 0};
  everywhere.cells.set.assign(everywhere.cells.set.size(), 1);
  return waterlines(locations, tips, everywhere, heights_mm, request.tolerance_mm, control);
}

}  // namespace limitgauge::engine::strategy
