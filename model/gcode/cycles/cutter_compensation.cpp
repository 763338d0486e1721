#include "model/gcode/cycles/cutter_compensation.h"

#include <stdexcept>
#include <utility>

#include "model/gcode/cycles/cutter_compensation_corner.h"

namespace limitgauge::model::gcode {

CutterCompensation::CutterCompensation(Out out, Place place)
    : place_(place), queue_(std::move(out), std::move(place)) {}

void CutterCompensation::begin(CompensationSide side, double radius_mm, ArcPlane plane,
                               const Vec3& position_mm) {
  if (plane == ArcPlane::yz) throw std::invalid_argument("cutter compensation in G19");
  if (active()) throw std::logic_error("cutter compensation begins while it is on");
  side_ = (side == CompensationSide::left) == (radius_mm >= 0) ? 1 : -1;
  radius_mm_ = std::abs(radius_mm);
  frame_ = PlaneFrame(plane);
  programmed_mm_ = position_mm;
  stage_ = Stage::entering;
}

void CutterCompensation::end() {
  if (stage_ == Stage::following) {
    flush();
    just_left_ = true;
  }
  stage_ = Stage::off;
}

void CutterCompensation::flush() {
  if (stage_ != Stage::following) return;
  queue_.release_at(frame_, beside_mm_);
  queue_.release();
}

void CutterCompensation::move(const Motion& motion) {
  const bool is_arc = motion.kind == MotionKind::arc;
  if (is_arc && just_left_)
    fail(motion, "an arc right after cutter compensation", "a straight move after G40");
  just_left_ = false;
  if (!active() || radius_mm_ == 0) {
    queue_.pass(motion);
  } else if (stage_ == Stage::entering) {
    is_arc ? enter_arc(motion) : enter_straight(motion);
    stage_ = Stage::following;
  } else {
    is_arc ? follow_arc(motion) : follow_straight(motion);
  }
  programmed_mm_ = motion.to;
}

void CutterCompensation::follow_straight(const Motion& motion) {
  const PlaneVector way = frame_.flat(motion.to) - end_mm();
  if (way == PlaneVector{}) return push_straight(motion, way, beside_mm_);
  const PlaneVector after = unit(way);
  const PlaneVector offset = side_ * radius_mm_ * quarter_turn(after);
  // Back along the end of an arc that the tool went round outside of: by LinuxCNC it stays above
  // instead of going round the end.
  const bool over_arc = !queue_.empty() && queue_.leading_arc() && !inside(*queue_.leading_arc());
  switch (corner_of(direction(), after, side_, over_arc)) {
    case Corner::smooth:
      queue_.release();
      queue_.starts_at(beside_mm_);
      break;
    case Corner::outer:
      queue_.release_at(frame_, beside_mm_);
      round_corner(motion, end_mm() + offset);
      break;
    case Corner::inner:
      queue_.release_at(frame_, corner_before_line(motion, after));
  }
  beside_mm_ = frame_.flat(motion.to) + offset;
  push_straight(motion, after, beside_mm_);
}

void CutterCompensation::follow_arc(const Motion& motion) {
  const PlaneVector centre = {motion.centre1, motion.centre2}, end = frame_.flat(motion.to);
  check_width(motion, length(centre - end));
  const double inwards = inside(motion) ? radius_mm_ : -radius_mm_;
  const PlaneVector after = tangent_at_start(motion);
  switch (corner_of(direction(), after, side_, !inside(motion))) {
    case Corner::smooth:
      queue_.release();
      queue_.starts_at(beside_mm_);
      break;
    case Corner::outer:
      queue_.release();
      round_corner(motion, end_mm() + inwards * unit(centre - end_mm()));
      break;
    case Corner::inner:
      queue_.release_at(frame_, corner_before_arc(motion));
  }
  beside_mm_ = end + inwards * unit(centre - end);
  push_arc(motion, beside_mm_, sweep_of(end_mm(), end, centre, motion.turns));
}

/// Round the corner that the contour has come to, at its height; a rapid cannot and goes straight.
void CutterCompensation::round_corner(const Motion& motion, PlaneVector to) {
  Motion corner = motion;
  corner.to = frame_.lifted(to, programmed_mm_);
  if (corner.kind != MotionKind::rapid) {
    corner.kind = MotionKind::arc;
    corner.plane = frame_.plane();
    corner.centre1 = end_mm().a;
    corner.centre2 = end_mm().b;
    corner.turns = -side_;
  }
  queue_.release();
  queue_.pass(corner);
  queue_.starts_at(to);
}

PlaneVector CutterCompensation::tangent_at_start(const Motion& arc) const {
  const PlaneVector inwards = unit(PlaneVector{arc.centre1, arc.centre2} - end_mm());
  return (arc.turns > 0 ? -1.0 : 1.0) * quarter_turn(inwards);
}

void CutterCompensation::push_straight(Motion motion, PlaneVector direction, PlaneVector end) {
  motion.to = frame_.lifted(end, motion.to);
  queue_.push(frame_, {motion, direction, 0});
}

void CutterCompensation::push_arc(Motion arc, PlaneVector end, double sweep) {
  arc.to = frame_.lifted(end, arc.to);
  queue_.push(frame_, {arc, {}, sweep});
}

void CutterCompensation::fail(const Motion& motion, const std::string& wrong,
                              const std::string& expected) const {
  throw InputError(place_(motion.line), wrong, expected);
}

}  // namespace limitgauge::model::gcode
