#include "simulator/process/contact_search.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

// Refining a contact that is already proven stops here; the header promises a lower bound.
constexpr int kMostContactRefinements = 4000;

struct LessBound {
  bool operator()(const Block& a, const Block& b) const { return a.bound < b.bound; }
};

class ContactSearch {
 public:
  ContactSearch(const MaterialAtMove& material, const CutterProfile& body, const SweptMove& move,
                double tolerance, std::size_t most_looks)
      : material_(material),
        body_(body),
        move_(move),
        tolerance_(tolerance),
        most_looks_(most_looks) {}

  ContactAnswer run(const Box3& where) {
    if (where.empty()) return {};
    look_at({where.centre(), where.size() * 0.5, 0, {}});
    int refinements = 0;
    while (!queue_.empty()) {
      const Block block = queue_.top();
      queue_.pop();
      if (block.bound <= enough()) break;
      if (best_ ? ++refinements > kMostContactRefinements : looks_ > most_looks_)
        return {best_, best_.has_value()};
      for (const Block& half : halves(block)) look_at(half);
    }
    return {best_};
  }

 private:
  double enough() const { return best_ ? best_->depth_mm + tolerance_ : tolerance_; }

  void look_at(Block block) {
    ++looks_;
    const double reach = length(block.half);
    const SweptSample s = swept_distance(body_, move_, block.middle);
    if (s.distance > reach) return;
    // What covers the block around this one mostly covers it too, and saves the search.
    if (bound_under(block, s) <= enough()) return;
    block.cover = cover_at(material_, block.middle, block.cover);
    const Depth own = depth_under(material_, block.cover, block.middle, block.half);
    if (depth_bound(own, s, block.half) <= enough()) return;
    block.bound = bound_under_two(block, own, s);
    if (block.bound <= enough()) return;
    offer(block, s);
    // Smaller blocks than this cannot hide a contact of 1.5 tolerances from their middle.
    if (reach > tolerance_ / 4) queue_.push(block);
  }

  double bound_under(const Block& block, const SweptSample& body) const {
    return depth_bound(depth_under(material_, block.cover, block.middle, block.half), body,
                       block.half);
  }

  // With what covers the block where its own cover leaves most.
  double bound_under_two(const Block& block, const Depth& own, const SweptSample& body) const {
    Vec3 farthest = block.middle;
    for (int axis = 0; axis < 3; ++axis)
      farthest[axis] += std::copysign(block.half[axis], own.gradient[axis]);
    const Cover other = cover_at(material_, farthest, block.cover);
    return depth_bound(own, depth_under(material_, other, block.middle, block.half), body,
                       block.half);
  }

  // The middle itself, or the body's nearest point where the middle is outside the body, and where
  // one comes to from there.
  void offer(const Block& block, const SweptSample& s) {
    const double outside = std::max(0.0, s.distance);
    const double depth_here = depth_under(material_, block.cover, block.middle, {}).value;
    if (depth_here + std::abs(s.distance) <= least()) return;
    const Vec3 p = block.middle - s.gradient * outside;
    climb(p, outside > 0 ? cover_at(material_, p, block.cover) : block.cover);
  }

  // Deeper into the material, by steps that stay in the body since its distance is 1-Lipschitz. So
  // the first blocks show nearly all the depth there is, also of a long strip that is nowhere
  // wider than it is deep; without, all of it would have to be cut up finely first.
  void climb(Vec3 p, Cover cover) {
    constexpr int kMostSteps = 8;
    Depth d = depth_under(material_, cover, p, {});
    for (int step = 0; step < kMostSteps; ++step) {
      if (d.value > least()) best_ = Contact{p, d.value};
      const double room = -swept_distance(body_, move_, p).distance;
      if (room <= tolerance_ / 8) return;
      const Vec3 next = p + d.gradient * room;
      cover = cover_at(material_, next, cover);
      const Depth there = depth_under(material_, cover, next, {});
      if (there.value <= d.value) return;
      p = next, d = there;
    }
  }

  double least() const { return best_ ? best_->depth_mm : tolerance_; }

  const MaterialAtMove& material_;
  const CutterProfile& body_;
  const SweptMove& move_;
  double tolerance_;
  std::size_t most_looks_, looks_ = 0;
  std::optional<Contact> best_;
  std::priority_queue<Block, std::vector<Block>, LessBound> queue_;
};

}  // namespace

ContactAnswer deepest_contact(const MaterialAtMove& material, const CutterProfile& body,
                              const SweptMove& move, double tolerance_mm, std::size_t most_looks) {
  const Box3 where = common(swept_box(body, move), bounding_box(material.before->raw()));
  return ContactSearch(material, body, move, tolerance_mm, most_looks).run(where);
}

}  // namespace limitgauge::simulator
