#include "engine/strategy/locations/location_question.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/tolerance.h"
#include "model/geometry/segment.h"

namespace limitgauge::engine::strategy {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Distance of two ranges on one axis.
double gap(double low, double high, double from, double to) {
  return std::max({low - to, 0.0, from - high});
}

/// Height of a body's lower side at `squared` of the distance from its axis.
double height_at(const CutterShape& shape, double squared) {
  const double flat = shape.flat_mm();
  return squared <= flat * flat ? shape.bottom_mm() : shape.height(std::sqrt(squared));
}

double plane_lift(const LocationNode& node, const Vec3& tip) {
  return node.plane_lift - node.gx * tip.x - node.gy * tip.y - tip.z;
}

/// Bound on the lift over the part of a node's plane that lies over its box, for tips from
/// `tip + back` to `tip + ahead`: that lift is concave in the place of the plane and the tip, so
/// the tangent at one pair of them bounds it, taken here near the contact with the whole plane.
double tangent_lift(const CutterShape& shape, const LocationNode& node, const TopBox& box,
                    const Vec3& tip, const Vec3& back, const Vec3& ahead) {
  const double x = std::clamp(tip.x + node.contact_x, box.low_x, box.high_x);
  const double y = std::clamp(tip.y + node.contact_y, box.low_y, box.high_y);
  const double out_x = x - tip.x, out_y = y - tip.y;
  const double d = std::sqrt(out_x * out_x + out_y * out_y);
  if (d >= shape.reach_mm()) return std::numeric_limits<double>::infinity();
  const double pull = d > 0 ? shape.slope(d) / d : 0;
  const double by_x = -node.gx - pull * out_x, by_y = -node.gy - pull * out_y;
  double lift = node.c - node.gx * x - node.gy * y - shape.height(d) - tip.z;
  lift += std::max(by_x * (box.low_x - x), by_x * (box.high_x - x));
  lift += std::max(by_y * (box.low_y - y), by_y * (box.high_y - y));
  const auto gain = [&](const Vec3& way) { return pull * (out_x * way.x + out_y * way.y) - way.z; };
  return lift + std::max({0.0, gain(back), gain(ahead)});
}

/// A part of a move, in shares of it.
struct Share {
  double begin = 0, end = 1;

  void cut(double from, double way, double low, double high) {
    if (way == 0) {
      if (from < low || from > high) end = -1;
      return;
    }
    const double a = (low - from) / way, b = (high - from) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
};

}  // namespace

double PlaceQuestion::bound(const LocationNode& node, double known) const {
  if (body_.has_planes && plane_lift(node, tip_) + kBoundSlack_mm <= known) return kNothing;
  const TopBox box = top_box(node);
  const double dx = gap(box.low_x, box.high_x, tip_.x, tip_.x);
  const double dy = gap(box.low_y, box.high_y, tip_.y, tip_.y);
  const double squared = dx * dx + dy * dy, reach = body_.shape.reach_mm() + kReachSlack_mm;
  if (squared > reach * reach) return kNothing;
  double lift = box.high_z - height_at(body_.shape, squared) - tip_.z;
  if (body_.has_planes)
    lift = std::min(
        {lift, plane_lift(node, tip_), tangent_lift(body_.shape, node, box, tip_, {}, {})});
  return lift + kBoundSlack_mm;
}

bool PlaceQuestion::concerns(const TopBox& box, double known) const {
  const double reach = body_.shape.distance_below(box.high_z - tip_.z - known + kBoundSlack_mm);
  const double dx = gap(box.low_x, box.high_x, tip_.x, tip_.x);
  const double dy = gap(box.low_y, box.high_y, tip_.y, tip_.y);
  const double wide = reach + kReachSlack_mm;
  return reach >= 0 && dx * dx + dy * dy <= wide * wide;
}

void PlaceQuestion::ask(const Corners& corners, GreatestLift& greatest) const {
  lift_over_triangle(body_.shape, {corners[0] - tip_, corners[1] - tip_, corners[2] - tip_},
                     greatest);
}

MoveQuestion::MoveQuestion(const AskingBody& body, const Vec3& from, const Vec3& to)
    : body_(body), from_(from), to_(to), way_(to - from) {
  const double length = std::hypot(way_.x, way_.y);
  if (length <= 0) return;
  left_x_ = -way_.y / length;
  left_y_ = way_.x / length;
}

MoveQuestion::Part MoveQuestion::within(const TopBox& box, double reach) const {
  // A little wider: the division that finds the ends of the part rounds.
  const double wide = reach + 2 * kReachSlack_mm;
  Share share;
  share.cut(from_.x, way_.x, box.low_x - wide, box.high_x + wide);
  share.cut(from_.y, way_.y, box.low_y - wide, box.high_y + wide);
  if (share.begin > share.end) return {};
  Part part{from_ + way_ * share.begin, from_ + way_ * share.end, 0, false};
  const Vec3 &a = part.from, &b = part.to;
  const double dx = gap(box.low_x, box.high_x, std::min(a.x, b.x), std::max(a.x, b.x));
  const double dy = gap(box.low_y, box.high_y, std::min(a.y, b.y), std::max(a.y, b.y));
  const double half_x = (box.high_x - box.low_x) / 2, x = box.low_x + half_x - from_.x;
  const double half_y = (box.high_y - box.low_y) / 2, y = box.low_y + half_y - from_.y;
  const double aside =
      std::abs(left_x_ * x + left_y_ * y) - std::abs(left_x_) * half_x - std::abs(left_y_) * half_y;
  const double away = std::max(0.0, aside - kReachSlack_mm);
  part.squared_mm2 = std::max(dx * dx + dy * dy, away * away);
  part.empty = part.squared_mm2 > wide * wide;
  return part;
}

MoveQuestion::Part MoveQuestion::concerned(const TopBox& box, double known) const {
  Part part = within(box, body_.shape.reach_mm());
  // The lowest tip of a part says how far the box can matter; that makes the part shorter.
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds && !part.empty; ++round) {
    const double low = std::min(part.from.z, part.to.z);
    const double reach = body_.shape.distance_below(box.high_z - low - known + kBoundSlack_mm);
    if (reach < 0) return {};
    part = within(box, reach);
  }
  return part;
}

/// Cheap bounds over the whole move, which for short ones are as good as those over its parts.
bool MoveQuestion::lifts_no_more(const LocationNode& node, const TopBox& box, double known) const {
  if (body_.has_planes &&
      std::max(plane_lift(node, from_), plane_lift(node, to_)) + kBoundSlack_mm <= known)
    return true;
  const double dx = gap(box.low_x, box.high_x, std::min(from_.x, to_.x), std::max(from_.x, to_.x));
  const double dy = gap(box.low_y, box.high_y, std::min(from_.y, to_.y), std::max(from_.y, to_.y));
  const double squared = dx * dx + dy * dy, reach = body_.shape.reach_mm() + kReachSlack_mm;
  if (squared > reach * reach) return true;
  const double lowest = std::min(from_.z, to_.z);
  return box.high_z - height_at(body_.shape, squared) - lowest + kBoundSlack_mm <= known;
}

double MoveQuestion::bound(const LocationNode& node, double known) const {
  const TopBox box = top_box(node);
  if (lifts_no_more(node, box, known)) return kNothing;
  const Part part = concerned(box, known);
  if (part.empty) return kNothing;
  double lift = box.high_z - height_at(body_.shape, part.squared_mm2);
  lift -= std::min(part.from.z, part.to.z);
  if (body_.has_planes) lift = std::min(lift, plane_bound(node, box, part, known));
  return lift + kBoundSlack_mm;
}

double MoveQuestion::plane_bound(const LocationNode& node, const TopBox& box, const Part& part,
                                 double known) const {
  const double at_from = plane_lift(node, part.from), at_to = plane_lift(node, part.to);
  const double lift = std::max(at_from, at_to);
  if (lift <= known) return lift;
  // The plane cannot matter where the move is so far above it that it lifts by less than known.
  const double share = (known - at_from) / (at_to - at_from);
  const Vec3 way = part.to - part.from, between = part.from + way * share;
  const Vec3 from = at_from < known ? between : part.from, to = at_to < known ? between : part.to;
  const Vec3 rest = to - from;
  // The tip that touches the plane nearest to the middle of the box.
  const double x = (box.low_x + box.high_x) / 2 - node.contact_x - from.x;
  const double y = (box.low_y + box.high_y) / 2 - node.contact_y - from.y;
  const double at = model::nearest_share(model::Vec2{x, y}, model::Vec2{rest.x, rest.y});
  return std::min(
      lift, tangent_lift(body_.shape, node, box, from + rest * at, rest * -at, rest * (1 - at)));
}

bool MoveQuestion::concerns(const TopBox& box, double known) const {
  return !concerned(box, known).empty;
}

void MoveQuestion::ask(const Corners& corners, GreatestLift& greatest) const {
  Corners a, b;
  for (int i = 0; i < 3; ++i) {
    a[i] = corners[i] - from_;
    b[i] = corners[i] - to_;
  }
  lift_over_prism(body_.shape, a, b, greatest);
}

}  // namespace limitgauge::engine::strategy
