#include "engine/strategy/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::engine::strategy {
namespace {

double height_at(const PlaneSegment& g, double s) {
  const double t = (s - g.from.s) / (g.to.s - g.from.s);
  return g.from.z + (g.to.z - g.from.z) * std::clamp(t, 0.0, 1.0);
}

/// Sweeps the segments from left to right; between two neighbouring end points every active
/// segment is a whole straight line.
class Sweep {
 public:
  Sweep(std::vector<PlaneSegment> segments, double slit_mm)
      : segments_(std::move(segments)), slit_mm_(slit_mm) {}

  Envelope run() {
    prepare();
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      const double a = stops_[i], b = stops_[i + 1];
      std::erase_if(active_, [&](std::size_t k) { return segments_[k].to.s <= a; });
      while (next < segments_.size() && segments_[next].from.s <= a) active_.push_back(next++);
      // Between curves that meet, rounding leaves slits through which lower curves would show.
      if (!active_.empty() && b - a > slit_mm_) span(a, b);
    }
    return std::move(envelope_);
  }

 private:
  void prepare() {
    for (PlaneSegment& g : segments_)
      if (g.to.s < g.from.s) std::swap(g.from, g.to);
    std::erase_if(segments_, [](const PlaneSegment& g) { return !(g.from.s < g.to.s); });
    std::sort(segments_.begin(), segments_.end(),
              [](const auto& a, const auto& b) { return a.from.s < b.from.s; });
    for (const PlaneSegment& g : segments_) stops_.insert(stops_.end(), {g.from.s, g.to.s});
    std::sort(stops_.begin(), stops_.end());
    stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
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

  /// The active segment that is highest at `s`, and just after it among equals.
  std::size_t highest_at(double s, double b) const {
    std::size_t best = active_.front();
    double z = height_at(segments_[best], s), zb = height_at(segments_[best], b);
    for (const std::size_t k : active_) {
      const double zk = height_at(segments_[k], s), zkb = height_at(segments_[k], b);
      if (zk > z || (zk == z && zkb > zb)) {
        best = k;
        z = zk;
        zb = zkb;
      }
    }
    return best;
  }

  void span(double a, double b) {
    double s = a;
    std::size_t top = highest_at(a, b);
    begin_at({a, height_at(segments_[top], a)});
    for (;;) {
      double crossing = b;
      std::size_t taker = top;
      const double top_s = height_at(segments_[top], s), top_b = height_at(segments_[top], b);
      for (const std::size_t k : active_) {
        const double below = top_s - height_at(segments_[k], s);
        const double above = height_at(segments_[k], b) - top_b;
        if (k == top || above <= 0) continue;
        const double at = s + (b - s) * (below / (below + above));
        if (below < 0 || at >= crossing || at < s) continue;
        crossing = at;
        taker = k;
      }
      if (taker == top || !(crossing > s)) break;
      add({crossing, height_at(segments_[top], crossing)});
      s = crossing;
      top = taker;
    }
    add({b, height_at(segments_[highest_at(b, b)], b)});
  }

  std::vector<PlaneSegment> segments_;
  std::vector<double> stops_;
  std::vector<std::size_t> active_;
  Envelope envelope_;
  double slit_mm_;
};

double height_on_run(const std::vector<PlanePoint>& run, std::size_t i, double s) {
  return height_at({run[i], run[i + 1]}, s);
}

}  // namespace

double Envelope::highest(double from, double to) const {
  double z = -std::numeric_limits<double>::infinity();
  for (const auto& run : runs) {
    if (run.back().s < from || run.front().s > to) continue;
    auto at = std::lower_bound(run.begin(), run.end(), from,
                               [](const PlanePoint& p, double s) { return p.s < s; });
    for (; at != run.end() && at->s <= to; ++at) z = std::max(z, at->z);
    for (const double s : {from, to}) {
      const auto after = std::upper_bound(run.begin(), run.end(), s,
                                          [](double x, const PlanePoint& p) { return x < p.s; });
      if (after == run.begin() || after == run.end()) continue;
      z = std::max(z, height_on_run(run, static_cast<std::size_t>(after - run.begin()) - 1, s));
    }
  }
  return z;
}

Envelope upper_envelope(std::vector<PlaneSegment> segments, double slit_mm) {
  return Sweep(std::move(segments), slit_mm).run();
}

}  // namespace limitgauge::engine::strategy
