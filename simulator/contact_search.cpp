#include "simulator/contact_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

// Refining a contact that is already proven stops here; the header promises a lower bound.
constexpr int kMostRefinements = 4000;

// Depth in the material, its gradient, and by how much it may rise above its tangent.
struct Depth {
  double value = 0;
  Vec3 gradient;
  double bend = 0;
};

Depth depth_at(const MaterialAtMove& m, const Vec3& p, double reach) {
  const MaterialSample before = m.before->sample(p);
  const auto swept = m.pass->nearest(p, -before.value, m.end);
  if (swept) {
    const double bend =
        curvature_bound(m.pass->profile(), m.pass->move(swept->slot), p, swept->at, reach);
    return {swept->at.distance, swept->at.gradient, bend};
  }
  // The raw stock is convex: its depth lies below its tangents.
  if (before.maker.pass == 0) return {-before.value, -before.gradient, 0};
  const SweepIndex& pass = *m.before->passes()[before.maker.pass - 1];
  const SweptSample at = pass.distance(before.maker.slot, p);
  return {at.distance, at.gradient,
          curvature_bound(pass.profile(), pass.move(before.maker.slot), p, at, reach)};
}

// Largest value of v·δ over the box |δ_a| <= half_a.
double support(const Vec3& half, const Vec3& v) {
  return half.x * std::abs(v.x) + half.y * std::abs(v.y) + half.z * std::abs(v.z);
}

// Upper bound of the depth over the part of a block that the body fills: for any λ >= 0,
// depth <= D + e − λ s + max over the block of (∇D − λ ∇s)·δ, since s + ∇s·δ <= 0 in the body.
double depth_bound(const Depth& d, const SweptSample& body, const Vec3& half) {
  const double aligned = std::max(0.0, dot(d.gradient, body.gradient));
  double bound = d.value + support(half, d.gradient);
  for (const double weight : {aligned, length(d.gradient)})
    bound = std::min(bound, d.value - weight * body.distance +
                                support(half, d.gradient - body.gradient * weight));
  return bound + d.bend;
}

struct Block {
  Vec3 middle, half;
  double bound = 0;
  friend bool operator<(const Block& a, const Block& b) { return a.bound < b.bound; }
};

std::array<Block, 2> halves(const Block& b) {
  int axis = b.half.y > b.half.x ? 1 : 0;
  if (b.half.z > b.half[axis]) axis = 2;
  std::array<Block, 2> two{b, b};
  two[0].half[axis] = two[1].half[axis] = b.half[axis] / 2;
  two[0].middle[axis] -= b.half[axis] / 2;
  two[1].middle[axis] += b.half[axis] / 2;
  return two;
}

class Search {
 public:
  Search(const MaterialAtMove& material, const CutterProfile& body, const SweptMove& move,
         double tolerance)
      : material_(material), body_(body), move_(move), tolerance_(tolerance) {}

  std::optional<Contact> run(const Box3& where) {
    if (where.empty()) return std::nullopt;
    look_at({where.centre(), where.size() * 0.5, 0});
    int refinements = 0;
    while (!queue_.empty()) {
      const Block block = queue_.top();
      queue_.pop();
      if (block.bound <= enough()) break;
      if (best_ && ++refinements > kMostRefinements) break;
      for (const Block& half : halves(block)) look_at(half);
    }
    return best_;
  }

 private:
  double enough() const { return best_ ? best_->depth_mm + tolerance_ : tolerance_; }

  void look_at(Block block) {
    const double reach = length(block.half);
    const SweptSample s = swept_distance(body_, move_, block.middle);
    if (s.distance > reach) return;
    const Depth d = depth_at(material_, block.middle, reach);
    block.bound = depth_bound(d, s, block.half);
    if (block.bound <= enough()) return;
    offer(block.middle, s, d);
    // Smaller blocks than this cannot hide a contact of 1.5 tolerances from their middle.
    if (reach > tolerance_ / 4) queue_.push(block);
  }

  // The middle itself, or the body's nearest point where the middle is outside the body.
  void offer(const Vec3& middle, const SweptSample& s, const Depth& d) {
    const double least = best_ ? best_->depth_mm : tolerance_;
    if (d.value + std::max(0.0, s.distance) <= least) return;
    const Vec3 p = s.distance > 0 ? middle - s.gradient * s.distance : middle;
    const double depth = s.distance > 0 ? depth_at(material_, p, 0).value : d.value;
    if (depth > least) best_ = Contact{p, depth};
  }

  const MaterialAtMove& material_;
  const CutterProfile& body_;
  const SweptMove& move_;
  double tolerance_;
  std::optional<Contact> best_;
  std::priority_queue<Block> queue_;
};

Box3 common(const Box3& a, const Box3& b) {
  Box3 c;
  for (int i = 0; i < 3; ++i) {
    c.low[i] = std::max(a.low[i], b.low[i]);
    c.high[i] = std::min(a.high[i], b.high[i]);
  }
  return c;
}

Box3 body_box(const CutterProfile& body, const SweptMove& move) {
  Box3 box;
  box.add(move.start);
  box.add(move.start + move.delta);
  const double r = body.largest_radius();
  box.low -= Vec3{r, r, 0};
  box.high += Vec3{r, r, body.length()};
  return box;
}

}  // namespace

std::optional<Contact> deepest_contact(const MaterialAtMove& material, const CutterProfile& body,
                                       const SweptMove& move, double tolerance_mm) {
  const Box3 where = common(body_box(body, move), bounding_box(material.before->raw()));
  return Search(material, body, move, tolerance_mm).run(where);
}

}  // namespace limitgauge::simulator
