#include "verifier/probe/standing_point.h"

#include <algorithm>
#include <vector>

#include "verifier/probe/half_spaces.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Vec3;

namespace {

/// Steps of the search; a foot on a smooth place takes two, one on a cusp some four.
constexpr int kMostLooks = 24;
/// Bodies that hold the search off at once: three meet in a point, the rest is their neighbours.
constexpr std::size_t kMostBodies = 8;
/// A point that is nearer by less is no reason to go on.
constexpr double kLeastGain_mm = kDistanceRounding_mm / 10;

class StandingSearch {
 public:
  StandingSearch(const RemovedSpace& removed, const Vec3& p, const Nearest& first)
      : removed_(removed),
        p_(p),
        wanted_mm_(removed.chord_error_mm() + 2 * kDistanceRounding_mm),
        at_(p),
        bodies_{first.body} {}

  std::optional<StandingPoint> run() {
    for (int look = 0; look < kMostLooks; ++look) {
      spaces_.clear();
      for (const BodyRef body : bodies_) spaces_.push_back(outside_of(body));
      const std::optional<Vec3> next = nearest_in_all(spaces_, p_);
      if (!next) break;
      at_ = *next;
      const Nearest there = removed_.nearest(at_, bodies_.back());
      if (stands(there)) {
        if (!is_gain()) break;
      } else {
        hold_off(there.body);
      }
    }
    return best_;
  }

 private:
  bool stands(const Nearest& there) const {
    const double needed = removed_.chord_error_mm() + kDistanceRounding_mm;
    return there.distance.value - there.distance.slack_mm >= needed;
  }

  bool is_gain() {
    const double away = distance(p_, at_) + kDistanceRounding_mm;
    if (best_ && away > best_->distance_mm - kLeastGain_mm) return false;
    best_ = StandingPoint{at_, away};
    return true;
  }

  /// Where the supporting plane of the body's distance at the present place is far enough.
  HalfSpace outside_of(BodyRef body) const {
    const BodyDistance d = removed_.distance(body, at_);
    const double steepness = length(d.gradient);
    if (steepness < kCancels) return {{0, 0, 1}, at_.z + wanted_mm_ - d.value};
    const Vec3 normal = d.gradient / steepness;
    const double missing = (wanted_mm_ + d.slack_mm - d.value) / steepness;
    return {normal, dot(normal, at_) + missing};
  }

  /// Looks at the body too from now on, in place of the one that is furthest from mattering.
  void hold_off(BodyRef body) {
    if (std::find(bodies_.begin(), bodies_.end(), body) != bodies_.end()) return;
    if (bodies_.size() == kMostBodies) {
      const auto slack = [this](const HalfSpace& s) { return dot(s.normal, at_) - s.offset_mm; };
      const auto idle =
          std::max_element(spaces_.begin(), spaces_.end(),
                           [&](const auto& a, const auto& b) { return slack(a) < slack(b); });
      bodies_.erase(bodies_.begin() + (idle - spaces_.begin()));
    }
    bodies_.push_back(body);
  }

  const RemovedSpace& removed_;
  const Vec3 p_;
  const double wanted_mm_;
  Vec3 at_;
  std::vector<BodyRef> bodies_;
  std::vector<HalfSpace> spaces_;  ///< beside bodies_
  std::optional<StandingPoint> best_;
};

}  // namespace

std::optional<StandingPoint> standing_point(const RemovedSpace& removed, const Vec3& p,
                                            const Nearest& first) {
  return StandingSearch(removed, p, first).run();
}

}  // namespace limitgauge::verifier
