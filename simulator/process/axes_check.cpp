#include "simulator/process/axes_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/angle.h"
#include "simulator/process/turning/trailing_contact.h"
#include "simulator/sweep/depth_bound.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Move;
using model::MoveKind;
using model::Pose;
using model::Vec3;

/// How finely it is looked when a rapid's flutes have left the stock, or begin to arrive.
constexpr int kTimesBeside = 16;

/// A frame whose +Z is the tool's axis, turned along with it and not about it.
TurningPose pose_of_move(const Pass& pass, std::size_t i) {
  const TurningMove m(move_from(*pass.path, i), pass.path->moves[i].to, axis_from(*pass.axes, i),
                      pass.axes->to[i], 0);
  const auto at = [m](double t) {
    const Vec3 up = m.up(t), across = cross(m.axis, m.side), side = cross(across, up);
    return Pose{{Vec3{side.x, across.x, up.x}, {side.y, across.y, up.y}, {side.z, across.z, up.z}},
                m.tip(t)};
  };
  return {at, length(m.delta), m.turn_rad, 0, m.turn_rad * m.turn_rad};
}

/// No material stands farther above a tip of the path than this.
double farthest_material(const StockModel& before, const model::Toolpath& path) {
  const model::Box3 box = bounding_box(before.material().raw());
  double most = distance(path.start, box.centre());
  for (const Move& m : path.moves) most = std::max(most, distance(m.to, box.centre()));
  return most + length(box.size()) / 2;
}

}  // namespace

AxesCheck::AxesCheck(const StockModel& before, const Pass& pass, const ProcessLimits& limits,
                     const model::RunControl& control)
    : pass_(pass),
      path_(*pass.path),
      limits_{limits.tolerance_mm, limits.near_miss_mm},
      bodies_(pass.cutter, farthest_material(before, path_)),
      sweep_(pass, control),
      idle_(path_) {
  solids_.push_back({"stock", before.material(), true});
  for (const model::Fixture& fixture : limits.fixtures)
    solids_.push_back(
        {fixture.name, Material(RawStock(model::MeshStock{fixture.mesh, fixture.file, 0})), false});
}

void AxesCheck::look_at(std::size_t move, const model::RunControl& control,
                        std::vector<Finding>& findings) const {
  const Turning m{move, pose_of_move(pass_, move), control};
  look_at_cutter(m, findings);
  look_above_flutes(m, findings);
  look_at_fixtures(m, findings);
}

TurnSearch AxesCheck::search(const Turning& m, const ToolBody& body, std::size_t solid,
                             std::size_t end) const {
  TurnSearch s{&solids_[solid].solid, &body, &m.pose};
  if (solids_[solid].is_stock) s.pass = &sweep_, s.end = static_cast<std::uint32_t>(end);
  return s;
}

Finding AxesCheck::finding(FindingKind kind, const Turning& m, const Vec3& point, double depth_mm,
                           const ToolBody& body, std::size_t solid) const {
  return {kind,     m.move,          path_.moves[m.move].line, point,
          depth_mm, name(body.part), solids_[solid].name};
}

bool AxesCheck::look_for(FindingKind kind, const Turning& m, const ToolBody& body,
                         std::size_t solid, std::size_t end, std::vector<Finding>& findings) const {
  return look_by(
      [&](double tolerance) {
        return deepest_turn_contact(search(m, body, solid, end), tolerance, m.control);
      },
      {kind, m, body, solid}, findings);
}

/// No place of the block is farther from a tip of the move than this.
double AxesCheck::reach_into_stock(std::size_t i) const {
  const model::Box3 box = bounding_box(solids_.front().solid.raw());
  const auto from = [&](const Vec3& tip) {
    return distance(tip, box.centre()) + length(box.size()) / 2;
  };
  return std::max(from(move_from(path_, i)), from(path_.moves[i].to));
}

/// How far a move down its own axis goes aside within `reach_mm` of its tip; infinite of another.
double AxesCheck::aside_mm(std::size_t i, double reach_mm) const {
  const Vec3 &axis = axis_from(*pass_.axes, i), &axis_to = pass_.axes->to[i];
  const Vec3 way = path_.moves[i].to - move_from(path_, i);
  const double down = -dot(way, axis);
  if (down < 0) return std::numeric_limits<double>::infinity();
  const double turn_rad = std::atan2(length(cross(axis, axis_to)), dot(axis, axis_to));
  return length(way + axis * down) + turn_rad * reach_mm;
}

// Down its own axis a part no wider than all below it meets nothing but what it already stood in
// before, but for as much as it goes aside, and no contact grows by more than that. Counted from
// the last move that was looked at in full.
bool AxesCheck::follows_flutes(const Turning& m, const ToolBody& body, double within_mm) const {
  constexpr std::size_t kMostMoves = 1000;
  if (!bodies_.trails(body) || m.move == 0) return false;
  double sum_mm = 0;
  std::size_t i = m.move;
  for (; i > 0 && m.move - i < kMostMoves; --i) {
    const double reach = std::min(body.base_mm + body.profile.length(), reach_into_stock(i));
    const double aside = aside_mm(i, reach);
    if (aside > within_mm && i < m.move) return true;
    sum_mm += aside;
    if (sum_mm > within_mm) return false;
  }
  return i == 0;  // the first move is looked at in full
}

bool AxesCheck::look_for_part(FindingKind kind, const Turning& m, const ToolBody& body,
                              std::vector<Finding>& findings) const {
  const bool turns = m.pose.turn_rad > 0;
  const std::size_t end = turns || rises(m.move) ? m.move : m.move + 1;
  return look_by(
      [&](double tolerance) -> TurnAnswer {
        if (follows_flutes(m, body, tolerance / 2)) return {};
        TurnSearch s = search(m, body, 0, end);
        if (tolerance < limits_.tolerance_mm) s.most_looks /= 10;
        return turns ? trailing_contact(s, {&pass_, m.move}, tolerance, m.control)
                     : deepest_turn_contact(s, tolerance, m.control);
      },
      {kind, m, body, 0}, findings);
}

// The first look is only sure of what is half as deep again as its tolerance; given up, it is a
// finding.
template <class Look>
bool AxesCheck::look_by(const Look& look, const Looked& what,
                        std::vector<Finding>& findings) const {
  for (const double tolerance : {limits_.tolerance_mm, limits_.slightest_mm()}) {
    const TurnAnswer found = look(tolerance);
    if (!found.place && found.proven) continue;
    if (!found.place && tolerance < limits_.tolerance_mm) return false;
    const TurnPlace place = found.place.value_or(TurnPlace{0, what.m.pose.at(0).shift_mm, 0});
    const bool counts = !found.proven || place.mm > limits_.tolerance_mm;
    findings.push_back(finding(counts ? what.kind : FindingKind::slight_contact, what.m,
                               place.point, place.mm, what.body, what.solid));
    return true;
  }
  return false;
}

void AxesCheck::look_near(const Turning& m, const ToolBody& body, std::size_t solid,
                          std::size_t end, double from, double to,
                          std::vector<Finding>& findings) const {
  if (!(limits_.near_miss_mm > 0) || !(from < to)) return;
  TurnSearch s = search(m, body, solid, end);
  s.from = from, s.to = to, s.most_looks /= 10;
  const auto near = least_turn_gap(s, limits_.near_miss_mm, limits_.tolerance_mm, m.control).place;
  if (near)
    findings.push_back(finding(FindingKind::near_miss, m, near->point, -near->mm, body, solid));
}

void AxesCheck::look_at_cutter(const Turning& m, std::vector<Finding>& findings) const {
  const Move& move = path_.moves[m.move];
  const ToolBody& flutes = bodies_.flutes;
  const bool rapid = move.kind == MoveKind::rapid, leaves = rapid && backs_out(m.move);
  if (rapid && !leaves) look_at_rapid(m, findings);
  if (move.spindle_stopped && !leaves)
    look_for(FindingKind::spindle_stopped, m, flutes, 0, idle_.spindle_stopped.begin(m.move),
             findings);
  if (lacks_feed(move)) {
    const TurnSearch s = search(m, flutes, 0, idle_.without_feed.begin(m.move));
    const TurnPlace at = deepest_turn_contact(s, limits_.tolerance_mm, m.control)
                             .place.value_or(TurnPlace{0, m.pose.at(0).shift_mm, 0});
    findings.push_back(finding(FindingKind::feed_missing, m, at.point, at.mm, flutes, 0));
  }
  if (descends_too_steeply(m.move))
    look_for(FindingKind::steep_descent, m, flutes, 0, m.move, findings);
}

// The flutes leave from where a feed move ended and arrive where one begins: until they have been
// farther away than a near miss is, they are beside what they cut.
void AxesCheck::look_at_rapid(const Turning& m, std::vector<Finding>& findings) const {
  const std::size_t begin = idle_.rapids.begin(m.move), end = idle_.rapids.end(m.move);
  const ToolBody& flutes = bodies_.flutes;
  if (look_for(FindingKind::rapid_through_stock, m, flutes, 0, begin, findings) ||
      !(limits_.near_miss_mm > 0))
    return;
  const auto is_near = [&](int k) {
    TurnSearch s = search(m, flutes, 0, begin);
    s.from = s.to = static_cast<double>(k) / kTimesBeside;
    return least_turn_gap(s, limits_.near_miss_mm, limits_.tolerance_mm, m.control)
        .place.has_value();
  };
  int left = 0, arrives = kTimesBeside;
  if (m.move == begin)
    while (left < kTimesBeside && is_near(left)) ++left;
  std::size_t last = m.move;
  while (last + 1 < end && path_.moves[last + 1].kind == MoveKind::rapid) ++last;
  if (m.move == last)
    while (arrives > left && is_near(arrives)) --arrives;
  look_near(m, flutes, 0, begin, static_cast<double>(left) / kTimesBeside,
            static_cast<double>(arrives) / kTimesBeside, findings);
}

// Where a tool that does not turn goes up its own axis, a part above the flutes gets to places
// before them; else what they sweep is gone before it does.
bool AxesCheck::rises(std::size_t i) const {
  const Vec3 way = path_.moves[i].to - move_from(path_, i);
  return dot(way, axis_from(*pass_.axes, i)) > 0 || dot(way, pass_.axes->to[i]) > 0;
}

// Up its own axis from where the move before such a series ended: the flutes stood there, and all
// that they sweep anew is above their top, but for as much as they go aside, which is no contact.
bool AxesCheck::backs_out(std::size_t i) const {
  if (!bodies_.widest_at_top()) return false;
  double aside_mm = 0;
  std::size_t begin = i + 1;
  for (; begin > 0 && path_.moves[begin - 1].kind == MoveKind::rapid; --begin) {
    const Vec3 &axis = axis_from(*pass_.axes, begin - 1), &axis_to = pass_.axes->to[begin - 1];
    const Vec3 way = path_.moves[begin - 1].to - move_from(path_, begin - 1);
    const double up_mm = dot(way, axis), turn = length(cross(axis, axis_to));
    if (up_mm < 0 || turn > 0) break;
    aside_mm += length(way - axis * up_mm);
  }
  if (begin == 0 || begin > i || aside_mm > limits_.slightest_mm()) return false;
  const Vec3 &tip = move_from(path_, begin), &axis = axis_from(*pass_.axes, begin);
  const model::Box3 box = bounding_box(solids_.front().solid.raw());
  const double top_mm = dot(box.centre() - tip, axis) + support(box.size() * 0.5, axis);
  return bodies_.flutes.profile.length() >= top_mm;
}

void AxesCheck::look_above_flutes(const Turning& m, std::vector<Finding>& findings) const {
  const std::size_t end = rises(m.move) ? m.move : m.move + 1;
  for (const ToolBody& body : bodies_.over_flutes)
    look_for_part(FindingKind::below_flutes, m, body, findings);
  for (const ToolBody& body : bodies_.above) {
    if (!bodies_.is_wide(body)) continue;
    const bool shank = body.part == ToolPart::shank;
    const bool touches = look_for_part(
        shank ? FindingKind::shank_in_stock : FindingKind::holder_in_stock, m, body, findings);
    if (!touches && body.profile.largest_radius() > bodies_.top_radius_mm + limits_.tolerance_mm)
      look_near(m, body, 0, end, 0, 1, findings);
  }
}

void AxesCheck::look_at_fixtures(const Turning& m, std::vector<Finding>& findings) const {
  for (std::size_t k = 1; k < solids_.size(); ++k)
    for (const ToolBody& body : bodies_.parts())
      if (!look_for(FindingKind::fixture_touched, m, body, k, 0, findings))
        look_near(m, body, k, 0, 0, 1, findings);
}

// As the tool stands at either end: how far it goes down its own axis, against how far across.
bool AxesCheck::descends_too_steeply(std::size_t i) const {
  const double steepest = pass_.cutter.steepest_descent_deg;
  if (steepest >= 90 || path_.moves[i].kind != MoveKind::feed) return false;
  const Vec3 way = path_.moves[i].to - move_from(path_, i);
  const auto steep = [&](const Vec3& axis) {
    const double down = -dot(way, axis), across = length(way + axis * down);
    return down > across * std::tan(model::radians(steepest)) + kDropRounding_mm;
  };
  return steep(axis_from(*pass_.axes, i)) || steep(pass_.axes->to[i]);
}

}  // namespace limitgauge::simulator
