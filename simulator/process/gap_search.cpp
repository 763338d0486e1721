#include "simulator/process/gap_search.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

// Narrowing down a gap that is already proven stops here; the header promises an upper bound.
constexpr int kMostGapRefinements = 4000;

struct NearestFirst {
  bool operator()(const Block& a, const Block& b) const { return a.bound > b.bound; }
};

class GapSearch {
 public:
  GapSearch(const MaterialAtMove& material, const CutterProfile& body, const SweptMove& move,
            double within, double tolerance, const Excuse& excuse)
      : material_(material),
        body_(body),
        move_(move),
        excuse_(excuse),
        tolerance_(tolerance),
        depth_(tolerance / 2),
        limit_(within + depth_) {}

  std::optional<Gap> run(const Box3& where) {
    if (where.empty()) return std::nullopt;
    look_at({where.centre(), where.size() * 0.5, 0, {}});
    int refinements = 0;
    while (!queue_.empty() && !(best_ && best_->distance_mm == 0)) {
      const Block block = queue_.top();
      queue_.pop();
      if (block.bound >= limit_) break;
      if (best_ && ++refinements > kMostGapRefinements) break;
      for (const Block& half : halves(block)) look_at(half);
    }
    return best_;
  }

 private:
  void look_at(Block block) {
    const SweptSample s = swept_distance(body_, move_, block.middle);
    block.bound = s.distance - support(block.half, s.gradient);
    if (block.bound >= limit_ || cannot_count(block, s)) return;
    block.cover = cover_at(material_, block.middle, block.cover);
    if (cannot_count(block, s) || excused(block, s)) return;
    offer(block, s);
    // Smaller blocks hold no place of 5/8 tolerance beside a middle of less than half of one.
    if (length(block.half) > tolerance_ / 8) queue_.push(block);
  }

  // No place of the block within the limit is deep enough under the block's cover.
  bool cannot_count(const Block& block, const SweptSample& s) const {
    const SweptSample grown{s.distance - limit_, s.gradient, s.t};
    return depth_bound(depth_under(material_, block.cover, block.middle, block.half), grown,
                       block.half) < depth_;
  }

  bool excused(const Block& block, const SweptSample& s) const {
    if (block.bound < -tolerance_) return false;  // outside_bound speaks of distances above zero
    return std::any_of(excuse_.moves.begin(), excuse_.moves.end(), [&](const SweptMove& m) {
      const SweptSample other = swept_distance(*excuse_.profile, m, block.middle);
      const double nearer = other.distance - s.distance - tolerance_;
      return nearer <= 0 &&
             nearer + support(block.half, other.gradient - s.gradient) +
                     outside_bound(*excuse_.profile, m, block.middle, other, block.half) <=
                 0;
    });
  }

  bool excused(const Vec3& p, double distance) const {
    return std::any_of(excuse_.moves.begin(), excuse_.moves.end(), [&](const SweptMove& m) {
      return swept_distance(*excuse_.profile, m, p).distance <= distance + tolerance_;
    });
  }

  // The middle, moved towards the body as far as the depth there surely lets it.
  void offer(const Block& block, const SweptSample& s) {
    const double spare = depth_under(material_, block.cover, block.middle, {}).value - depth_;
    if (spare < 0 || s.distance - spare >= limit_) return;
    const Vec3 p = block.middle - s.gradient * std::min(spare, std::max(0.0, s.distance));
    const SweptSample at = swept_distance(body_, move_, p);
    if (at.distance >= limit_ || excused(p, at.distance)) return;
    // The ball of that depth around p is material: its point nearest to the body counts.
    const double left = std::max(0.0, at.distance - depth_);
    best_ = Gap{p - at.gradient * std::min(depth_, std::max(0.0, at.distance)), left};
    limit_ = at.distance - tolerance_ / 4;
  }

  const MaterialAtMove& material_;
  const CutterProfile& body_;
  const SweptMove& move_;
  const Excuse& excuse_;
  double tolerance_;
  double depth_;  // of the places that count
  double limit_;  // distance below which a place of that depth is news
  std::optional<Gap> best_;
  std::priority_queue<Block, std::vector<Block>, NearestFirst> queue_;
};

}  // namespace

std::optional<Gap> least_gap(const MaterialAtMove& material, const CutterProfile& body,
                             const SweptMove& move, double within_mm, double tolerance_mm,
                             const Excuse& excuse) {
  const Box3 where = common(swept_box(body, move).grown(within_mm + tolerance_mm / 2),
                            bounding_box(material.before->raw()));
  return GapSearch(material, body, move, within_mm, tolerance_mm, excuse).run(where);
}

}  // namespace limitgauge::simulator
