#include "engine/strategy/raster/tip_track.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/tolerance.h"
#include "model/geometry/polyline.h"

namespace limitgauge::engine::strategy {
namespace {

struct Sample {
  Vec3 p;
  bool covered = false;  ///< something is under the cutter
};

class Tracker {
 public:
  Tracker(const CutterLocations& locations, const TrackRule& rule)
      : locations_(locations), rule_(rule) {}

  std::vector<std::vector<Vec3>> track(const std::vector<Vec3>& way) {
    if (way.empty()) return {};
    append(at(way.front()));
    for (std::size_t i = 1; i < way.size(); ++i) add_line(way[i - 1], way[i]);
    end_run();
    for (auto& run : runs_) run = reduced(run);
    return std::move(runs_);
  }

 private:
  Sample at(const Vec3& p) const {
    const auto z = locations_.tip_z(p.x, p.y);
    const bool touches = z && *z >= rule_.lowest_mm;
    return {{p.x, p.y, touches ? std::max(*z, rule_.floor_z_mm) : 0.0}, touches};
  }
  Sample between(const Sample& a, const Sample& b) const { return at((a.p + b.p) * 0.5); }

  void append(const Sample& s) {
    if (!s.covered) return end_run();
    if (run_.empty() || !(run_.back() == s.p)) run_.push_back(s.p);
  }
  void end_run() {
    if (!run_.empty()) runs_.push_back(std::move(run_));
    run_.clear();
  }

  void add_line(const Vec3& from, const Vec3& to) {
    const double length = level_distance(from, to);
    const int parts = 1 + static_cast<int>(length / rule_.spacing_mm);
    Sample a = at(from);
    for (int k = 1; k <= parts; ++k) {
      const Sample b = at(k == parts ? to : lerp(from, to, static_cast<double>(k) / parts));
      fill(a, between(a, b), b);
      a = b;
    }
  }

  /// Appends what follows `a` up to and with `b`.
  void fill(const Sample& a, const Sample& middle, const Sample& b) {
    if (!a.covered && !b.covered && !middle.covered) return;
    if (level_distance(a.p, b.p) <= kStepWidth_mm) return step(a, b);
    const Sample first = between(a, middle), last = between(middle, b);
    if (fits(a, b, {&first, &middle, &last})) return append(b);
    fill(a, first, middle);
    fill(middle, last, b);
  }

  bool fits(const Sample& a, const Sample& b, const std::array<const Sample*, 3>& inner) const {
    if (!a.covered || !b.covered) return false;
    const double run = level_distance(a.p, b.p);
    const double cosine = run / std::hypot(run, b.p.z - a.p.z);
    for (std::size_t k = 0; k < inner.size(); ++k) {
      if (!inner[k]->covered) return false;
      const double share = static_cast<double>(k + 1) / static_cast<double>(inner.size() + 1);
      const double gap = a.p.z + (b.p.z - a.p.z) * share - inner[k]->p.z;
      if (gap * cosine > rule_.above_mm || -gap > rule_.lift_mm) return false;
    }
    return locations_.clears(a.p, b.p, rule_.lift_mm);
  }

  /// Between two places that are as good as one: up on the spot, across, down on the spot.
  void step(const Sample& a, const Sample& b) {
    if (!a.covered || !b.covered) return append(b);
    Vec3 from = a.p, to = b.p;
    from.z = to.z = std::max(a.p.z, b.p.z);
    const double lift = locations_.lift(from, to).value_or(0.0) - rule_.lift_mm;
    if (lift > 0) from.z = to.z = from.z + lift;
    append({from, true});
    append({to, true});
    append(b);
  }

  std::vector<Vec3> reduced(const std::vector<Vec3>& run) const {
    const auto reduction = model::reduce_chords(
        run.size(), [&](std::size_t i, std::size_t j) { return may_join(run, i, j); });
    std::vector<Vec3> kept;
    for (const std::size_t i : reduction) kept.push_back(run[i] + Vec3{0, 0, rule_.lift_mm});
    return kept;
  }

  bool may_join(const std::vector<Vec3>& run, std::size_t i, std::size_t j) const {
    for (std::size_t k = i + 1; k < j; ++k)
      if (distance_to_segment(run[k], run[i], run[j]) > rule_.reduction_mm) return false;
    return locations_.clears(run[i], run[j], rule_.lift_mm);
  }

  const CutterLocations& locations_;
  const TrackRule& rule_;
  std::vector<Vec3> run_;
  std::vector<std::vector<Vec3>> runs_;
};

}  // namespace

std::vector<std::vector<Vec3>> track_tips(const CutterLocations& locations,
                                          const std::vector<Vec3>& way, const TrackRule& rule) {
  return Tracker(locations, rule).track(way);
}

}  // namespace limitgauge::engine::strategy
