#include "verifier/cells/surface_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "model/geometry/box_tree.h"
#include "verifier/cells/normal_cone.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

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
           between(unit_normal(cell, 0.5, 0.5)) ||
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
  for (int k = 0; k < 16; ++k) out.set(k, cell.control(kSidesRound[side][k % 4]));
  return out;
}

/// An irregular vertex, in place of what is too small to tell.
bool is_one_point(const SurfaceCell& cell) {
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
      if (is_one_point(cell)) look(cell.shape);
      for (int side = 0; side < 4; ++side)
        if (cells_.is_rim(cell, side)) look(side_of(cell.shape, side));
    });
  }

 private:
  template <class Look>
  bool walk(Look&& look_at) {
    model::nearest_first(
        cells_.nodes(),
        [&](const model::BoxNode& node) { return hull_.is_apart(node.box) ? 1.0 : 0.0; },
        [&](double bound) { return failed_ || bound > 0; },
        [&](const model::BoxNode& leaf) {
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
    const Vec3 e = across(cell.normal);
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
    const Vec3 s = point(cell_.shape, kU, kV), n = unit_normal(cell_.shape, kU, kV);
    if (n == Vec3{}) return std::nullopt;
    return verifier::crossings(cells_, s + n * begin_, n * sign_, length_, finest_mm);
  }
  /// Along the normals, whichever way the segment goes.
  int degree(std::span<const Crossing> crossings) const {
    int sum = 0;
    for (const Crossing& c : crossings) sum += c.times;
    return sign_ * sum;
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
    Hull between(
        std::max(std::abs(begin_), std::abs(end)) * cell_.remainder + kSamePlace_mm + kOmitted_mm,
        axes_);
    between.add(cell_.moved(begin_)), between.add(cell_.moved(end));
    return FreeOfSurface(cells_, between).ends();
  }

  const SurfaceCells& cells_;
  const OffsetCell& cell_;
  int sign_;
  double begin_, length_;
  bool itself_;
  std::array<Vec3, 3> axes_;
};

}  // namespace

bool surely_crosses_surface(const SurfaceCells& cells, const OffsetCell& cell, Way way,
                            double low_mm, double high_mm) {
  return CrossingProof(cells, cell, way, low_mm, high_mm).run();
}

}  // namespace limitgauge::verifier
