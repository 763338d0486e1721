#include "engine/strategy/levels/waterline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/strategy/raster/isoline.h"
#include "engine/tolerance.h"
#include "model/base/chunks.h"
#include "model/geometry/polyline.h"
#include "model/geometry/segment.h"

namespace limitgauge::engine::strategy {
namespace {

/// Shares of the tolerance: how far chords between points of the curve may leave it, by how much
/// passes are pushed out so that chords may cut corners, and what reduction may use of the rest.
constexpr double kCurveShare = 0.15, kPushShare = 0.3, kCurveReductionShare = 0.8;
constexpr double kCrossingShare = 0.02;
/// Between exact points of a curve: points of the raster's line, how far that may step aside, in
/// cells, and how much of its length may be the chord's at least; and how many cells a chord may
/// cross without a look at its middle.
constexpr std::size_t kPointsAChord = 8;
constexpr double kStepsAside = 0.75, kStraight = 0.65, kUnseenCells = 3;
/// Of what is left to a place aimed at, so much is gone beyond it, to close brackets from both
/// ends.
constexpr double kBeyond = 0.1;
/// Steepest slope (tangent) for which sides of nodes are told by heights that may be wrong: beyond
/// that the curve is looked for past the node.
constexpr double kSteepestNode = 20;

bool same(const FlatPoint& a, const FlatPoint& b) {
  return a.x == b.x && a.y == b.y;
}

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
/// on the free side, within a fiftieth of the tolerance of the curve; the forbidden side is on the
/// right.
class HeightCurves {
 public:
  /// `need` is wide enough for what the raster does not see.
  HeightCurves(const CutterLocations& locations, const TipRaster& tips, const CurveNeed& need,
               double height_mm, double tolerance_mm)
      : locations_(locations),
        tips_(tips),
        need_(need),
        height_(height_mm),
        tolerance_(tolerance_mm),
        field_(sides()) {}

  /// Passes of the tip beside the curves: proven clear, within the tolerance of them, no denser
  /// than that asks for. A curve whose chords cannot be proven clear is left open there.
  std::vector<Waterline> passes() const;

 private:
  /// Tip height at a place less that of the curve; minus infinity where nothing is under the
  /// cutter.
  double above(const FlatPoint& p) const;
  bool held_at(const FlatPoint& p) const {
    return !locations_.clears({p.x, p.y, height_}, {p.x, p.y, height_}, 0);
  }
  /// 1 at nodes that are forbidden, -1 at free ones.
  std::vector<float> sides() const;
  /// By how much a node's height may be wrong.
  double node_error(int column, int row) const;
  struct Place {
    FlatPoint at;
    double above_mm = 0;  ///< of the curve
  };
  /// A free and a forbidden place; the curve lies between.
  struct Bracket {
    Place free, held;
    double width() const { return distance(free.at, held.at); }
  };
  Place place(const FlatPoint& at) const { return {at, above(at)}; }
  Bracket narrowed(Bracket b) const;
  FlatPoint crossing_past(const FlatPoint& from, const FlatPoint& other, bool held) const;
  FlatPoint exact(const FlatPoint& edge_middle) const;
  std::vector<std::size_t> spread_out(const Isoline& line) const;
  std::vector<FlatPoint> exact_points(const Isoline& line) const;
  std::vector<FlatPoint> densified(const std::vector<FlatPoint>& points) const;
  void densify(const FlatPoint& a, const FlatPoint& b, std::vector<FlatPoint>& dense) const;
  void densify_halves(const FlatPoint& a, const FlatPoint& b, std::vector<FlatPoint>& dense) const;
  bool find_beside(const FlatPoint& a, const FlatPoint& b, FlatPoint& found) const;
  std::vector<FlatPoint> pushed(const std::vector<FlatPoint>& curve, bool closed) const;
  void add_passes(const std::vector<FlatPoint>& curve, bool closed,
                  std::vector<Waterline>& made) const;

  void add_curve(const Isoline& line, std::vector<Waterline>& made) const;

  const CutterLocations& locations_;
  const TipRaster& tips_;
  const CurveNeed& need_;
  double height_, tolerance_;
  std::vector<float> field_;
};

/// What is farther below the curve than the tolerance is only known to be.
double HeightCurves::above(const FlatPoint& p) const {
  const auto z = locations_.tip_z_above(p.x, p.y, height_ - tolerance_);
  return z ? *z - height_ : -std::numeric_limits<double>::infinity();
}

double HeightCurves::node_error(int column, int row) const {
  const Raster& r = tips_.raster;
  double farthest = 0;
  for (const auto& [i, j] :
       {std::pair{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}})
    if (i >= 0 && j >= 0 && i < r.columns && j < r.rows)
      farthest = std::max(farthest, std::abs(tips_.at(i, j) - tips_.at(column, row)));
  return tips_.error_mm * (1 + std::min(2 * farthest / r.pixel_mm, kSteepestNode));
}

std::vector<float> HeightCurves::sides() const {
  std::vector<float> field(tips_.z.size());
  std::transform(tips_.z.begin(), tips_.z.end(), field.begin(),
                 [&](double z) { return z > height_ ? 1.0F : -1.0F; });
  if (tips_.error_mm <= 0) return field;
  const Raster& r = tips_.raster;
  const double largest_error = tips_.error_mm * (1 + kSteepestNode);
  for (int j = 0; j < r.rows; ++j)
    for (int i = 0; i < r.columns; ++i) {
      const double away = std::abs(tips_.at(i, j) - height_);
      if (away > largest_error || away > node_error(i, j)) continue;
      const FlatPoint p{r.x(i), r.y(j)};
      if (need_.cells.at(p.x, p.y))
        field[static_cast<std::size_t>(j) * r.columns + i] = held_at(p) ? 1.0F : -1.0F;
    }
  return field;
}

/// Where heights are finite, looks where a straight line through them passes the curve, a little
/// toward the middle so that brackets close from both sides; halves what that leaves too wide.
HeightCurves::Bracket HeightCurves::narrowed(Bracket b) const {
  const double close = kCrossingShare * tolerance_;
  const auto look = [&](double t) {
    const FlatPoint p = lerp(b.free.at, b.held.at, t);
    const double z = above(p);
    (z > 0 ? b.held : b.free) = {p, z};
  };
  bool first = true;  // two looks along the line before a bracket is halved
  for (double width = b.width(); width > close; width = b.width()) {
    if (std::isfinite(b.free.above_mm)) {
      const double at = b.free.above_mm / (b.free.above_mm - b.held.above_mm);
      const double aside = kBeyond * std::min(at, 1 - at) + close / (2 * width);
      look(at < 0.5 ? std::min(0.5, at + aside) : std::max(0.5, at - aside));
    }
    if (b.width() > width / 2 && !std::exchange(first, false)) look(0.5);
  }
  return b;
}

/// The curve past `from`, which is `held` or not, away from `other`; no farther than a pixel.
FlatPoint HeightCurves::crossing_past(const FlatPoint& from, const FlatPoint& other,
                                      bool held) const {
  const double pixel = tips_.raster.pixel_mm, length = distance(other, from);
  const FlatPoint way = {(from.x - other.x) / length, (from.y - other.y) / length};
  Place before{from, held ? tolerance_ : -tolerance_};
  for (double away = kCrossingShare * tolerance_; away <= pixel; away *= 2) {
    const FlatPoint at = moved(from, way, away);
    const Place next{at, above(at)};
    if ((next.above_mm > 0) != held)
      return narrowed(held ? Bracket{next, before} : Bracket{before, next}).free.at;
    before = next;
  }
  return from;
}

/// Marching over a field of two values meets every edge in its middle: half-odd in one coordinate.
FlatPoint HeightCurves::exact(const FlatPoint& edge_middle) const {
  const Raster& r = tips_.raster;
  const auto twice = [&](double at, double low) {
    return static_cast<int>(std::lround(2 * (at - low) / r.pixel_mm));
  };
  const int i2 = twice(edge_middle.x, r.x0), j2 = twice(edge_middle.y, r.y0);
  const auto node = [&](int i, int j) {
    // Of a node whose height is not that of its side, no more is known.
    const double away = std::max(std::abs(tips_.at(i, j) - height_), kSamePlace_mm);
    return Place{{r.x(i), r.y(j)}, field_[static_cast<std::size_t>(j) * r.columns + i] * away};
  };
  const Place a = node(i2 / 2, j2 / 2), b = node(i2 / 2 + i2 % 2, j2 / 2 + j2 % 2);
  const Bracket nodes = a.above_mm > 0 ? Bracket{b, a} : Bracket{a, b};
  const Bracket found = narrowed(nodes);
  if (tips_.error_mm <= 0) return found.free.at;
  // What was not looked at may be on the other side.
  if (same(found.free.at, nodes.free.at) && held_at(nodes.free.at))
    return crossing_past(nodes.free.at, nodes.held.at, true);
  if (same(found.held.at, nodes.held.at) && !held_at(nodes.held.at))
    return crossing_past(nodes.held.at, nodes.free.at, false);
  return found.free.at;
}

/// Points of the raster's line that are to be found exactly: those between may be left out where
/// the line goes straight on, but for its steps from cell to cell.
std::vector<std::size_t> HeightCurves::spread_out(const Isoline& line) const {
  const double pixel = tips_.raster.pixel_mm;
  const auto straight = [&](std::size_t from, std::size_t to) {
    const FlatPoint &a = line.points[from], &b = line.points[to];
    double along = 0;
    for (std::size_t k = from; k < to; ++k) {
      along += distance(line.points[k], line.points[k + 1]);
      if (model::distance_to_segment(line.points[k], a, b) > kStepsAside * pixel) return false;
    }
    return distance(a, b) >= kStraight * along;
  };
  std::vector<std::size_t> kept = {0};
  for (std::size_t last = line.points.size() - 1; kept.back() < last;) {
    std::size_t next = std::min(kept.back() + kPointsAChord, last);
    while (next > kept.back() + 1 && !straight(kept.back(), next)) --next;
    kept.push_back(next);
  }
  return kept;
}

std::vector<FlatPoint> HeightCurves::exact_points(const Isoline& line) const {
  std::vector<FlatPoint> points;
  for (const std::size_t k : spread_out(line)) points.push_back(exact(line.points[k]));
  std::reverse(points.begin(), points.end());
  return points;
}

/// Looks for the curve on the line across the middle of a chord, beyond what chords may leave it by
/// and no farther than leaves both halves shorter than the chord.
bool HeightCurves::find_beside(const FlatPoint& a, const FlatPoint& b, FlatPoint& found) const {
  const FlatPoint middle = lerp(a, b, 0.5), left = left_of(a, b);
  const bool held = held_at(middle);
  const double side = held ? 1 : -1, close = kCurveShare * tolerance_;
  constexpr double kFarthest = 0.8;
  const double farthest = kFarthest * distance(a, b);
  FlatPoint before = moved(middle, left, side * close);
  if (held_at(before) != held) return false;
  for (double away = 2 * close; away <= farthest; away *= 2) {
    const FlatPoint next = moved(middle, left, side * away);
    if (held_at(next) != held) {
      const Bracket sides =
          held ? Bracket{place(next), place(before)} : Bracket{place(before), place(next)};
      found = narrowed(sides).free.at;
      return true;
    }
    before = next;
  }
  return false;
}

/// The middle of a chord that is close to the curve there is a point of it only where one is needed
/// on either side.
void HeightCurves::densify_halves(const FlatPoint& a, const FlatPoint& b,
                                  std::vector<FlatPoint>& dense) const {
  const FlatPoint middle = lerp(a, b, 0.5);
  const std::size_t before = dense.size();
  densify(a, middle, dense);
  const std::size_t to_middle = dense.size();
  densify(middle, b, dense);
  if (to_middle == before + 1 && dense.size() == to_middle + 1)
    dense.erase(dense.begin() + static_cast<std::ptrdiff_t>(before));
}

void HeightCurves::densify(const FlatPoint& a, const FlatPoint& b,
                           std::vector<FlatPoint>& dense) const {
  FlatPoint beside;
  if (distance(a, b) > 2 * kCurveShare * tolerance_ && find_beside(a, b, beside)) {
    densify(a, beside, dense);
    densify(beside, b, dense);
    return;
  }
  if (distance(a, b) > kUnseenCells * tips_.raster.pixel_mm) return densify_halves(a, b, dense);
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

void HeightCurves::add_curve(const Isoline& line, std::vector<Waterline>& made) const {
  std::vector<FlatPoint> points = exact_points(line);
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() > 2) add_passes(densified(points), line.closed, made);
}

std::vector<Waterline> HeightCurves::passes() const {
  const Raster& raster = tips_.raster;
  std::vector<Waterline> made;
  for (const Isoline& line : isolines(raster, field_, whole(raster), 0))
    for (const Isoline& part : needed_stretches(line, need_.cells, need_.bridged_mm))
      add_curve(part, made);
  return made;
}

/// A curve lies in a cell that its line over the raster goes through, but where it bulges.
constexpr int kCellsOff = 2;

}  // namespace

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const TipRaster& tips, const CurveNeed& need,
                                               const std::vector<double>& heights_mm,
                                               double tolerance_mm,
                                               const model::RunControl& control) {
  const CurveNeed wide{widened(need.cells, kCellsOff), need.bridged_mm};
  std::vector<std::vector<Waterline>> made(heights_mm.size());
  model::parallel_chunks(made.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      made[i] = HeightCurves(locations, tips, wide, heights_mm[i] + kAbovePlateaus_mm, tolerance_mm)
                    .passes();
    control.report(static_cast<double>(end) / static_cast<double>(made.size()));
  });
  return made;
}

std::vector<std::vector<Waterline>> waterlines(const CutterLocations& locations,
                                               const std::vector<double>& heights_mm,
                                               const WaterlineRequest& request,
                                               const model::RunControl& control) {
  const TipRaster tips = make_tip_raster(locations, request.window, request.spacing_mm, control);
  CurveNeed everywhere{CellMask(tips.raster), 0};
  everywhere.cells.set.assign(everywhere.cells.set.size(), 1);
  return waterlines(locations, tips, everywhere, heights_mm, request.tolerance_mm, control);
}

}  // namespace limitgauge::engine::strategy
