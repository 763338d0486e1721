#include "simulator/sweep/near_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr double kFar = std::numeric_limits<double>::infinity();

bool lies_below_tops(const SweepTree& pass, const MoveBatch& moves, const HeldCube& cube) {
  return pass.profile().is_ball() &&
         cube.middle.z + cube.half_edge_mm <= moves.below_tops_mm(pass.profile());
}

}  // namespace

double NearMoves::gather(const SweepIndex& pass, const Cube& cube, double limit) {
  return gather_own(pass.own(), pass.to_own(cube), limit);
}

double NearMoves::gather_own(const SweepTree& pass, const HeldCube& cube, double limit) {
  kept_.clear();
  moves_.assign(pass, kept_);
  too_many_ = false;
  const auto found = pass.nearest(cube.middle, limit);
  if (!found) return kFar;
  if (pass.profile().is_ball() && cube.middle.z + cube.half_edge_mm <= pass.below_tops_mm()) {
    const double to_foot = found->at.distance + pass.profile().corner_radius();
    pass.gather_rivals({cube.middle, cube.half_edge_mm, found->at.gradient * to_foot}, kept_);
  } else {
    const double reach = found->at.distance + 2 * cube.half_diagonal_mm + kDistanceRounding_mm;
    pass.gather(cube.middle, std::min(limit, reach), kept_);
  }
  too_many_ = kept_.size() > kMostHandedDown;
  if (too_many_) kept_.clear();
  moves_.assign(pass, kept_);
  last_.reset();
  below_tops_ = lies_below_tops(pass, moves_, cube);
  return found->at.distance;
}

double NearMoves::narrow(const SweepIndex& index, const NearMoves& wider, const Cube& asked,
                         double limit) {
  if (wider.too_many_) return gather(index, asked, limit);
  moves_.slot.clear();
  too_many_ = false;
  if (wider.empty()) return kFar;
  const SweepTree& pass = index.own();
  const HeldCube cube = index.to_own(asked);
  below_tops_ = lies_below_tops(pass, wider.moves_, cube);
  const double least = below_tops_ ? keep_balls(pass, wider.moves_, cube, limit)
                                   : keep_others(pass, wider.moves_, cube, limit);
  if (least > limit) return kFar;
  moves_.take(wider.moves_, kept_);
  last_.reset();
  return least;
}

double NearMoves::keep_balls(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube,
                             double limit) {
  const double squared = capsules_.nearest(from, cube.middle, cube.half_edge_mm);
  const double least = std::sqrt(squared) - pass.profile().corner_radius();
  if (least <= limit) capsules_.keep(from, kept_);
  return least;
}

// A move that is farther than the limit, or than the nearest one by a diagonal, cannot matter and
// is not worked out.
double NearMoves::sample(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube,
                         double limit) {
  const std::size_t n = from.size();
  samples_.resize(n);
  double least = kFar;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t slot = from.slot[i];
    const double most =
        std::min(limit, least + 2 * cube.half_diagonal_mm) + 2 * kDistanceRounding_mm;
    const bool far = pass.cannot_be_below(slot, cube.middle, most);
    const SweptSample s =
        far ? SweptSample{kFar, {}, 0} : pass.distance_below(slot, cube.middle, most);
    least = std::min(least, s.distance);
    samples_.set(i, s, pass, slot, cube.middle, cube.half_diagonal_mm);
  }
  return least;
}

// Of the nearest moves, often several on a flat floor, the one whose distance bends least.
std::size_t NearMoves::straightest(const SweepTree& pass, const MoveBatch& from,
                                   const HeldCube& cube, double& bend) const {
  const auto& d = samples_.distance;
  const auto least = std::min_element(d.begin(), d.end());
  std::size_t best = least - d.begin();
  const double r = cube.half_diagonal_mm;
  bend = 2 * r;
  for (std::size_t i = best; i < d.size() && bend > 0; ++i) {
    if (d[i] > *least) continue;
    const std::uint32_t slot = from.slot[i];
    const SweptSample at{d[i], samples_.gradient(i), pass.distance(slot, cube.middle).t};
    const double e = pass.curvature_bound(slot, cube.middle, at, r);
    if (e < bend) bend = e, best = i;
  }
  return best;
}

// d is convex: move i stays above its tangent, the nearest one below a paraboloid. Of turning moves
// it is not.
double NearMoves::keep_others(const SweepTree& pass, const MoveBatch& from, const HeldCube& cube,
                              double limit) {
  const double least = sample(pass, from, cube, limit);
  if (least > limit) return least;
  if (pass.turns()) {
    rivals_.keep(pass, from, samples_, cube.middle, cube.half_edge_mm, cube.half_diagonal_mm,
                 kept_);
    return least;
  }
  double bend = 0;
  const std::size_t j = straightest(pass, from, cube, bend);
  const Vec3 g = samples_.gradient(j);
  kept_.clear();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double behind = samples_.distance[i] - samples_.distance[j];
    const double turn = norm1(samples_.gradient(i) - g);
    const bool twin = behind == 0 && turn == 0 && bend == 0;
    const double most = std::min(2 * cube.half_diagonal_mm, cube.half_edge_mm * turn + bend);
    if (i == j || (!twin && behind <= most + kDistanceRounding_mm))
      kept_.push_back(static_cast<std::uint32_t>(i));
  }
  return least;
}

std::optional<NearestMove> NearMoves::nearest(const SweepIndex& pass, const Vec3& p,
                                              double bound) const {
  std::optional<NearestMove> found = nearest_own(pass.own(), pass.to_own(p), bound);
  if (found) found->at = pass.from_own(found->at);
  return found;
}

std::optional<NearestMove> NearMoves::nearest_own(const SweepTree& pass, const Vec3& p,
                                                  double bound) const {
  if (too_many_) return pass.nearest(p, bound);
  std::optional<NearestMove> best;
  const auto look_at = [&](std::uint32_t slot) {
    const SweptSample d = pass.distance_below(slot, p, bound);
    if (d.distance < bound) bound = d.distance, best = NearestMove{slot, d};
  };
  if (!below_tops_) {
    // Of turning moves each look is dear: where the last place's move is not above its own distance
    // here, most of the others need none. The first of equal ones is still the one found.
    if (pass.turns() && last_)
      bound = std::min(bound, std::nextafter(pass.distance(*last_, p).distance, kFar));
    for (const std::uint32_t slot : moves_.slot)
      if (!pass.cannot_be_below(slot, p, bound)) look_at(slot);
    if (best) last_ = best->slot;
    return best;
  }
  if (empty()) return best;
  const BallFound found = nearest_ball(moves_, p, squares_);
  if (std::sqrt(found.squared) - pass.profile().corner_radius() < bound + kDistanceRounding_mm)
    look_at(moves_.slot[found.place]);
  return best;
}

}  // namespace limitgauge::simulator
