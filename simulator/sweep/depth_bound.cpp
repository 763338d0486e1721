#include "simulator/sweep/depth_bound.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

Depth depth_in_raw(const MaterialAtMove& m, const Cover& cover, const Vec3& p, const Vec3& half) {
  const MaterialSample raw = m.before->sample_of({}, p);
  // Then the depth lies below its tangents.
  if (m.before->raw().convex()) return {-raw.value, -raw.gradient, 0, cover};
  const double reach = length(half);
  if (reach > 0 && std::abs(raw.value) <= reach)
    if (const auto cap = m.before->raw().solid()->cap(p, reach))
      return {cap->depth, -cap->normal, 0, cover};
  // Of any solid the depth is 1-Lipschitz.
  return {-raw.value, {}, reach, cover};
}

}  // namespace

Depth depth_under(const MaterialAtMove& m, const Cover& cover, const Vec3& p, const Vec3& half) {
  if (!cover.of_pass && cover.maker.pass == 0) return depth_in_raw(m, cover, p, half);
  const SweepIndex& pass = cover.of_pass ? *m.pass : *m.before->passes()[cover.maker.pass - 1];
  const SweptSample at = pass.distance(cover.maker.slot, p);
  const double bend = pass.outside_bound(cover.maker.slot, p, at, half);
  return {at.distance, at.gradient, bend, cover};
}

Cover cover_at(const MaterialAtMove& m, const Vec3& p, const Cover& guess) {
  const MaterialSample before = m.before->sample(p, guess.of_pass ? SurfaceMaker{} : guess.maker);
  const auto swept = m.pass ? m.pass->nearest(p, -before.value, m.end) : std::nullopt;
  return swept ? Cover{true, {0, swept->slot}} : Cover{false, before.maker};
}

double support(const Vec3& half, const Vec3& v) {
  return half.x * std::abs(v.x) + half.y * std::abs(v.y) + half.z * std::abs(v.z);
}

double depth_bound(const Depth& d, const SweptSample& body, const Vec3& half) {
  const double aligned = std::max(0.0, dot(d.gradient, body.gradient));
  double bound = d.value + support(half, d.gradient);
  for (const double weight : {aligned, length(d.gradient)})
    bound = std::min(bound, d.value - weight * body.distance +
                                support(half, d.gradient - body.gradient * weight));
  return bound + d.bend;
}

double depth_bound(const Depth& a, const Depth& b, const SweptSample& body, const Vec3& half) {
  double bound = depth_bound(a, body, half);
  // Best where a component of the mean's gradient vanishes.
  for (int axis = 0; axis < 3; ++axis) {
    const double apart = b.gradient[axis] - a.gradient[axis];
    if (apart == 0) continue;
    const double of_a = b.gradient[axis] / apart, of_b = 1 - of_a;
    if (!(of_a > 0 && of_b > 0)) continue;
    const Depth mean{a.value * of_a + b.value * of_b, a.gradient * of_a + b.gradient * of_b,
                     a.bend * of_a + b.bend * of_b, a.cover};
    bound = std::min(bound, depth_bound(mean, body, half));
  }
  return bound;
}

std::array<Block, 2> halves(const Block& b) {
  int axis = b.half.y > b.half.x ? 1 : 0;
  if (b.half.z > b.half[axis]) axis = 2;
  std::array<Block, 2> two{b, b};
  two[0].half[axis] = two[1].half[axis] = b.half[axis] / 2;
  two[0].middle[axis] -= b.half[axis] / 2;
  two[1].middle[axis] += b.half[axis] / 2;
  return two;
}

Box3 swept_box(const CutterProfile& body, const SweptMove& move) {
  Box3 box;
  box.add(move.start);
  box.add(move.start + move.delta);
  const double r = body.largest_radius();
  box.low -= Vec3{r, r, 0};
  box.high += Vec3{r, r, body.length()};
  return box;
}

Box3 common(const Box3& a, const Box3& b) {
  Box3 c;
  for (int i = 0; i < 3; ++i) {
    c.low[i] = std::max(a.low[i], b.low[i]);
    c.high[i] = std::min(a.high[i], b.high[i]);
  }
  return c;
}

}  // namespace limitgauge::simulator
