#include "engine/strategy/levels/height_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/tolerance.h"
#include "model/geometry/segment.h"

namespace limitgauge::engine::strategy {
namespace {

/// Between exact points of a curve: points of the raster's line, how far that may step aside, in
/// cells, and how much of its length may be the chord's at least; and how many cells a chord may
/// cross without a look at its middle.
constexpr std::size_t kPointsAChord = 8;
constexpr double kStepsAside = 0.75, kStraight = 0.65, kUnseenCells = 4;
/// Chords looked at between two exact points: ten times what smooth curves were measured to take.
constexpr int kMostChords = 256;
/// Of what is left to a place aimed at, so much is gone beyond it, to close brackets from both
/// ends.
constexpr double kBeyond = 0.1;

bool same(const FlatPoint& a, const FlatPoint& b) {
  return a.x == b.x && a.y == b.y;
}

}  // namespace

/// What is farther below the curve than the tolerance is only known to be.
double HeightCurves::above(const FlatPoint& p) const {
  ++looks_;
  const auto z = locations_.tip_z_above(p.x, p.y, height_ - tolerance_);
  return z ? *z - height_ : -std::numeric_limits<double>::infinity();
}

std::vector<float> HeightCurves::sides() const {
  std::vector<float> field(tips_.z.size());
  std::transform(tips_.z.begin(), tips_.z.end(), field.begin(),
                 [h = height_](double z) { return z > h ? 1.0F : -1.0F; });
  const Raster& r = tips_.raster;
  for (const UnsureNodes::Node& node : unsure_.near(height_)) {
    if (std::abs(node.z - height_) > node.error_mm) continue;
    const int i = static_cast<int>(node.at % r.columns), j = static_cast<int>(node.at / r.columns);
    field[node.at] = held_at({r.x(i), r.y(j)}) ? 1.0F : -1.0F;
  }
  return field;
}

/// Heights within their error of the curve's may seem to be on its other side: a bracket whose ends
/// are on one side would never close.
HeightCurves::Place HeightCurves::place(const FlatPoint& at, bool held) const {
  const double z = above(at);
  return {at, held ? std::max(z, kHeightError_mm) : std::min(z, -kHeightError_mm)};
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
      const Bracket sides = held ? Bracket{place(next, false), place(before, true)}
                                 : Bracket{place(before, false), place(next, true)};
      found = narrowed(sides).free.at;
      return true;
    }
    before = next;
  }
  return false;
}

/// The middle of a chord that is close to the curve there is a point of it only where one is needed
/// on either side.
void HeightCurves::densify_halves(const FlatPoint& a, const FlatPoint& b, int& chords_left,
                                  std::vector<FlatPoint>& dense) const {
  const FlatPoint middle = lerp(a, b, 0.5);
  const std::size_t before = dense.size();
  densify(a, middle, chords_left, dense);
  const std::size_t to_middle = dense.size();
  densify(middle, b, chords_left, dense);
  if (to_middle == before + 1 && dense.size() == to_middle + 1)
    dense.erase(dense.begin() + static_cast<std::ptrdiff_t>(before));
}

void HeightCurves::densify(const FlatPoint& a, const FlatPoint& b, int& chords_left,
                           std::vector<FlatPoint>& dense) const {
  if (--chords_left < 0) return dense.push_back(b);
  FlatPoint beside;
  if (distance(a, b) > 2 * kCurveShare * tolerance_ && find_beside(a, b, beside)) {
    densify(a, beside, chords_left, dense);
    densify(beside, b, chords_left, dense);
    return;
  }
  if (distance(a, b) > kUnseenCells * tips_.raster.pixel_mm)
    return densify_halves(a, b, chords_left, dense);
  dense.push_back(b);
}

std::vector<FlatPoint> HeightCurves::densified(const std::vector<FlatPoint>& points) const {
  std::vector<FlatPoint> dense = {points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    int chords_left = kMostChords;
    densify(points[i - 1], points[i], chords_left, dense);
  }
  return dense;
}

std::vector<Isoline> HeightCurves::curves() const {
  const Raster& raster = tips_.raster;
  std::vector<Isoline> made;
  for (const Isoline& line : isolines(raster, field_, whole(raster), 0))
    for (const Isoline& part : needed_stretches(line, need_)) {
      std::vector<FlatPoint> points = exact_points(part);
      points.erase(std::unique(points.begin(), points.end(), same), points.end());
      if (points.size() > 2) made.push_back({densified(points), part.closed});
    }
  return made;
}

}  // namespace limitgauge::engine::strategy
