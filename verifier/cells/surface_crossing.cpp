#include "verifier/cells/surface_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/geometry/box_tree.h"
#include "verifier/cells/normal_cone.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Interval;
using model::Vec3;

/// A ray as an axis of coordinates: how far along it and how far aside a point lies.
class Ray {
 public:
  Ray(const Vec3& from, const Vec3& along)
      : from_(from), along_(along), aside_(across(along)), across_(cross(along, aside_)) {}

  /// Where it may meet the hull of the cell's control points.
  Interval within(const Bezier& cell) const {
    Interval t = Interval::none(), x = t, y = t;
    for (int k = 0; k < 16; ++k) {
      const Vec3 p = seen(cell.control(k));
      t.add(p.z), x.add(p.x), y.add(p.y);
    }
    if (!near_zero(x) || !near_zero(y) || passes_beside(cell)) return Interval::none();
    return t.widened(kDistanceRounding_mm);
  }
  /// A point as the ray sees it: how far to either side, and how far along.
  Vec3 seen(const Vec3& p) const {
    const Vec3 w = p - from_;
    return {dot(w, aside_), dot(w, across_), dot(w, along_)};
  }
  Interval within(const model::Box3& box) const {
    const Vec3 c = box.centre() - from_, h = box.size() / 2;
    const auto half = [&](const Vec3& v) {
      return std::abs(v.x) * h.x + std::abs(v.y) * h.y + std::abs(v.z) * h.z + kDistanceRounding_mm;
    };
    if (std::abs(dot(c, aside_)) > half(aside_) || std::abs(dot(c, across_)) > half(across_))
      return Interval::none();
    const double at = dot(c, along_), reach = half(along_);
    return {at - reach, at + reach};
  }

 private:
  /// Whether the hull lies to one side of the ray as the cell's own normal sees it: a ray along a
  /// face, however near, would be near to all of its cells otherwise.
  bool passes_beside(const Bezier& cell) const {
    const Vec3 normal = unit_normal(cell, 0.5, 0.5), over = normal - along_ * dot(normal, along_);
    if (!(dot(over, over) > kRises * kRises)) return false;
    const Vec3 to = normalized(over);
    Interval s = Interval::none();
    for (int k = 0; k < 16; ++k) s.add(dot(cell.control(k) - from_, to));
    return !near_zero(s);
  }
  static bool near_zero(const Interval& s) {
    return s.low <= kDistanceRounding_mm && s.high >= -kDistanceRounding_mm;
  }
  Vec3 from_, along_, aside_, across_;
};

class CrossingSearch {
 public:
  CrossingSearch(const SurfaceCells& cells, const Vec3& from, const Vec3& normal, Way way,
                 Interval wanted)
      : cells_(cells),
        ray_(from, way == Way::outwards ? normal : -normal),
        normal_(normal),
        first_(wanted.high),
        from_(wanted.low) {}

  double run() {
    model::nearest_first(
        cells_.nodes(), [&](const model::BoxNode& node) { return start_of(ray_.within(node.box)); },
        [&](double bound) { return bound >= first_; },
        [&](const model::BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
            descend(cells_.cells()[k].shape, ray_.within(cells_.cells()[k].shape));
        });
    return first_;
  }

 private:
  /// The first place of interest in a stretch; infinite where there is none.
  double start_of(Interval s) const {
    s.low = std::max(s.low, from_);
    return s.empty() ? kNone : s.low;
  }
  static bool is_near(const Interval& s) { return s.low >= -kItself_mm && s.high <= kItself_mm; }
  /// Whether no part of the cell faces the other way than s.
  bool faces_alike(const Bezier& cell) const {
    const auto alike = [&](double u, double v) {
      return dot(unit_normal(cell, u, v), normal_) >= -kFacing;
    };
    return alike(0.5, 0.5) && alike(0, 0) && alike(1, 0) && alike(1, 1) && alike(0, 1);
  }
  /// Whether it is the back of another sheet in the same place: of a fin or a slit of no width.
  bool is_back(const Bezier& cell) const {
    return dot(unit_normal(cell, 0.5, 0.5), normal_) < kBackToBack;
  }
  /// `met` is where the ray may meet the cell.
  void descend(const Bezier& cell, const Interval& met) {
    const double start = start_of(met), radius = control_radius(cell, middle(cell));
    if (start >= first_) return;
    const bool near = is_near(met);
    if (near && faces_alike(cell)) return;
    if (radius < (near ? kSamePlace_mm : kSmallestCell_mm)) {
      if (!near || std::abs(start) > 2 * kSamePlace_mm || is_back(cell)) first_ = start;
      return;
    }
    const auto parts = halved(cell);
    const Interval within[] = {ray_.within(parts[0]), ray_.within(parts[1])};
    const int first = start_of(within[1]) < start_of(within[0]) ? 1 : 0;
    for (const int k : {first, 1 - first}) descend(parts[k], within[k]);
  }

  static constexpr double kNone = std::numeric_limits<double>::infinity();
  const SurfaceCells& cells_;
  Ray ray_;
  Vec3 normal_;
  double first_, from_;
};

/// The crossings of a segment with S, by the degree of S's projection along it: how often the
/// projected boundaries of the cells that reach it wind round it.
class CrossingCount {
 public:
  /// Crossings are told to `finest_mm` along the segment.
  CrossingCount(const SurfaceCells& cells, const Vec3& from, const Vec3& along, double length_mm,
                double finest_mm)
      : cells_(cells), ray_(from, along), length_(length_mm), finest_(finest_mm) {}

  /// In their order; none where the segment begins or ends too near to S, or meets the boundary of
  /// a cell.
  std::optional<std::vector<Crossing>> run() {
    model::nearest_first(
        cells_.nodes(),
        [&](const model::BoxNode& node) {
          const Interval s = ray_.within(node.box);
          return s.empty() || s.low > length_ || s.high < 0 ? kNone : 0;
        },
        [&](double bound) { return failed_ || bound == kNone; },
        [&](const model::BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count && !failed_; ++k)
            add(cells_.cells()[k].shape);
        });
    if (failed_) return std::nullopt;
    std::sort(out_.begin(), out_.end(),
              [](const Crossing& a, const Crossing& b) { return a.where.low < b.where.low; });
    return std::move(out_);
  }

 private:
  void add(const Bezier& cell) {
    const Interval s = ray_.within(cell);
    if (failed_ || s.empty() || s.low > length_ || s.high < 0) return;
    if (s.low > 0 && s.high < length_)
      if (const auto winds = winding(cell)) {
        if (*winds == 0) return;
        if (s.high - s.low <= finest_) return out_.push_back({s, *winds});
      }
    if (++halvings_ > kMostHalvings) {
      failed_ = true;
      return;
    }
    for (const Bezier& half : halved(cell)) add(half);
  }
  /// Of the projected boundary round the ray, where each side keeps to a half-plane without it.
  std::optional<int> winding(const Bezier& cell) const {
    double angle = 0;
    for (const auto& side : kSidesRound) {
      Vec3 p[4];
      for (int k = 0; k < 4; ++k) p[k] = ray_.seen(cell.control(side[k])), p[k].z = 0;
      const Vec3 towards = normalized(normalized(p[0]) + normalized(p[3]));
      for (const Vec3& q : p)
        if (!(dot(q, towards) > kSamePlace_mm)) return std::nullopt;
      angle += std::atan2(p[0].x * p[3].y - p[0].y * p[3].x, dot(p[0], p[3]));
    }
    return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
  }

  static constexpr double kNone = std::numeric_limits<double>::infinity();
  static constexpr int kMostHalvings = 200;
  const SurfaceCells& cells_;
  Ray ray_;
  double length_, finest_;
  std::vector<Crossing> out_;
  int halvings_ = 0;
  bool failed_ = false;
};

}  // namespace

double next_crossing_mm(const SurfaceCells& cells, const Vec3& s, const Vec3& n, Way way,
                        double from_mm, double to_mm) {
  return CrossingSearch(cells, s, n, way, {from_mm, to_mm}).run();
}

std::optional<std::vector<Crossing>> crossings(const SurfaceCells& cells, const Vec3& from,
                                               const Vec3& along, double length_mm,
                                               double finest_mm) {
  return CrossingCount(cells, from, along, length_mm, finest_mm).run();
}

}  // namespace limitgauge::verifier
