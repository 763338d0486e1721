#include "model/gcode/cycles/cutter_compensation.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "model/base/tolerance.h"
#include "model/gcode/cycles/cutter_compensation_plane.h"

namespace limitgauge::model::gcode {

CutterCompensation::CutterCompensation(Out out, Place place)
    : place_(place), queue_(std::move(out), std::move(place)) {}

void CutterCompensation::begin(CompensationSide side, double radius_mm, ArcPlane plane,
                               const Vec3& position_mm, CompensationStyle style) {
  if (plane == ArcPlane::yz) throw std::invalid_argument("cutter compensation in G19");
  if (active()) throw std::logic_error("cutter compensation begins while it is on");
  side_ = (side == CompensationSide::left) == (radius_mm >= 0) ? 1 : -1;
  radius_mm_ = std::abs(radius_mm);
  frame_ = PlaneFrame(plane);
  style_ = style;
  programmed_mm_ = position_mm;
  stage_ = Stage::entering;
}

void CutterCompensation::end() {
  flush();
  if (stage_ == Stage::following) just_left_ = true;
  stage_ = Stage::off;
}

void CutterCompensation::flush() {
  if (stage_ != Stage::following && stage_ != Stage::entered) return;
  stage_ = Stage::following;
  queue_.release_at(frame_, beside_mm_);
  queue_.release();
}

void CutterCompensation::move(const Motion& motion) {
  const bool is_arc = motion.kind == MotionKind::arc;
  if (is_arc && just_left_)
    fail(motion, "an arc right after cutter compensation", "a straight move after G40");
  const bool is_named = std::exchange(place_is_named_, false);
  if (just_left_ && style_ != CompensationStyle::linuxcnc && !is_named &&
      frame_.flat(motion.to) == end_mm())
    return pass_beside(motion);
  just_left_ = false;
  if (!active() || radius_mm_ == 0) {
    queue_.pass(motion);
  } else if (stage_ == Stage::entering) {
    enter(motion);
  } else {
    is_arc ? follow_arc(motion) : follow_straight(motion);
  }
  programmed_mm_ = motion.to;
}

/// No way in the plane after G40: the tool stays beside the contour.
void CutterCompensation::pass_beside(Motion motion) {
  programmed_mm_ = motion.to;
  motion.to = frame_.lifted(beside_mm_, motion.to);
  queue_.pass(motion);
}

void CutterCompensation::follow_straight(const Motion& motion) {
  const Vec2 way = frame_.flat(motion.to) - end_mm();
  if (way == Vec2{}) return push_straight(motion, way, beside_mm_);
  const Vec2 after = unit(way);
  const Vec2 offset = side_ * radius_mm_ * quarter_turn(after);
  go_to_corner(motion, after, end_mm() + offset);
  beside_mm_ = frame_.flat(motion.to) + offset;
  push_straight(motion, after, beside_mm_);
}

void CutterCompensation::follow_arc(const Motion& motion) {
  const Vec2 centre = {motion.centre1, motion.centre2}, end = frame_.flat(motion.to);
  check_width(motion, length(centre - end));
  const double inwards = inside(motion) ? radius_mm_ : -radius_mm_;
  const Vec2 after = tangent_at_start(motion);
  go_to_corner(motion, after, end_mm() + inwards * unit(centre - end_mm()));
  beside_mm_ = end + inwards * unit(centre - end);
  push_arc(motion, beside_mm_, sweep_of(end_mm(), end, centre, motion.turns));
}

/// Back along the end of an arc that the tool went round outside of: by LinuxCNC it stays above
/// instead of going round the end.
Corner CutterCompensation::corner_to(const Motion& motion, Vec2 after) const {
  const bool is_arc = motion.kind == MotionKind::arc;
  const bool after_arc = !queue_.empty() && queue_.leading_arc();
  const bool over_arc = is_arc ? !inside(motion) : after_arc && !inside(*queue_.leading_arc());
  if (style_ == CompensationStyle::linuxcnc)
    return corner_of(direction(), after, side_, {kSmooth_rad, kSmooth_rad, over_arc});
  const double smooth_rad = is_arc || after_arc ? kTangentArc_rad : kStraightOn_rad;
  return corner_of(direction(), after, side_, {smooth_rad, kStraightOn_rad, over_arc});
}

void CutterCompensation::go_to_corner(const Motion& motion, Vec2 after, Vec2 to) {
  if (stage_ == Stage::entered) {
    stage_ = Stage::following;
    queue_.release_at(frame_, to);
    return queue_.starts_at(to);
  }
  switch (corner_to(motion, after)) {
    case Corner::smooth:
      queue_.release();
      // From beside the end of the motion before an arc might be one that turns almost wholly, or
      // hardly, and not the one that is programmed. LinuxCNC starts it there.
      if (style_ == CompensationStyle::linuxcnc || motion.kind != MotionKind::arc)
        return queue_.starts_at(beside_mm_);
      if (to != beside_mm_) pass_straight(motion, to);
      return queue_.starts_at(to);
    case Corner::outer:
      if (style_ == CompensationStyle::fanuc) return cut_corner(motion, after, to);
      if (motion.kind == MotionKind::arc)
        queue_.release();
      else
        queue_.release_at(frame_, beside_mm_);
      return round_corner(motion, to);
    case Corner::inner:
      queue_.release_at(frame_, corner_before(motion, after));
  }
}

void CutterCompensation::pass_straight(Motion motion, Vec2 to) {
  if (motion.kind == MotionKind::arc) {
    motion.kind = MotionKind::feed;
    motion.centre1 = motion.centre2 = motion.turns = 0;
  }
  motion.to = frame_.lifted(to, programmed_mm_);
  queue_.pass(motion);
}

/// A path that is straight itself goes on to the corner; an arc ends beside its end.
void CutterCompensation::cut_corner(const Motion& motion, Vec2 after, Vec2 to) {
  const auto [first, second] = outer_corner(direction(), after, beside_mm_, to, radius_mm_);
  const bool goes_on = !queue_.empty() && !queue_.leading_arc();
  queue_.release_at(frame_, goes_on ? first : beside_mm_);
  queue_.release();
  if (!goes_on) pass_straight(motion, first);
  if (second != first) pass_straight(motion, second);
  const bool is_arc = motion.kind == MotionKind::arc;
  if (is_arc) pass_straight(motion, to);
  queue_.starts_at(is_arc ? to : second);
}

/// Round the corner that the contour has come to, at its height; a rapid cannot and goes straight.
void CutterCompensation::round_corner(const Motion& motion, Vec2 to) {
  Motion corner = motion;
  corner.to = frame_.lifted(to, programmed_mm_);
  if (corner.kind != MotionKind::rapid) {
    corner.kind = MotionKind::arc;
    corner.plane = frame_.plane();
    corner.centre1 = end_mm().x;
    corner.centre2 = end_mm().y;
    corner.turns = -side_;
  }
  queue_.release();
  queue_.pass(corner);
  queue_.starts_at(to);
}

Vec2 CutterCompensation::tangent_at_start(const Motion& arc) const {
  const Vec2 inwards = unit(Vec2{arc.centre1, arc.centre2} - end_mm());
  return (arc.turns > 0 ? -1.0 : 1.0) * quarter_turn(inwards);
}

void CutterCompensation::push_straight(Motion motion, Vec2 direction, Vec2 end) {
  motion.to = frame_.lifted(end, motion.to);
  queue_.push(frame_, {motion, direction, 0});
}

void CutterCompensation::push_arc(Motion arc, Vec2 end, double sweep) {
  arc.to = frame_.lifted(end, arc.to);
  queue_.push(frame_, {arc, {}, sweep});
}

void CutterCompensation::fail(const Motion& motion, const std::string& wrong,
                              const std::string& expected) const {
  throw InputError(place_(motion.line), wrong, expected);
}

namespace {

std::string mm(double value_mm) {
  return six_digits(value_mm) + " mm";
}

}  // namespace

void CutterCompensation::check_entry(const Motion& motion) const {
  const double length_mm = length(frame_.flat(motion.to) - end_mm());
  if (length_mm <= radius_mm_)
    fail(motion,
         "the entry into cutter compensation is " + mm(length_mm) +
             " long in its plane, the cutter's radius " + mm(radius_mm_),
         "an entry longer than the radius");
}

void CutterCompensation::check_width(const Motion& arc, double arc_radius_mm) const {
  if (inside(arc) && arc_radius_mm <= radius_mm_)
    fail(arc,
         "an arc of " + mm(arc_radius_mm) +
             " radius around the inside of which the cutter goes, whose radius is " +
             mm(radius_mm_),
         "an arc wider than the cutter");
}

void CutterCompensation::enter(const Motion& motion) {
  const bool is_arc = motion.kind == MotionKind::arc;
  if (style_ != CompensationStyle::linuxcnc) {
    if (is_arc)
      fail(motion, "an arc as the entry into cutter compensation", "a straight move that enters");
    // Nothing is beside anything yet.
    if (frame_.flat(motion.to) == end_mm()) return queue_.pass(motion);
    stage_ = Stage::entered;
    return enter_straight(motion);
  }
  stage_ = Stage::following;
  check_entry(motion);
  is_arc ? enter_arc(motion) : enter_straight(motion);
}

/// To the side of its end. LinuxCNC keeps no direction for the check of what was cut short: the
/// entry is longer than the radius, and its end may be pulled back to any place beside it.
void CutterCompensation::enter_straight(const Motion& motion) {
  const Vec2 end = frame_.flat(motion.to);
  const Vec2 normal = side_ * quarter_turn(unit(end - end_mm()));
  queue_.starts_at(end_mm());
  beside_mm_ = end + radius_mm_ * normal;
  // Of an entry whose end the next motion says nothing is too short.
  push_straight(motion, style_ != CompensationStyle::linuxcnc ? Vec2{} : normal, beside_mm_);
}

/// From where the tool is to the side of the programmed end, tangent to the programmed arc there:
/// the centre moves along the radius at the end until both ends are equally far from it.
void CutterCompensation::enter_arc(const Motion& motion) {
  const Vec2 start = end_mm(), end = frame_.flat(motion.to);
  const Vec2 programmed_centre = {motion.centre1, motion.centre2};
  check_width(motion, length(programmed_centre - start));
  const Vec2 inwards = unit(programmed_centre - end);
  beside_mm_ = end + (inside(motion) ? radius_mm_ : -radius_mm_) * inwards;
  const Vec2 chord = start - beside_mm_;
  const double cosine = dot(unit(chord), inwards);
  const double reach_mm = length(chord) / 2;
  if (std::abs(cosine) < std::max(kStraight, reach_mm / kLargestCoordinateMm))
    fail(motion, "an entry arc that cutter compensation bends into a straight line",
         "an arc that starts away from the tangent beside its end");
  const Vec2 centre = beside_mm_ + (reach_mm / cosine) * inwards;
  Motion arc = motion;
  arc.centre1 = centre.x;
  arc.centre2 = centre.y;
  push_arc(arc, beside_mm_, sweep_of(start, beside_mm_, centre, arc.turns));
}

namespace {

Vec2 centre_of(const Motion& arc) {
  return {arc.centre1, arc.centre2};
}

/// The path of a compensated arc.
OffsetArc path_of(const Motion& arc, const PlaneFrame& frame, bool tool_inside) {
  return {centre_of(arc), length(frame.flat(arc.to) - centre_of(arc)), tool_inside};
}

constexpr const char* kWiderCorner = "a corner that the cutter fits into";

}  // namespace

Vec2 CutterCompensation::corner_before(const Motion& motion, Vec2 after) const {
  return motion.kind == MotionKind::arc ? corner_before_arc(motion)
                                        : corner_before_line(motion, after);
}

Vec2 CutterCompensation::corner_before_line(const Motion& line, Vec2 after) const {
  const std::optional<Motion>& arc = queue_.leading_arc();
  if (!arc) return meet_lines(direction(), after, beside_mm_, radius_mm_);
  const OffsetArc path = path_of(*arc, frame_, inside(*arc));
  const double arc_radius_mm = path.radius_mm + (path.tool_inside ? radius_mm_ : -radius_mm_);
  const Vec2 normal = side_ * quarter_turn(after);
  const double centre_mm = arc_radius_mm * dot(unit(path.centre - end_mm()), normal);
  const auto met = meet_line_and_arc(path, after, normal, radius_mm_ - centre_mm, true);
  if (!met)
    fail(line, "the cutter does not fit between the arc before and this straight move",
         kWiderCorner);
  return *met;
}

Vec2 CutterCompensation::corner_before_arc(const Motion& arc) const {
  if (const auto& before = queue_.leading_arc()) return corner_of_arcs(*before, arc);
  const double arc_radius_mm = length(centre_of(arc) - frame_.flat(arc.to));
  const bool tool_inside = inside(arc);
  const OffsetArc path = {centre_of(arc), arc_radius_mm + (tool_inside ? -radius_mm_ : radius_mm_),
                          tool_inside};
  const double centre_mm = arc_radius_mm * dot(unit(path.centre - end_mm()), normal());
  const auto met = meet_line_and_arc(path, direction(), normal(), radius_mm_ - centre_mm, false);
  if (!met)
    fail(arc, "the cutter does not fit between the straight move before and this arc",
         kWiderCorner);
  return *met;
}

Vec2 CutterCompensation::corner_of_arcs(const Motion& before, const Motion& arc) const {
  const OffsetArc first = path_of(before, frame_, inside(before));
  const double arc_radius_mm = length(centre_of(arc) - frame_.flat(arc.to));
  const OffsetArc second = {centre_of(arc),
                            arc_radius_mm + (inside(arc) ? -radius_mm_ : radius_mm_), inside(arc)};
  if (first.centre == second.centre)
    fail(arc, "an inner corner between two arcs of one centre with cutter compensation",
         "arcs about different centres");
  const auto met = meet_arcs(first, second, arc.turns > 0);
  if (!met) fail(arc, "the cutter does not fit between the arc before and this arc", kWiderCorner);
  return *met;
}

}  // namespace limitgauge::model::gcode
