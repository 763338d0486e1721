#include "engine/strategy/axes/leaning_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/strategy/axes/leaning_axis.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

constexpr Vec3 kUpright{0, 0, 1};
constexpr double kMostTurn_rad = 5 * 0.017453292519943295;
/// Of turns in the air, about the centre: what a path may have in one move is a right angle.
constexpr double kMostTurnInAir_rad = 1;
/// Sine of the angle within which a move counts as one of a row: rows are exact but for rounding.
constexpr double kAlongRow = 1e-6;
/// A move is halved so often at most.
constexpr int kMostHalvings = 20;

/// The axis between two, of length 1, by share `t` of their great circle.
Vec3 between(const Vec3& a, const Vec3& b, double t) {
  const double angle = model::angle_between(a, b);
  if (angle < 1e-12) return b;
  return normalized(a * std::sin((1 - t) * angle) + b * std::sin(t * angle));
}

class Leaner {
 public:
  Leaner(const model::Toolpath& upright, const model::Cutter& cutter, const LeanRule& rule)
      : upright_(upright), cutter_(cutter), rule_(rule), radius_mm_(cutter.radius_mm()) {
    const double turn = std::sqrt(8 * rule.bow_mm / radius_mm_);
    most_turn_rad_ = std::min(turn, kMostTurn_rad);
  }

  LeaningPath lean() {
    find_headings();
    find_axes();
    raise_mm_ = highest_hang_mm();
    made_.path.start = upright_.start + Vec3{0, 0, raise_mm_};
    centre_ = made_.path.start + kUpright * radius_mm_;
    for (std::size_t i = 0; i < upright_.moves.size(); ++i) add(i);
    if (!upright_.moves.empty()) turn_in_air(kUpright);
    return std::move(made_);
  }

 private:
  /// Places of the upright path: 0 is its start, i the end of move i - 1.
  std::size_t places() const { return upright_.moves.size() + 1; }
  const Vec3& tip(std::size_t place) const {
    return place == 0 ? upright_.start : upright_.moves[place - 1].to;
  }
  bool in_air(std::size_t place) const { return tip(place).z >= upright_.start.z; }
  /// Of the ball, raised where the path passes above everything.
  Vec3 centre(std::size_t place) const {
    return tip(place) + Vec3{0, 0, radius_mm_ + (in_air(place) ? raise_mm_ : 0)};
  }

  /// 1 along the rows, -1 back; nothing of a move that is not along them.
  std::optional<double> heading_of_move(std::size_t move) const {
    if (upright_.moves[move].kind != model::MoveKind::feed) return std::nullopt;
    Vec3 way = tip(move + 1) - tip(move);
    way.z = 0;
    const double ahead = dot(way, rule_.along);
    if (!(std::abs(ahead) > 0) || length(cross(way, rule_.along)) > kAlongRow * length(way))
      return std::nullopt;
    return ahead > 0 ? 1.0 : -1.0;
  }
  std::optional<double> heading_at(std::size_t place) const {
    const auto before = place > 0 ? heading_of_move(place - 1) : std::nullopt;
    const auto after = place + 1 < places() ? heading_of_move(place) : std::nullopt;
    if (before && after) return (*before + *after) / 2;
    return before ? before : after;
  }
  void find_headings();
  void fill_headings(std::size_t first, std::size_t last,
                     const std::vector<std::optional<double>>& known);

  Vec3 axis_at(const Vec3& centre, double heading) const {
    const Vec3 up = rule_.normal ? rule_.normal(centre.x, centre.y) : kUpright;
    return leaning_axis(up, rule_.along, heading, rule_.lean);
  }
  void find_axes();
  double highest_hang_mm() const;

  struct Place {
    Vec3 centre, axis;
    double heading = 0;
  };
  void add(std::size_t move);
  void add_between(const Place& a, const Place& b, const model::Move& like, int halvings);
  void turn_in_place(const Place& a, const Place& b, const model::Move& like);
  void push(const Vec3& centre, const Vec3& axis, model::Move like);
  void turn_in_air(const Vec3& axis);

  const model::Toolpath& upright_;
  const model::Cutter& cutter_;
  const LeanRule& rule_;
  double radius_mm_, most_turn_rad_ = 0, raise_mm_ = 0;
  std::vector<double> headings_;
  std::vector<Vec3> place_axes_;  ///< of places in the air that of the one below them
  LeaningPath made_;
  Vec3 centre_, axis_ = kUpright;  ///< where the path made so far ends
};

/// Within a chain of places below the air, known headings go over into each other by length.
void Leaner::find_headings() {
  std::vector<std::optional<double>> known(places());
  for (std::size_t i = 0; i < places(); ++i)
    if (!in_air(i)) known[i] = heading_at(i);
  headings_.assign(places(), 0);
  for (std::size_t first = 0; first < places(); ++first) {
    if (in_air(first)) continue;
    std::size_t last = first;
    while (last + 1 < places() && !in_air(last + 1)) ++last;
    fill_headings(first, last, known);
    first = last;
  }
}

void Leaner::fill_headings(std::size_t first, std::size_t last,
                           const std::vector<std::optional<double>>& known) {
  std::vector<double> at_mm(last - first + 1, 0);
  for (std::size_t i = first + 1; i <= last; ++i)
    at_mm[i - first] = at_mm[i - 1 - first] + distance(tip(i - 1), tip(i));
  std::optional<std::size_t> before;
  for (std::size_t i = first; i <= last; ++i) {
    if (known[i]) before = i;
    std::size_t after = i;
    while (after <= last && !known[after]) ++after;
    if (!before && after > last) continue;
    if (!before || after > last || after == *before) {
      headings_[i] = *known[after > last ? *before : after];
      continue;
    }
    const double way_mm = at_mm[after - first] - at_mm[*before - first];
    const double t = way_mm > 0 ? (at_mm[i - first] - at_mm[*before - first]) / way_mm : 1;
    headings_[i] = *known[*before] + t * (*known[after] - *known[*before]);
  }
}

void Leaner::find_axes() {
  place_axes_.assign(places(), kUpright);
  for (std::size_t i = 0; i < places(); ++i)
    if (!in_air(i)) place_axes_[i] = axis_at(tip(i), headings_[i]);
}

double Leaner::highest_hang_mm() const {
  double most_mm = 0;
  for (const Vec3& axis : place_axes_) most_mm = std::max(most_mm, hang_mm(cutter_, axis));
  return most_mm;
}

void Leaner::push(const Vec3& centre, const Vec3& axis, model::Move like) {
  like.to = centre - axis * radius_mm_;
  made_.path.moves.push_back(like);
  made_.axes.to.push_back(axis);
  centre_ = centre, axis_ = axis;
}

/// About the centre, at a rapid.
void Leaner::turn_in_air(const Vec3& axis) {
  const Vec3 from = axis_;
  const double angle = model::angle_between(from, axis);
  if (angle < 1e-12) return;
  const int parts = static_cast<int>(std::ceil(angle / kMostTurnInAir_rad));
  for (int i = 1; i <= parts; ++i)
    push(centre_, between(from, axis, static_cast<double>(i) / parts),
         {{}, 0, 0, model::MoveKind::rapid});
}

/// Where the surface's normal jumps, beyond the rim.
void Leaner::turn_in_place(const Place& a, const Place& b, const model::Move& like) {
  const double angle = model::angle_between(a.axis, b.axis);
  const int parts = std::max(1, static_cast<int>(std::ceil(angle / most_turn_rad_)));
  for (int i = 1; i <= parts; ++i) {
    const double t = static_cast<double>(i) / parts;
    push(lerp(a.centre, b.centre, t), between(a.axis, b.axis, t), like);
  }
}

void Leaner::add_between(const Place& a, const Place& b, const model::Move& like, int halvings) {
  const bool near = !rule_.normal || level_distance(a.centre, b.centre) <= rule_.spacing_mm;
  const double angle = model::angle_between(a.axis, b.axis);
  if (near && angle <= most_turn_rad_) return push(b.centre, b.axis, like);
  if (halvings == 0) return turn_in_place(a, b, like);
  Place middle{(a.centre + b.centre) / 2, {}, (a.heading + b.heading) / 2};
  middle.axis = axis_at(middle.centre, middle.heading);
  add_between(a, middle, like, halvings - 1);
  add_between(middle, b, like, halvings - 1);
}

/// Moves up and down keep the axis; one that sets out from the air turns there first.
void Leaner::add(std::size_t move) {
  const std::size_t from = move, to = move + 1;
  const model::Move& like = upright_.moves[move];
  if (in_air(to)) return push(centre(to), axis_, like);
  if (in_air(from)) {
    turn_in_air(place_axes_[to]);
    return push(centre(to), place_axes_[to], like);
  }
  add_between({centre(from), place_axes_[from], headings_[from]},
              {centre(to), place_axes_[to], headings_[to]}, like, kMostHalvings);
}

}  // namespace

double hang_mm(const model::Cutter& cutter, const Vec3& axis) {
  const double across = std::sqrt(std::max(0.0, 1 - axis.z * axis.z)), radius = cutter.radius_mm();
  double height = cutter.flute_length_mm, most_mm = 0;
  for (const auto* parts : {&cutter.shank, &cutter.holder}) {
    for (const model::CylinderPart& part : *parts) {
      for (const double up : {height, height + part.length_mm})
        most_mm =
            std::max(most_mm, part.diameter_mm / 2 * across - (up - radius) * axis.z - radius);
      height += part.length_mm;
    }
  }
  return most_mm;
}

LeaningPath lean_path(const model::Toolpath& upright, const model::Cutter& cutter,
                      const LeanRule& rule) {
  return Leaner(upright, cutter, rule).lean();
}

}  // namespace limitgauge::engine::strategy
