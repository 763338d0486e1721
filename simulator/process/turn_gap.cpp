#include <algorithm>
#include <queue>
#include <vector>

#include "simulator/process/turn_search.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

// Narrowing down a gap that is already proven stops here; the header promises an upper bound.
constexpr std::size_t kMostNearerLooks = 20'000;
// Looks between two questions whether to stop: some milliseconds.
constexpr std::size_t kGapLooksBetweenStops = 4096;

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
      : solid_(*search.solid),
        body_(*search.body, *search.pose),
        tolerance_(tolerance),
        depth_(tolerance / 2),
        limit_(within + depth_),
        most_looks_(search.most_looks),
        control_(control) {}

  TurnAnswer run(double from, double to);

 private:
  void look_at(TurnBlock block);
  TurnDepth depth_in(const TurnBlock& block, const TurnSample& distance) const;
  void offer(const TurnBlock& block, const SweptSample& middle);
  bool gives_up();
  bool touches() const { return answer_.place && answer_.place->mm == 0; }

  const Material& solid_;
  TurningBody body_;
  double tolerance_;
  double depth_;  // of the places that count
  double limit_;  // distance below which a place of that depth is news
  std::size_t most_looks_;
  const model::RunControl& control_;
  TurnAnswer answer_;
  std::size_t first_found_ = 0;  // looks when something was
  std::priority_queue<TurnBlock, std::vector<TurnBlock>, TurnNearestFirst> queue_;
};

TurnAnswer TurnGapSearch::run(double from, double to) {
  TurnBlock all{{}, (from + to) / 2, (to - from) / 2};
  const model::Box3 where =
      common(body_.box(all.t, all.half_t, limit_), bounding_box(solid_.raw()));
  if (where.empty()) return answer_;
  all.place.middle = where.centre(), all.place.half = where.size() * 0.5;
  look_at(all);
  while (!queue_.empty() && !touches()) {
    const TurnBlock block = queue_.top();
    queue_.pop();
    if (block.place.bound >= limit_ || gives_up()) break;
    for (const TurnBlock& half : halves(block)) look_at(half);
  }
  return answer_;
}

bool TurnGapSearch::gives_up() {
  if (answer_.place) return answer_.looks - first_found_ > kMostNearerLooks;
  answer_.proven = answer_.looks <= most_looks_;
  return !answer_.proven;
}

void TurnGapSearch::look_at(TurnBlock block) {
  if (answer_.looks++ % kGapLooksBetweenStops == 0) control_.check();
  Block& place = block.place;
  const TurnSample s = body_.about(block);
  place.bound = s.under.distance - support(place.half, s.under.gradient);
  if (place.bound >= limit_ || depth_in(block, s).bound_mm < depth_) return;
  place.cover.maker = solid_.sample(place.middle, place.cover.maker).maker;
  const TurnDepth depth = depth_in(block, s);
  if (depth.bound_mm < depth_) return;
  offer(block, {s.under.distance + s.change_mm, s.under.gradient, 0});
  // Smaller blocks hold no place of 5/8 tolerance beside a middle of less than half of one, and at
  // no time one that is nearer by as much.
  block.across_time = cut_across_time(block, s, depth, depth_);
  if (length(place.half) + body_.way_mm(block) > tolerance_ / 8) queue_.push(block);
}

/// How deep places of the block may be that are within the limit.
TurnDepth TurnGapSearch::depth_in(const TurnBlock& block, const TurnSample& distance) const {
  const Block& b = block.place;
  const MaterialAtMove solid{&solid_, nullptr, 0};
  return depth_over(depth_under(solid, b.cover, b.middle, b.half), body_, block, distance, limit_);
}

/// The middle, moved towards the body as far as the depth there surely lets it.
void TurnGapSearch::offer(const TurnBlock& block, const SweptSample& middle) {
  const Block& place = block.place;
  const MaterialAtMove solid{&solid_, nullptr, 0};
  const double spare = depth_under(solid, place.cover, place.middle, {}).value - depth_;
  if (spare < 0 || middle.distance - spare >= limit_) return;
  const Vec3 p = place.middle - middle.gradient * std::min(spare, std::max(0.0, middle.distance));
  const SweptSample at = body_.at(block.t, p);
  if (at.distance >= limit_) return;
  if (!answer_.place) first_found_ = answer_.looks;
  // The ball of that depth around p is solid: its place nearest to the body counts.
  answer_.place = TurnPlace{block.t, p - at.gradient * std::min(depth_, std::max(0.0, at.distance)),
                            std::max(0.0, at.distance - depth_)};
  limit_ = at.distance - tolerance_ / 4;
}

}  // namespace

TurnAnswer least_turn_gap(const TurnSearch& search, double within_mm, double tolerance_mm,
                          const model::RunControl& control) {
  return TurnGapSearch(search, within_mm, tolerance_mm, control).run(search.from, search.to);
}

}  // namespace limitgauge::simulator
