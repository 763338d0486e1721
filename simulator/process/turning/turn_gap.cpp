#include <algorithm>
#include <queue>
#include <vector>

#include "simulator/process/turning/turn_search.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

struct TurnNearestFirst {
  bool operator()(const TurnBlock& a, const TurnBlock& b) const {
    return a.place.bound > b.place.bound;
  }
};

/// GapSearch with time as a fourth dimension.
class TurnGapSearch {
 public:
  TurnGapSearch(const TurnSearch& search, double within, double tolerance,
                const model::RunControl& control)
      : solid_(search.material()),
        body_(search.body, *search.pose),
        tolerance_(tolerance),
        depth_(tolerance / 2),
        limit_(within + depth_),
        effort_(search.most_looks, control) {}

  TurnAnswer run(double from, double to);

 private:
  void look_at(TurnBlock block);
  TurnDepth depth_in(const TurnBlock& block, const TurnSample& distance) const;
  void offer(const TurnBlock& block, const SweptSample& middle);
  bool touches() const {
    const std::optional<TurnPlace>& found = effort_.answer().place;
    return found && found->mm == 0;
  }

  MaterialAtMove solid_;
  TurningBody body_;
  double tolerance_;
  double depth_;  // of the places that count
  double limit_;  // distance below which a place of that depth is news
  TurnEffort effort_;
  std::priority_queue<TurnBlock, std::vector<TurnBlock>, TurnNearestFirst> queue_;
};

TurnAnswer TurnGapSearch::run(double from, double to) {
  TurnBlock all{{}, (from + to) / 2, (to - from) / 2};
  const model::Box3 where =
      common(body_.box(all.t, all.half_t, limit_), bounding_box(solid_.before->raw()));
  if (where.empty()) return effort_.answer();
  all.place.middle = where.centre(), all.place.half = where.size() * 0.5;
  look_at(all);
  while (!queue_.empty() && !touches()) {
    const TurnBlock block = queue_.top();
    queue_.pop();
    if (block.place.bound >= limit_ || effort_.gives_up()) break;
    for (const TurnBlock& half : halves(block)) look_at(half);
  }
  return effort_.answer();
}

void TurnGapSearch::look_at(TurnBlock block) {
  effort_.look();
  Block& place = block.place;
  const TurnSample s = body_.about(block);
  place.bound = s.under.distance - support(place.half, s.under.gradient);
  if (place.bound >= limit_ || depth_in(block, s).bound_mm < depth_) return;
  place.cover = cover_at(solid_, place.middle, place.cover);
  const TurnDepth depth = depth_in(block, s);
  if (depth.bound_mm < depth_) return;
  offer(block, s.middle);
  // Smaller blocks hold no place of 5/8 tolerance beside a middle of less than half of one, and at
  // no time one that is nearer by as much.
  block.across_time = cut_across_time(block, s, depth, depth_);
  if (length(place.half) + body_.way_mm(block) > tolerance_ / 8) queue_.push(block);
}

/// How deep places of the block may be that are within the limit.
TurnDepth TurnGapSearch::depth_in(const TurnBlock& block, const TurnSample& distance) const {
  const Block& b = block.place;
  return depth_over(depth_under(solid_, b.cover, b.middle, b.half), body_, block, distance, limit_);
}

/// The middle, moved towards the body as far as the depth there surely lets it.
void TurnGapSearch::offer(const TurnBlock& block, const SweptSample& middle) {
  const Block& place = block.place;
  const double spare = depth_under(solid_, place.cover, place.middle, {}).value - depth_;
  if (spare < 0 || middle.distance - spare >= limit_) return;
  const Vec3 p = place.middle - middle.gradient * std::min(spare, std::max(0.0, middle.distance));
  const SweptSample at = body_.at(block.t, p);
  if (at.distance >= limit_) return;
  // The ball of that depth around p is solid: its place nearest to the body counts.
  effort_.find({block.t, p - at.gradient * std::min(depth_, std::max(0.0, at.distance)),
                std::max(0.0, at.distance - depth_)});
  limit_ = at.distance - tolerance_ / 4;
}

}  // namespace

TurnAnswer least_turn_gap(const TurnSearch& search, double within_mm, double tolerance_mm,
                          const model::RunControl& control) {
  return TurnGapSearch(search, within_mm, tolerance_mm, control).run(search.from, search.to);
}

}  // namespace limitgauge::simulator
