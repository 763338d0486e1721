#include "simulator/process/turning/turn_search.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

struct LessTurnBound {
  bool operator()(const TurnBlock& a, const TurnBlock& b) const {
    return a.place.bound < b.place.bound;
  }
};

/// ContactSearch with time as a fourth dimension.
class TurnContactSearch {
 public:
  TurnContactSearch(const TurnSearch& search, double tolerance, const model::RunControl& control)
      : solid_(search.material()),
        body_(search.body, *search.pose),
        tolerance_(tolerance),
        effort_(search.most_looks, control) {}

  TurnAnswer run(double from, double to);

 private:
  const std::optional<TurnPlace>& found() const { return effort_.answer().place; }
  double least() const { return found() ? found()->mm : tolerance_; }
  double enough() const { return found() ? least() + tolerance_ : tolerance_; }
  TurnDepth depth_in(const TurnBlock& block, const TurnSample& distance) const {
    const Block& b = block.place;
    return depth_over(depth_under(solid_, b.cover, b.middle, b.half), body_, block, distance, 0);
  }
  void look_at(TurnBlock block);
  void offer(const TurnBlock& block, const SweptSample& middle);
  void climb(double t, Vec3 p, Cover cover);

  MaterialAtMove solid_;
  TurningBody body_;
  double tolerance_;
  TurnEffort effort_;
  std::priority_queue<TurnBlock, std::vector<TurnBlock>, LessTurnBound> queue_;
};

TurnAnswer TurnContactSearch::run(double from, double to) {
  TurnBlock all{{}, (from + to) / 2, (to - from) / 2};
  const model::Box3 where =
      common(body_.box(all.t, all.half_t, 0), bounding_box(solid_.before->raw()));
  if (where.empty()) return effort_.answer();
  all.place.middle = where.centre(), all.place.half = where.size() * 0.5;
  look_at(all);
  while (!queue_.empty()) {
    const TurnBlock block = queue_.top();
    queue_.pop();
    if (block.place.bound <= enough() || effort_.gives_up()) break;
    for (const TurnBlock& half : halves(block)) look_at(half);
  }
  return effort_.answer();
}

void TurnContactSearch::look_at(TurnBlock block) {
  effort_.look();
  Block& place = block.place;
  const TurnSample s = body_.about(block);
  if (s.under.distance > support(place.half, s.under.gradient)) return;
  // What covers the block around this one mostly covers it too, and saves the search.
  if (depth_in(block, s).bound_mm <= enough()) return;
  place.cover = cover_at(solid_, place.middle, place.cover);
  const TurnDepth depth = depth_in(block, s);
  place.bound = depth.bound_mm;
  if (place.bound <= enough()) return;
  offer(block, s.middle);
  block.across_time = cut_across_time(block, s, depth, enough());
  // Smaller blocks than this cannot hide a contact of 1.5 tolerances from their middle.
  if (length(place.half) + body_.way_mm(block) > tolerance_ / 4) queue_.push(block);
}

/// The middle itself, or the body's nearest place where the middle is outside, and where one comes
/// to from there.
void TurnContactSearch::offer(const TurnBlock& block, const SweptSample& middle) {
  const Block& place = block.place;
  const double outside = std::max(0.0, middle.distance);
  const double depth = depth_under(solid_, place.cover, place.middle, {}).value;
  if (depth + std::abs(middle.distance) <= least()) return;
  climb(block.t, place.middle - middle.gradient * outside, place.cover);
}

/// Deeper into the solid, by steps that stay in the body since its distance is 1-Lipschitz.
void TurnContactSearch::climb(double t, Vec3 p, Cover cover) {
  constexpr int kMostSteps = 8;
  const auto depth_at = [&](const Vec3& place) {
    cover = cover_at(solid_, place, cover);
    return depth_under(solid_, cover, place, {});
  };
  Depth d = depth_at(p);
  for (int step = 0; step < kMostSteps; ++step) {
    if (d.value > least()) effort_.find({t, p, d.value});
    const double room = -body_.at(t, p).distance;
    if (room <= tolerance_ / 8) return;
    const Vec3 next = p + d.gradient * room;
    const Depth there = depth_at(next);
    if (there.value <= d.value) return;
    p = next, d = there;
  }
}

}  // namespace

TurnAnswer deepest_turn_contact(const TurnSearch& search, double tolerance_mm,
                                const model::RunControl& control) {
  return TurnContactSearch(search, tolerance_mm, control).run(search.from, search.to);
}

}  // namespace limitgauge::simulator
