#include "simulator/process/turning/turning_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Pose;
using model::Vec3;

constexpr int kBoundLooks = 32;
constexpr std::array<Vec3, 3> kUnits{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

/// Of the tip and of the unit vectors, by what they move between three times that follow each
/// other: a pose is out of bounds where that is more than `speed` times the step or `bend` times
/// its square.
bool keeps_to(const Vec3& a, const Vec3& b, const Vec3& c, double speed, double bend) {
  constexpr double kStep = 1.0 / kBoundLooks;
  return distance(a, b) <= speed * kStep + kDistanceRounding_mm &&
         length(a - b * 2 + c) <= bend * kStep * kStep + kDistanceRounding_mm;
}

bool keeps_to_bounds(const TurningPose& pose, const std::array<Pose, 3>& three) {
  const Pose &a = three[0], &b = three[1], &c = three[2];
  if (!keeps_to(a.shift_mm, b.shift_mm, c.shift_mm, pose.tip_speed_mm, pose.tip_bend_mm))
    return false;
  return std::all_of(kUnits.begin(), kUnits.end(), [&](const Vec3& unit) {
    return keeps_to(a.direction(unit), b.direction(unit), c.direction(unit), pose.turn_rad,
                    pose.turn_bend_rad);
  });
}

double farthest_mm(const MovingShape& shape) {
  if (shape.tool)
    return std::hypot(shape.tool->profile.largest_radius(),
                      shape.tool->base_mm + shape.tool->profile.length());
  const Box3& box = shape.mesh->box();
  Vec3 corner;
  for (int a = 0; a < 3; ++a) corner[a] = std::max(std::abs(box.low[a]), std::abs(box.high[a]));
  return length(corner);
}

/// Of a box, turned and moved: the box around it.
Box3 moved_box(const Box3& box, const Pose& pose) {
  const Vec3 half = box.size() * 0.5;
  Box3 moved;
  moved.add(pose.point(box.centre()));
  Vec3 reach;
  for (int a = 0; a < 3; ++a) reach[a] = support(half, pose.direction_back(kUnits[a]));
  moved.low -= reach, moved.high += reach;
  return moved;
}

}  // namespace

TurningPose TurningPose::even(std::function<Pose(double t)> at, double tip_speed_mm,
                              double turn_rad) {
  return {std::move(at), tip_speed_mm, turn_rad, 2 * turn_rad * tip_speed_mm, turn_rad * turn_rad};
}

void require_bounds(const TurningPose& pose) {
  if (!(pose.tip_speed_mm >= 0) || !std::isfinite(pose.tip_speed_mm) || !(pose.turn_rad >= 0) ||
      !std::isfinite(pose.turn_rad) || !(pose.tip_bend_mm >= 0) || !(pose.turn_bend_rad >= 0))
    throw std::invalid_argument("the bounds of a turn must be numbers from 0 up");
  const auto at = [&](int k) { return pose.at(static_cast<double>(k) / kBoundLooks); };
  std::array<Pose, 3> three{at(0), at(1), at(2)};
  for (int k = 2;; ++k) {
    if (!keeps_to_bounds(pose, three) || !keeps_to_bounds(pose, {three[2], three[1], three[0]}))
      throw std::invalid_argument("a turn goes faster, or bends more, than its bounds say");
    if (k == kBoundLooks) return;
    three = {three[1], three[2], at(k + 1)};
  }
}

TurningBody::TurningBody(const MovingShape& shape, const TurningPose& pose)
    : shape_(shape), turning_(pose), farthest_mm_(farthest_mm(shape)) {}

const Pose& TurningBody::pose(double t) const {
  const auto known = poses_.find(t);
  return known != poses_.end() ? known->second : poses_.emplace(t, turning_.at(t)).first->second;
}

SweptSample TurningBody::sample(const Pose& pose, const Vec3& own) const {
  if (shape_.mesh) {
    const SolidSample s = shape_.mesh->sample(own);
    return {s.distance, pose.direction(s.gradient), 0};
  }
  const double rho = std::hypot(own.x, own.y);
  const MeridianSample s = shape_.tool->profile.sample(rho, own.z - shape_.tool->base_mm);
  const Vec3 outward = rho > 0 ? Vec3{own.x / rho, own.y / rho, 0} : Vec3{1, 0, 0};
  return {s.distance, pose.direction(outward * s.g_rho + Vec3{0, 0, s.g_z}), 0};
}

SweptSample TurningBody::at(double t, const Vec3& p) const {
  const Pose& now = pose(t);
  return sample(now, now.point_back(p));
}

// The distance changes no faster than the body's own places go, nor than the place does as the body
// sees it.
double TurningBody::way_mm(const TurnBlock& block, double from_tip_mm) const {
  const double seen_mm = from_tip_mm + turning_.tip_speed_mm * block.half_t;
  return (turning_.tip_speed_mm + turning_.turn_rad * std::min(farthest_mm_, seen_mm)) *
         block.half_t;
}

double TurningBody::way_mm(const TurnBlock& block) const {
  const double from_tip_mm = distance(block.place.middle, pose(block.t).shift_mm);
  return way_mm(block, from_tip_mm + length(block.place.half));
}

/// By how much the distance may be below its tangent of the middle, to the first order.
double TurningBody::drop_mm(const TurnBlock& block, const Vec3& own, const Vec3& gradient) const {
  const Vec3& p = block.place.middle;
  const double step = block.half_t, speed = turning_.tip_speed_mm, turn = turning_.turn_rad;
  const Pose &before = pose(block.t - step), &after = pose(block.t + step);
  const Vec3 along = (after.point_back(p) - before.point_back(p)) * 0.5;
  const Vec3 turned = (after.direction(gradient) - before.direction(gradient)) * 0.5;
  const double seen_mm = length(own) + speed * step + length(block.place.half);
  const double bend = turning_.turn_bend_rad * seen_mm + 2 * turn * speed + turning_.tip_bend_mm;
  return std::abs(dot(gradient, along)) + support(block.place.half, turned) +
         bend * step * step / 2;
}

TurnSample TurningBody::about(const TurnBlock& block) const {
  const Pose& now = pose(block.t);
  const Vec3 own = now.point_back(block.place.middle);
  const SweptSample s = sample(now, own);
  const double spread_mm = length(block.place.half);
  double drop = way_mm(block, length(own) + spread_mm);
  // A mesh has no planes under its distance but level ones.
  if (shape_.mesh) return {s, {s.distance - spread_mm - drop, {}, 0}, drop};
  if (bends_known()) drop = std::min(drop, drop_mm(block, own, now.direction_back(s.gradient)));
  return {s, {s.distance - drop, s.gradient, 0}, drop};
}

bool TurningBody::bends_known() const {
  return std::isfinite(turning_.tip_bend_mm) && std::isfinite(turning_.turn_bend_rad);
}

double TurningBody::extent_mm(double t, const Vec3& direction) const {
  const Vec3 own = pose(t).direction_back(direction);
  const double tip = dot(direction, pose(t).shift_mm);
  if (shape_.mesh) {
    const Box3& box = shape_.mesh->box();
    return tip + dot(own, box.centre()) + support(box.size() * 0.5, own);
  }
  return tip + own.z * shape_.tool->base_mm +
         shape_.tool->profile.extent(std::hypot(own.x, own.y), own.z);
}

// A place of the body keeps within its bend, times half the square of half the stretch, of the
// chord from where it is at the stretch's beginning to where it is at its end.
double TurningBody::extent_mm(double t, double half_t, const Vec3& direction) const {
  const double size = length(direction);
  const double speed = turning_.tip_speed_mm + turning_.turn_rad * farthest_mm_;
  const double from_middle = extent_mm(t, direction) + size * speed * half_t;
  if (half_t == 0 || !bends_known()) return from_middle;
  const double bend = turning_.tip_bend_mm + turning_.turn_bend_rad * farthest_mm_;
  return std::min(from_middle,
                  std::max(extent_mm(t - half_t, direction), extent_mm(t + half_t, direction)) +
                      size * bend * half_t * half_t / 2);
}

Box3 TurningBody::box(double t, double half_t, double margin_mm) const {
  const double way = turning_.tip_speed_mm * half_t;
  if (shape_.mesh)
    return moved_box(shape_.mesh->box(), pose(t))
        .grown(way + turning_.turn_rad * farthest_mm_ * half_t + margin_mm);
  Box3 box;
  box.add(pose(t).shift_mm);
  return box.grown(way + farthest_mm_ + margin_mm);
}

TurnDepth depth_over(const Depth& d, const TurningBody& body, const TurnBlock& block,
                     const TurnSample& distance, double grown_mm) {
  const auto bound = [&](double higher_mm, double half_t) {
    const SweptSample s{distance.under.distance + higher_mm - grown_mm, distance.under.gradient, 0};
    const double reaching = body.extent_mm(block.t, half_t, d.gradient) +
                            grown_mm * length(d.gradient) - dot(d.gradient, block.place.middle);
    return std::min(depth_bound(d, s, block.place.half), d.value + reaching + d.bend);
  };
  return {bound(0, block.half_t), bound(distance.change_mm, 0)};
}

bool cut_across_time(const TurnBlock& block, const TurnSample& distance, const TurnDepth& depth,
                     double enough_mm) {
  return depth.at_once_mm <= enough_mm || distance.change_mm > length(block.place.half);
}

std::array<TurnBlock, 2> halves(const TurnBlock& block) {
  std::array<TurnBlock, 2> two{block, block};
  if (block.across_time) {
    for (TurnBlock& half : two) half.half_t /= 2;
    two[0].t -= two[0].half_t, two[1].t += two[1].half_t;
    return two;
  }
  const std::array<Block, 2> places = halves(block.place);
  two[0].place = places[0], two[1].place = places[1];
  return two;
}

}  // namespace limitgauge::simulator
