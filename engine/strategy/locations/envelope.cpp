#include "engine/strategy/locations/envelope.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace limitgauge::engine::strategy {
namespace {

/// Height of the way from `a` to `b` at `s`; exactly theirs at its ends.
double height_between(const PlanePoint& a, const PlanePoint& b, double s) {
  if (s <= a.s) return a.z;
  if (s >= b.s) return b.z;
  return a.z + (b.z - a.z) * ((s - a.s) / (b.s - a.s));
}

/// A stretch of a curve on which s ascends.
struct Piece {
  std::size_t at = 0, last = 0;  ///< points; `at` begins the segment under the sweep
};

/// Sweeps curves from left to right; between two neighbouring points every active piece is a whole
/// straight line.
class Sweep {
 public:
  Sweep(std::span<const std::vector<PlanePoint>> curves, double slit_mm) : slit_mm_(slit_mm) {
    for (const auto& curve : curves) add_pieces(curve);
    std::sort(pieces_.begin(), pieces_.end(),
              [this](const Piece& a, const Piece& b) { return points_[a.at].s < points_[b.at].s; });
  }

  Envelope run() {
    std::size_t next = 0;
    double a = 0;
    while (next < pieces_.size() || !active_.empty()) {
      if (active_.empty()) a = points_[pieces_[next].at].s;
      while (next < pieces_.size() && points_[pieces_[next].at].s <= a)
        active_.push_back(pieces_[next++]);
      const double b = next_stop(next);
      // Between curves that meet, rounding leaves slits through which lower curves would show.
      if (b - a > slit_mm_) span(a, b);
      a = b;
      advance(a);
    }
    return std::move(envelope_);
  }

 private:
  void add_pieces(const std::vector<PlanePoint>& curve) {
    for (std::size_t i = 1; i < curve.size();) {
      const bool forwards = curve[i].s > curve[i - 1].s;
      std::size_t j = i;
      while (j < curve.size() &&
             (forwards ? curve[j].s > curve[j - 1].s : curve[j].s < curve[j - 1].s))
        ++j;
      if (j == i) {
        ++i;  // upright: shows in no envelope of functions
        continue;
      }
      const std::size_t first = points_.size();
      const auto from = curve.begin() + static_cast<std::ptrdiff_t>(i - 1);
      const auto to = curve.begin() + static_cast<std::ptrdiff_t>(j);
      points_.insert(points_.end(), from, to);
      if (!forwards)
        std::reverse(points_.begin() + static_cast<std::ptrdiff_t>(first), points_.end());
      pieces_.push_back({first, points_.size() - 1});
      i = j;
    }
  }

  double next_stop(std::size_t next) const {
    double stop = next < pieces_.size() ? points_[pieces_[next].at].s
                                        : std::numeric_limits<double>::infinity();
    for (const Piece& piece : active_) stop = std::min(stop, points_[piece.at + 1].s);
    return stop;
  }
  void advance(double a) {
    std::size_t kept = 0;
    for (Piece piece : active_) {
      while (piece.at < piece.last && points_[piece.at + 1].s <= a) ++piece.at;
      if (piece.at < piece.last) active_[kept++] = piece;
    }
    active_.resize(kept);
  }

  double height_at(const Piece& piece, double s) const {
    return height_between(points_[piece.at], points_[piece.at + 1], s);
  }
  void add(PlanePoint p) {
    if (p != envelope_.runs.back().back()) envelope_.runs.back().push_back(p);
  }
  /// Goes on with the run that ends at `p`, or begins one after a gap.
  void begin_at(PlanePoint p) {
    auto& runs = envelope_.runs;
    if (runs.empty() || p.s - runs.back().back().s > slit_mm_)
      runs.push_back({p});
    else
      add(p);
  }

  /// Heights of the active pieces at both ends of a span, and which is on top there.
  struct Tops {
    std::size_t at_a = 0, at_b = 0;
  };
  Tops measure(double a, double b) {
    ends_.clear();
    Tops top;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      ends_.push_back({height_at(active_[k], a), height_at(active_[k], b)});
      const Ends &here = ends_[k], &best = ends_[top.at_a];
      if (here.a > best.a || (here.a == best.a && here.b > best.b)) top.at_a = k;
      if (here.b > ends_[top.at_b].b) top.at_b = k;
    }
    return top;
  }

  void span(double a, double b) {
    const Tops top = measure(a, b);
    begin_at({a, ends_[top.at_a].a});
    if (ends_[top.at_a].b < ends_[top.at_b].b) cross(a, b, top.at_a);
    add({b, ends_[top.at_b].b});
  }

  /// Adds the points where one piece takes the top from another.
  void cross(double a, double b, std::size_t top) {
    double s = a;
    for (;;) {
      double crossing = b;
      std::size_t taker = top;
      const double top_s = height_at(active_[top], s), top_b = ends_[top].b;
      for (std::size_t k = 0; k < active_.size(); ++k) {
        const double above = ends_[k].b - top_b;
        if (k == top || above <= 0) continue;
        const double below = top_s - height_at(active_[k], s);
        const double at = s + (b - s) * (below / (below + above));
        if (below < 0 || at >= crossing || at < s) continue;
        crossing = at;
        taker = k;
      }
      if (taker == top || !(crossing > s)) return;
      add({crossing, height_at(active_[top], crossing)});
      s = crossing;
      top = taker;
    }
  }

  struct Ends {
    double a = 0, b = 0;
  };
  std::vector<PlanePoint> points_;
  std::vector<Piece> pieces_, active_;
  std::vector<Ends> ends_;
  Envelope envelope_;
  double slit_mm_;
};

}  // namespace

Envelope upper_envelope(std::span<const std::vector<PlanePoint>> curves, double slit_mm) {
  return Sweep(curves, slit_mm).run();
}

}  // namespace limitgauge::engine::strategy
