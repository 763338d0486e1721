#include "simulator/process/turn_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

/// Some ten seconds. A turn that comes no nearer than a tool's width takes some thousands.
constexpr std::size_t kMostLooks = 4'000'000;

/// A part of the body, in the tool's frame, over a stretch of the turn.
struct TurnBlock {
  Vec3 middle, half;
  double t = 0, half_t = 0;
  double bound = 0;
  SurfaceMaker guess;
};

struct LessDeep {
  bool operator()(const TurnBlock& a, const TurnBlock& b) const { return a.bound < b.bound; }
};

class TurnSearch {
 public:
  TurnSearch(const Material& solid, const ToolBody& body, const TurningPose& pose, double least_mm,
             double precision_mm)
      : solid_(solid), body_(body), pose_(pose), least_mm_(least_mm), precision_mm_(precision_mm) {}

  std::optional<DeepestTurn> run();

 private:
  double enough() const { return (best_ ? best_->depth_mm : least_mm_) + precision_mm_; }
  MeridianSample body_at(const Vec3& p) const {
    return body_.profile.sample(std::hypot(p.x, p.y), p.z - body_.base_mm);
  }
  /// How far a place of the block goes in half its stretch of time, at most.
  double way(const TurnBlock& block) const {
    const double farthest = length(block.middle) + length(block.half);
    return (pose_.tip_speed_mm + pose_.turn_rad * farthest) * block.half_t;
  }
  void look_at(TurnBlock block);
  void offer(const TurnBlock& block, const model::Pose& pose, double outside_mm);
  std::array<TurnBlock, 2> halves(const TurnBlock& block) const;

  const Material& solid_;
  const ToolBody& body_;
  const TurningPose& pose_;
  double least_mm_, precision_mm_;
  std::size_t looks_ = 0;
  std::optional<DeepestTurn> best_;
  std::priority_queue<TurnBlock, std::vector<TurnBlock>, LessDeep> queue_;
};

void TurnSearch::look_at(TurnBlock block) {
  ++looks_;
  const double reach = length(block.half), outside = body_at(block.middle).distance;
  if (outside > reach) return;
  const model::Pose pose = pose_.at(block.t);
  const MaterialSample here = solid_.sample(pose.point(block.middle), block.guess);
  block.guess = here.maker;
  const double way_mm = way(block);
  block.bound = reach + way_mm - here.value;
  if (block.bound <= enough()) return;
  if (-here.value + std::abs(outside) > (best_ ? best_->depth_mm : least_mm_))
    offer(block, pose, outside);
  // Smaller blocks than this cannot hide what is deeper by the precision than their middle.
  if (reach + way_mm > precision_mm_ / 2) queue_.push(block);
}

/// The middle, or the body's nearest place where it is outside, and deeper from there by steps that
/// stay in the body since its distance is 1-Lipschitz.
void TurnSearch::offer(const TurnBlock& block, const model::Pose& pose, double outside_mm) {
  constexpr int kMostSteps = 6;
  Vec3 p = block.middle;
  if (outside_mm > 0) {
    const MeridianSample at = body_at(p);
    const double rho = std::hypot(p.x, p.y);
    const Vec3 out = rho > 0 ? Vec3{p.x / rho, p.y / rho, 0} : Vec3{1, 0, 0};
    p = p - (out * at.g_rho + Vec3{0, 0, at.g_z}) * outside_mm;
  }
  for (int step = 0; step < kMostSteps; ++step) {
    const double room = -body_at(p).distance;
    if (room < -precision_mm_ / 8) return;
    const MaterialSample here = solid_.sample(pose.point(p), block.guess);
    if (-here.value > (best_ ? best_->depth_mm : least_mm_))
      best_ = DeepestTurn{block.t, p, -here.value, true};
    if (room <= precision_mm_ / 8) return;
    p = p - pose.direction_back(here.gradient) * room;
  }
}

std::array<TurnBlock, 2> TurnSearch::halves(const TurnBlock& block) const {
  TurnBlock low = block, high = block;
  if (way(block) > length(block.half)) {
    low.half_t = high.half_t = block.half_t / 2;
    low.t -= low.half_t, high.t += high.half_t;
    return {low, high};
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (block.half[k] > block.half[axis]) axis = k;
  low.half[axis] = high.half[axis] = block.half[axis] / 2;
  low.middle[axis] -= low.half[axis], high.middle[axis] += high.half[axis];
  return {low, high};
}

std::optional<DeepestTurn> TurnSearch::run() {
  const double r = body_.profile.largest_radius(), half = body_.profile.length() / 2;
  look_at({{0, 0, body_.base_mm + half}, {r, r, half}, 0.5, 0.5, 0, {}});
  while (!queue_.empty()) {
    const TurnBlock block = queue_.top();
    queue_.pop();
    if (block.bound <= enough()) break;
    if (looks_ > kMostLooks) {
      if (!best_) best_ = DeepestTurn{block.t, block.middle, least_mm_, false};
      best_->proven = false;
      break;
    }
    for (const TurnBlock& part : halves(block)) look_at(part);
  }
  return best_;
}

}  // namespace

std::optional<DeepestTurn> deepest_turn(const Material& solid, const ToolBody& body,
                                        const TurningPose& pose, double least_mm,
                                        double precision_mm) {
  return TurnSearch(solid, body, pose, least_mm, precision_mm).run();
}

}  // namespace limitgauge::simulator
