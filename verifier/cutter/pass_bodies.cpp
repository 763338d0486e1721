#include "verifier/cutter/pass_bodies.h"

#include <algorithm>
#include <utility>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Vec3;

constexpr std::uint32_t kLeafBodies = 6;
/// Of turning ones, whose own bounds take longer than those of nodes.
constexpr std::uint32_t kLeafTurning = 3;
/// How much more heights count than places in plan where moves are divided: of a flat as wide as a
/// node's box it is the height that tells which moves are near.
constexpr double kHeightsOfFlat = 4;

Box3 tips_of(const SweptBody& body) {
  Box3 tips;
  tips.add(body.from), tips.add(body.to);
  return tips;
}

/// A tree over the boxes of the moves' tips.
model::BoxTree tip_tree(const CutterProfile& profile, const std::vector<SweptBody>& bodies) {
  const double scale = profile.flat_mm > 0 ? kHeightsOfFlat : 1;
  std::vector<Box3> tips(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    tips[i] = tips_of(bodies[i]);
    tips[i].low.z *= scale, tips[i].high.z *= scale;
  }
  model::BoxTree tree = model::box_tree(tips, kLeafBodies);
  for (model::BoxNode& node : tree.nodes) node.box.low.z /= scale, node.box.high.z /= scale;
  return tree;
}

model::BoxTree core_tree(const std::vector<TurningBody>& bodies) {
  std::vector<Box3> cores(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) cores[i] = bodies[i].cores();
  return model::box_tree(cores, kLeafTurning);
}

}  // namespace

void PassBodies::take_order(model::BoxTree tree) {
  index_ = std::move(tree.order), nodes_ = std::move(tree.nodes);
  place_.resize(index_.size());
  for (std::uint32_t k = 0; k < index_.size(); ++k) place_[index_[k]] = k;
}

PassBodies::PassBodies(const CutterProfile& profile, const std::vector<SweptBody>& bodies)
    : profile_(profile) {
  take_order(tip_tree(profile, bodies));
  upright_.reserve(bodies.size());
  for (const std::uint32_t move : index_) upright_.push_back(bodies[move]);
  if (TiltedBox::serves(profile)) tilted_ = tilted_boxes(nodes_, upright_);
}

PassBodies::PassBodies(const CutterProfile& profile, const std::vector<TurningBody>& bodies)
    : profile_(profile) {
  take_order(core_tree(bodies));
  turning_.reserve(bodies.size());
  for (const std::uint32_t move : index_) turning_.push_back(bodies[move]);
  size_mm_ = farthest_from_core_mm(profile);
  cones_ = axis_cones(nodes_, turning_);
  for (const TurningBody& body : turning_) {
    own_cones_.emplace_back(body);
    own_cores_.push_back(body.cores());
  }
}

double PassBodies::bound(const model::BoxNode& node, const Vec3& p, double limit_mm,
                         const Vec3& half) const {
  const auto at = static_cast<std::size_t>(&node - nodes_.data());
  if (turn()) return cones_[at].bound(profile_, size_mm_, node.box, p, half, limit_mm);
  // As from p to tips that may be as much further apart.
  const Box3 tips{node.box.low - half, node.box.high + half};
  if (profile_.is_ball()) return ball_bound(at, tips, p, limit_mm, half);
  const double by_box = box_bound(profile_, tips, p);
  if (by_box > limit_mm || tilted_.empty()) return by_box;
  return std::max(by_box, tilted_[at].bound(profile_, p, half));
}

/// By squares, of which most are beyond the limit: one root is worked out, and of few nodes.
double PassBodies::ball_bound(std::size_t node, const Box3& tips, const Vec3& p, double limit_mm,
                              const Vec3& half) const {
  constexpr double kBeyond = std::numeric_limits<double>::infinity();
  const double reach = limit_mm + profile_.rounding_mm + kDistanceRounding_mm;
  const double over = p.z - (tips.high.z + profile_.top_mm);
  if (reach < 0 || over > limit_mm) return kBeyond;
  double square = square_from_cores(profile_, tips, p);
  if (square > reach * reach) return kBeyond;
  if (!tilted_.empty() && tilted_[node].is_above(profile_, p, half)) {
    square = std::max(square, tilted_[node].square(profile_, p, half));
    if (square > reach * reach) return kBeyond;
  }
  return std::max(std::sqrt(square) - profile_.rounding_mm - kDistanceRounding_mm, over);
}

double PassBodies::bound_at(std::uint32_t place, const Vec3& p, double limit_mm,
                            const Vec3& half) const {
  if (turn()) {
    const TurningBody& body = turning_[place];
    const auto by_cone = [&] {
      return own_cones_[place].bound(profile_, size_mm_, own_cores_[place], p, half, limit_mm);
    };
    if (profile_.is_whole_ball()) return by_cone();
    const double by_look = body.bound(profile_, p, half);
    return by_look > limit_mm || body.is_short() ? by_look : std::max(by_look, by_cone());
  }
  const Box3 tips = tips_of(upright_[place]);
  return box_bound(profile_, {tips.low - half, tips.high + half}, p);
}

double PassBodies::value_at(std::uint32_t place, const Vec3& p, double beyond_mm) const {
  if (!turn()) return body_value(profile_, upright_[place], p);
  const double bound = bound_at(place, p, beyond_mm);
  return bound > beyond_mm ? bound : turning_[place].least(profile_, p, beyond_mm).distance.value;
}

/// What is above the limit is never looked at for d itself, so that the looks, and what they find,
/// are the same for any limit.
std::optional<BodyDistance> PassBodies::distance_up_to(std::uint32_t place, const Vec3& p,
                                                       double beyond_mm) const {
  if (bound_at(place, p, beyond_mm) > beyond_mm) return std::nullopt;
  const BodyDistance d = turning_[place].least(profile_, p, beyond_mm).distance;
  return d.value > beyond_mm ? std::nullopt : std::optional(d);
}

BodyDistance PassBodies::distance_at(std::uint32_t place, const Vec3& p,
                                     double precision_mm) const {
  if (!turn()) return body_distance(profile_, upright_[place], p);
  constexpr double kAny = std::numeric_limits<double>::infinity();
  return turning_[place].least(profile_, p, kAny, precision_mm).distance;
}

void PassBodies::values_at(std::uint32_t place, const Bezier& cell,
                           std::array<double, 16>& out) const {
  if (turn()) return turning_[place].values(profile_, cell, out);
  body_values(profile_, upright_[place], cell, out);
}

double PassBodies::lower_at(std::uint32_t place, std::span<const Vec3> points, const Vec3& middle,
                            double enough_mm) const {
  return turning_[place].lower(profile_, points, middle, enough_mm);
}

}  // namespace limitgauge::verifier
