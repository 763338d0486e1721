#include "verifier/surface_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "verifier/nearest_first.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// What is s itself, or a face that meets its own there.
constexpr double kItself_mm = 1e-5;
/// Nearer than this two faces cannot be told apart along the ray.
constexpr double kSamePlace_mm = 2e-9;
/// Cosine of the angle between the normals of two faces that lie back to back.
constexpr double kBackToBack = -1 + 1e-9;
/// What leans across the ray by less than this sine faces neither way.
constexpr double kFacing = 1e-3;

/// A part of a ray: from + t·along for t in [low, high].
struct Stretch {
  double low = 0, high = 0;
  bool empty() const { return !(low <= high); }
};

/// A ray as an axis of coordinates: how far along it and how far aside a point lies.
class Ray {
 public:
  Ray(const Vec3& from, const Vec3& along)
      : from_(from),
        along_(along),
        aside_(normalized(cross(along, std::abs(along.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}))),
        across_(cross(along, aside_)) {}

  /// Where it may meet the hull of the cell's control points.
  Stretch within(const Bezier& cell) const {
    Range t, x, y;
    for (int k = 0; k < 16; ++k) {
      const Vec3 p = seen(cell.control(k));
      t.add(p.z), x.add(p.x), y.add(p.y);
    }
    if (!x.holds_zero() || !y.holds_zero()) return {1, 0};
    return {t.low - kGrown_mm, t.high + kGrown_mm};
  }
  /// A point as the ray sees it: how far to either side, and how far along.
  Vec3 seen(const Vec3& p) const {
    const Vec3 w = p - from_;
    return {dot(w, aside_), dot(w, across_), dot(w, along_)};
  }
  Stretch within(const model::Box3& box) const {
    const Vec3 c = box.centre() - from_, h = box.size() / 2;
    const auto half = [&](const Vec3& v) {
      return std::abs(v.x) * h.x + std::abs(v.y) * h.y + std::abs(v.z) * h.z + kGrown_mm;
    };
    if (std::abs(dot(c, aside_)) > half(aside_) || std::abs(dot(c, across_)) > half(across_))
      return {1, 0};
    const double at = dot(c, along_), reach = half(along_);
    return {at - reach, at + reach};
  }

 private:
  static constexpr double kGrown_mm = 1e-9;
  struct Range {
    double low = 1e300, high = -1e300;
    void add(double v) { low = std::min(low, v), high = std::max(high, v); }
    bool holds_zero() const { return low <= kGrown_mm && high >= -kGrown_mm; }
  };
  Vec3 from_, along_, aside_, across_;
};

Vec3 direct_normal(const Bezier& cell, double u, double v) {
  const BezierJet j = jet(cell, u, v);
  return normalized(cross(j.du, j.dv));
}

class CrossingSearch {
 public:
  CrossingSearch(const SurfaceCells& cells, const Vec3& from, const Vec3& normal, Way way,
                 Stretch wanted)
      : cells_(cells),
        ray_(from, way == Way::outwards ? normal : -normal),
        normal_(normal),
        first_(wanted.high),
        from_(wanted.low) {}

  double run() {
    nearest_first(
        cells_.nodes(), [&](const BoxNode& node) { return start_of(ray_.within(node.box)); },
        [&](double bound) { return bound >= first_; },
        [&](const BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
            descend(cells_.cells()[k].shape);
        });
    return first_;
  }

 private:
  /// The first place of interest in a stretch; infinite where there is none.
  double start_of(Stretch s) const {
    s.low = std::max(s.low, from_);
    return s.empty() ? kNone : s.low;
  }
  static bool is_near(const Stretch& s) { return s.low >= -kItself_mm && s.high <= kItself_mm; }
  /// Whether no part of the cell faces the other way than s.
  bool faces_alike(const Bezier& cell) const {
    const auto alike = [&](double u, double v) {
      return dot(direct_normal(cell, u, v), normal_) >= -kFacing;
    };
    return alike(0.5, 0.5) && alike(0, 0) && alike(1, 0) && alike(1, 1) && alike(0, 1);
  }
  /// Whether it is the back of another sheet in the same place: of a fin or a slit of no width.
  bool is_back(const Bezier& cell) const {
    return dot(direct_normal(cell, 0.5, 0.5), normal_) < kBackToBack;
  }
  void descend(const Bezier& cell) {
    const Stretch met = ray_.within(cell);
    const double start = start_of(met), radius = control_radius(cell, middle(cell));
    if (start >= first_) return;
    const bool near = is_near(met);
    if (near && faces_alike(cell)) return;
    if (radius < (near ? kSamePlace_mm : kSmallestCell_mm)) {
      if (!near || std::abs(start) > 2 * kSamePlace_mm || is_back(cell)) first_ = start;
      return;
    }
    const auto parts = halved(cell);
    const bool later = start_of(ray_.within(parts[1])) < start_of(ray_.within(parts[0]));
    descend(parts[later ? 1 : 0]);
    descend(parts[later ? 0 : 1]);
  }

  static constexpr double kNone = std::numeric_limits<double>::infinity();
  const SurfaceCells& cells_;
  Ray ray_;
  Vec3 normal_;
  double first_, from_;
};

/// The control points along the sides of a cell, one after the other.
constexpr int kSides[4][4] = {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}};

/// A place where a segment goes through S, how far along it, and how often: from behind to before,
/// less the other way.
struct Crossing {
  Stretch where;
  int times = 0;
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
    nearest_first(
        cells_.nodes(),
        [&](const BoxNode& node) {
          const Stretch s = ray_.within(node.box);
          return s.empty() || s.low > length_ || s.high < 0 ? kNone : 0;
        },
        [&](double bound) { return failed_ || bound == kNone; },
        [&](const BoxNode& leaf) {
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
    const Stretch s = ray_.within(cell);
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
    for (const auto& side : kSides) {
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

/// The hull of some points, grown.
class Hull {
 public:
  explicit Hull(double grown_mm, std::span<const Vec3> axes)
      : grown_(grown_mm), axes_(axes.begin(), axes.end()) {}
  void add(const Vec3& p) { points_.push_back(p), box_.add(p); }
  void add(const Bezier& b) {
    for (int k = 0; k < 16; ++k) add(b.control(k));
  }

  bool is_apart(const model::Box3& box) const {
    const model::Box3 own = box_.grown(grown_);
    return own.low.x > box.high.x || own.low.y > box.high.y || own.low.z > box.high.z ||
           own.high.x < box.low.x || own.high.y < box.low.y || own.high.z < box.low.z;
  }
  /// Whether a plane across one of a few axes lies between.
  bool is_apart(const Bezier& cell) const {
    if (is_apart(control_box(cell))) return true;
    const auto between = [&](const Vec3& axis) { return lies_between(axis, cell); };
    return std::any_of(axes_.begin(), axes_.end(), between) ||
           between(direct_normal(cell, 0.5, 0.5)) ||
           between(normalized(middle(cell) - box_.centre()));
  }

 private:
  bool lies_between(const Vec3& axis, const Bezier& cell) const {
    double low = 1e300, high = -1e300, other_low = 1e300, other_high = -1e300;
    for (const Vec3& p : points_)
      low = std::min(low, dot(p, axis)), high = std::max(high, dot(p, axis));
    for (int k = 0; k < 16; ++k) {
      const double at = dot(cell.control(k), axis);
      other_low = std::min(other_low, at), other_high = std::max(other_high, at);
    }
    const double apart = grown_ * length(axis);
    return length(axis) > 0 && (low - apart > other_high || high + apart < other_low);
  }

  double grown_;
  std::vector<Vec3> axes_, points_;
  model::Box3 box_;
};

/// One side of a cell, as a cell that has no width.
Bezier side_of(const Bezier& cell, int side) {
  Bezier out;
  for (int k = 0; k < 16; ++k) out.set(k, cell.control(kSides[side][k % 4]));
  return out;
}

/// An irregular vertex, in place of what is too small to tell.
bool is_point(const SurfaceCell& cell) {
  return control_radius(cell.shape, cell.shape.control(0)) == 0;
}

/// Proof that no part of S meets a hull.
class FreeOfSurface {
 public:
  FreeOfSurface(const SurfaceCells& cells, const Hull& hull) : cells_(cells), hull_(hull) {}

  /// Of all of S.
  bool all() {
    return walk([&](const SurfaceCell& cell) { look(cell.shape); });
  }
  /// Of where it ends, and of the irregular vertices.
  bool ends() {
    return walk([&](const SurfaceCell& cell) {
      if (is_point(cell)) look(cell.shape);
      for (int side = 0; side < 4; ++side)
        if (cells_.is_rim(cell, side)) look(side_of(cell.shape, side));
    });
  }

 private:
  template <class Look>
  bool walk(Look&& look_at) {
    nearest_first(
        cells_.nodes(), [&](const BoxNode& node) { return hull_.is_apart(node.box) ? 1.0 : 0.0; },
        [&](double bound) { return failed_ || bound > 0; },
        [&](const BoxNode& leaf) {
          for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count && !failed_; ++k)
            look_at(cells_.cells()[k]);
        });
    return !failed_;
  }
  void look(const Bezier& cell) {
    if (failed_ || hull_.is_apart(cell)) return;
    failed_ = ++halvings_ > kMostHalvings || control_radius(cell, middle(cell)) < kSmallestCell_mm;
    if (failed_) return;
    for (const Bezier& half : halved(cell)) look(half);
  }

  static constexpr int kMostHalvings = 60;
  const SurfaceCells& cells_;
  const Hull& hull_;
  int halvings_ = 0;
  bool failed_ = false;
};

/// Statement 2 of CERTIFICATE.md, section 3b: of a cell's segments, or of as much of them as comes
/// before a second crossing.
class CrossingProof {
 public:
  CrossingProof(const SurfaceCells& cells, const OffsetCell& cell, Way way, double low_mm,
                double high_mm)
      : cells_(cells),
        cell_(cell),
        sign_(way == Way::outwards ? 1 : -1),
        begin_(way == Way::outwards ? low_mm : high_mm),
        length_(high_mm - low_mm),
        itself_(low_mm < 0 && high_mm > 0) {
    const Vec3 e = normalized(
        cross(cell.normal, std::abs(cell.normal.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    axes_ = {cell.normal, e, cross(cell.normal, e)};
  }

  bool run() const {
    // Beyond it, the normals of the cell need not be near to its middle's.
    constexpr double kLargestRemainder = 0.5;
    if (cell_.fan != Vec3{} || cell_.remainder > kLargestRemainder || cell_.normal == Vec3{})
      return false;
    const auto all = crossings(std::numeric_limits<double>::infinity());
    if (!all || all->size() <= (itself_ ? 1 : 0)) return false;
    if (meets(degree(*all)) && is_kept(length_)) return true;
    return all->size() > (itself_ ? 2 : 1) && runs_before_another();
  }

 private:
  std::optional<std::vector<Crossing>> crossings(double finest_mm) const {
    // A place of the cell that is on no line of symmetry.
    constexpr double kU = 0.4142, kV = 0.5858;
    const Vec3 s = point(cell_.shape, kU, kV), n = direct_normal(cell_.shape, kU, kV);
    if (n == Vec3{}) return std::nullopt;
    return CrossingCount(cells_, s + n * begin_, n * sign_, length_, finest_mm).run();
  }
  /// Along the normals, whichever way the segment goes.
  int degree(std::span<const Crossing> crossings) const {
    double sum = 0;
    for (const Crossing& c : crossings) sum += sign_ * c.times;
    return static_cast<int>(sum);
  }
  /// s itself is met from behind: it takes something met from before to make up for it.
  bool meets(int degree) const { return itself_ ? degree <= 0 : degree != 0; }
  /// Ended between one crossing and the next.
  bool runs_before_another() const {
    constexpr double kFinest = 1.0 / 1024;
    const auto all = crossings(length_ * kFinest);
    if (!all) return false;
    for (std::size_t k = 1; k < all->size(); ++k) {
      const double from = (*all)[k - 1].where.high, to = (*all)[k].where.low;
      if (from < to && meets(degree(std::span(*all).first(k))) && is_kept((from + to) / 2))
        return true;
    }
    return false;
  }
  Hull hull_at(double t) const {
    Hull hull(std::abs(t) * cell_.remainder + kSamePlace_mm, axes_);
    hull.add(cell_.moved(t));
    return hull;
  }
  /// Whether no segment of that length begins or ends on S, or meets the end of S.
  bool is_kept(double length_mm) const {
    const double end = begin_ + sign_ * length_mm;
    const Hull first = hull_at(begin_), last = hull_at(end);
    if (!FreeOfSurface(cells_, first).all() || !FreeOfSurface(cells_, last).all()) return false;
    Hull between(std::max(std::abs(begin_), std::abs(end)) * cell_.remainder + kSamePlace_mm +
                     SurfaceCells::kOmitted_mm,
                 axes_);
    between.add(cell_.moved(begin_)), between.add(cell_.moved(end));
    return FreeOfSurface(cells_, between).ends();
  }

  const SurfaceCells& cells_;
  const OffsetCell& cell_;
  double sign_, begin_, length_;
  bool itself_;
  std::array<Vec3, 3> axes_;
};

}  // namespace

double next_crossing_mm(const SurfaceCells& cells, const Vec3& s, const Vec3& n, Way way,
                        double from_mm, double to_mm) {
  return CrossingSearch(cells, s, n, way, {from_mm, to_mm}).run();
}

bool surely_crosses_surface(const SurfaceCells& cells, const OffsetCell& cell, Way way,
                            double low_mm, double high_mm) {
  return CrossingProof(cells, cell, way, low_mm, high_mm).run();
}

}  // namespace limitgauge::verifier
