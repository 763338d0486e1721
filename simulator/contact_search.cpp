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

// What bounds the depth somewhere: a maker of the stock before, or a move of the pass itself.
struct Cover {
  bool of_pass = false;
  SurfaceMaker maker;  // of the pass: its slot
};

// Depth in the material, its gradient, and by how much it may rise above its tangent.
struct Depth {
  double value = 0;
  Vec3 gradient;
  double bend = 0;
  Cover cover;
};

// The depth under one cover alone: never less than the depth under all of them.
Depth depth_under(const MaterialAtMove& m, const Cover& cover, const Vec3& p, const Vec3& half) {
  if (!cover.of_pass && cover.maker.pass == 0) {
    // The raw stock is convex: its depth lies below its tangents.
    const MaterialSample raw = m.before->sample_of({}, p);
    return {-raw.value, -raw.gradient, 0, cover};
  }
  const SweepIndex& pass = cover.of_pass ? *m.pass : *m.before->passes()[cover.maker.pass - 1];
  const SweptSample at = pass.distance(cover.maker.slot, p);
  const double bend = outside_bound(pass.profile(), pass.move(cover.maker.slot), p, at, half);
  return {at.distance, at.gradient, bend, cover};
}

// The cover that gives the depth at p, looking first at `guess`.
Cover cover_at(const MaterialAtMove& m, const Vec3& p, const Cover& guess) {
  const MaterialSample before = m.before->sample(p, guess.of_pass ? SurfaceMaker{} : guess.maker);
  const auto swept = m.pass->nearest(p, -before.value, m.end);
  return swept ? Cover{true, {0, swept->slot}} : Cover{false, before.maker};
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
  Cover cover;
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
    look_at({where.centre(), where.size() * 0.5, 0, {}});
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
    // What covers the block around this one mostly covers it too, and saves the search.
    if (bound_under(block, s) <= enough()) return;
    block.cover = cover_at(material_, block.middle, block.cover);
    block.bound = bound_under(block, s);
    if (block.bound <= enough()) return;
    offer(block, s);
    // Smaller blocks than this cannot hide a contact of 1.5 tolerances from their middle.
    if (reach > tolerance_ / 4) queue_.push(block);
  }

  double bound_under(const Block& block, const SweptSample& body) const {
    return depth_bound(depth_under(material_, block.cover, block.middle, block.half), body,
                       block.half);
  }

  // The middle itself, or the body's nearest point where the middle is outside the body.
  void offer(const Block& block, const SweptSample& s) {
    const double least = best_ ? best_->depth_mm : tolerance_;
    const double outside = std::max(0.0, s.distance);
    const double depth_here = depth_under(material_, block.cover, block.middle, {}).value;
    if (depth_here + outside <= least) return;
    const Vec3 p = block.middle - s.gradient * outside;
    const Cover cover = outside > 0 ? cover_at(material_, p, block.cover) : block.cover;
    const double depth = depth_under(material_, cover, p, {}).value;
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
