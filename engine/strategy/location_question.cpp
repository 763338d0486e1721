#include "engine/strategy/location_question.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::engine::strategy {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
/// Bounds are raised by this against rounding.
constexpr double kBoundSlack_mm = 1e-10;

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

/// A part of a move, in shares of it.
struct Part {
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

double PlaceQuestion::bound(const LocationNode& node) const {
  const double dx = gap(node.low_x, node.high_x, tip_.x, tip_.x);
  const double dy = gap(node.low_y, node.high_y, tip_.y, tip_.y);
  const double squared = dx * dx + dy * dy, reach = body_.shape.reach_mm() + kReachSlack_mm;
  if (squared > reach * reach) return kNothing;
  const double lift = node.high_z - height_at(body_.shape, squared) - tip_.z;
  return kBoundSlack_mm + (body_.has_planes ? std::min(lift, plane_lift(node, tip_)) : lift);
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

double MoveQuestion::bound(const LocationNode& node) const {
  // A little wider: the division that finds the ends of the part rounds.
  const double reach = body_.shape.reach_mm() + 2 * kReachSlack_mm;
  Part part;
  part.cut(from_.x, way_.x, node.low_x - reach, node.high_x + reach);
  part.cut(from_.y, way_.y, node.low_y - reach, node.high_y + reach);
  if (part.begin > part.end) return kNothing;
  const Vec3 a = from_ + way_ * part.begin, b = from_ + way_ * part.end;
  const double dx = gap(node.low_x, node.high_x, std::min(a.x, b.x), std::max(a.x, b.x));
  const double dy = gap(node.low_y, node.high_y, std::min(a.y, b.y), std::max(a.y, b.y));
  const double half_x = (node.high_x - node.low_x) / 2.0, x = node.low_x + half_x - from_.x;
  const double half_y = (node.high_y - node.low_y) / 2.0, y = node.low_y + half_y - from_.y;
  const double aside =
      std::abs(left_x_ * x + left_y_ * y) - std::abs(left_x_) * half_x - std::abs(left_y_) * half_y;
  const double away = std::max(0.0, aside - kReachSlack_mm);
  const double squared = std::max(dx * dx + dy * dy, away * away);
  if (squared > reach * reach) return kNothing;
  const double lift =
      node.high_z - height_at(body_.shape, squared) - std::min(a.z, b.z) + kBoundSlack_mm;
  if (!body_.has_planes) return lift;
  return std::min(lift, std::max(plane_lift(node, a), plane_lift(node, b)) + kBoundSlack_mm);
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
